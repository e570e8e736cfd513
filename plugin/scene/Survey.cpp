#include "scene/Survey.h"

#include "fit/focus/ViewVolume.h"
#include "scene/OgreMath.h"
#include "scene/ViewerOf.h"

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreMovableObject.h>
#include <OgreRoot.h>
#include <OgreSubEntity.h>

#include <limits>
#include <typeinfo>

namespace Lixel {
namespace {

/// A box flatter than this is its own surface: a ground, a wall.
constexpr double Flatness = 1.0 / 32.0;

/// A viewer who is nearer to the box's middle than this many of its radii stands in it, or sees
/// little but it.
constexpr double NearRadii = 1.5;

/// How many objects ahead memory is asked for: the list of an entity's parts, then its first part.
constexpr std::size_t ListsAhead = 12;
constexpr std::size_t PartsAhead = 6;

void fetchAhead(std::span<const NodeWalk::Object> rest) {
    const auto entityAt = [&](std::size_t ahead) -> const Ogre::Entity* {
        if (ahead >= rest.size() || rest[ahead].known != 0) return nullptr;
        const Ogre::MovableObject& object = *rest[ahead].object;
        return typeid(object) == typeid(Ogre::Entity) ? static_cast<const Ogre::Entity*>(&object)
                                                      : nullptr;
    };
    if (const Ogre::Entity* const entity = entityAt(ListsAhead))
        __builtin_prefetch(entity->getSubEntities().data());
    if (const Ogre::Entity* const entity = entityAt(PartsAhead))
        if (!entity->getSubEntities().empty())
            prefetchObject(entity->getSubEntities().front(), sizeof(Ogre::SubEntity));
}

/// Whether the box may say too little of what the viewer, at the origin, sees of the body in it.
bool needsSurface(const Aabb& box) {
    return box.centre.squaredNorm() <
               NearRadii * NearRadii * box.halfExtents.squaredNorm() &&
           box.halfExtents.minCoeff() > Flatness * box.halfExtents.maxCoeff();
}

} // namespace

void Survey::take(const Ogre::Camera& viewer, const Ogre::Viewport& viewport, double shadowDistance,
                  double margin) {
    mMeshes.beginPicture(Ogre::Root::getSingleton().getNextFrameNumber());
    mRules = SceneRules(viewer, viewport);
    mReceivers.clear();
    mSurfaces.clear();
    mLower.setConstant(std::numeric_limits<double>::infinity());
    mUpper = -mLower;
    mUnboundedName.clear();
    mObjectCount = 0;

    mViewer = viewerOf(viewer, mWsOrigin);
    mReceiverShapes.reset(mMeshes, mWsOrigin);
    ShadowViewer reach = mViewer;
    reach.shadowDistance = shadowDistance;
    mView = viewVolume(widened(reach, margin));

    mBareParts.begin();
    mStore = findStore(mRules.sceneManager());
    if (mStore != nullptr) {
        mStore->endReading();
        mStore->beginReading(mRules.fingerprint());
    }
    const std::span<const NodeWalk::Object> found =
        mWalk.collect(mRules.sceneManager(), NodeCuller(mView, mWsOrigin));
    for (std::size_t i = 0; i < found.size(); ++i) {
        if ((found[i].known & NodeStore::ReceivesKnown) != 0) {
            visitKnown(found[i]);
        } else {
            fetchAhead(found.subspan(i));
            visit(found[i]);
        }
    }
}

void Survey::forgetObjects() const {
    if (NodeStore* const store = findStore(mRules.sceneManager())) store->endReading();
}

void Survey::visit(const NodeWalk::Object& found) {
    Ogre::MovableObject& object = *found.object;
    const auto know = [&](unsigned bits) {
        if (mRules.canBeKnown(object, mStore, found.slot))
            mStore->know(found.slot, NodeStore::ReceivesKnown | NodeStore::CastsKnown | bits);
    };
    if (!mRules.draws(object)) return know(0);
    ++mObjectCount;
    const Ogre::AxisAlignedBox& bounds = object.getWorldBoundingBox();
    if (bounds.isNull()) return;
    if (bounds.isInfinite()) {
        const bool receives = mRules.receives(object, mBareParts);
        if (receives) mReceivers.addUnbounded();
        if (mUnboundedName.empty() && (receives || mRules.casts(object)))
            mUnboundedName = object.getName();
        return;
    }
    const Aabb box = relativeBox(bounds, mWsOrigin);
    // Asking the materials takes longest, so it comes last.
    if (!found.touches && mView.classify(box) == ConvexVolume::Side::Outside) return;
    const bool receives = mRules.receives(object, mBareParts);
    know(NodeStore::Draws | (receives ? unsigned{NodeStore::Receives} : 0U) |
         (mRules.casts(object) ? unsigned{NodeStore::Casts} : 0U));
    if (receives) addReceiver(object, box);
}

void Survey::visitKnown(const NodeWalk::Object& found) {
    if ((found.known & NodeStore::Draws) == 0) return;
    ++mObjectCount;
    if ((found.known & NodeStore::Receives) != 0)
        addReceiver(*found.object, relativeBox(mStore->box(found.slot), mWsOrigin));
}

void Survey::addReceiver(const Ogre::MovableObject& object, const Aabb& box) {
    const std::size_t index = mReceivers.size();
    const std::size_t unbounded = mReceivers.unbounded();
    mReceivers.add(box);
    // A box may be finite and too large to have bounds.
    if (mReceivers.unbounded() > unbounded && mUnboundedName.empty())
        mUnboundedName = object.getName();
    if (mReceivers.size() > index) {
        mReceiverShapes.add(object);
        if (needsSurface(box)) addSurface(object, index);
    }
    mLower = mLower.cwiseMin(box.centre - box.halfExtents);
    mUpper = mUpper.cwiseMax(box.centre + box.halfExtents);
}

void Survey::addSurface(const Ogre::MovableObject& object, std::size_t receiver) {
    const auto* const entity = dynamic_cast<const Ogre::Entity*>(&object);
    const SurfaceCloud* const cloud = entity != nullptr ? mMeshes.cloudOf(*entity) : nullptr;
    if (cloud == nullptr) return;
    mSurfaces.push_back(
        {receiver, cloud, relativeTransform(entity->_getParentNodeFullTransform(), mWsOrigin)});
}

} // namespace Lixel
