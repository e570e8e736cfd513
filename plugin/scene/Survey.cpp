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

/// A mesh that reaches out of the view, whose middle is nearer to the viewer than this many of its
/// radii, fills much of the picture, and little of its hull may be in it.
constexpr double PartsRadii = 3.0;

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
    return box.centre.squaredNorm() < NearRadii * NearRadii * box.halfExtents.squaredNorm() &&
           box.halfExtents.minCoeff() > Flatness * box.halfExtents.maxCoeff();
}

} // namespace

void Survey::take(const Ogre::Camera& viewer, const Ogre::Viewport& viewport, double shadowDistance,
                  double margin, std::size_t parts) {
    mMeshes.beginPicture(Ogre::Root::getSingleton().getNextFrameNumber());
    mRules = SceneRules(viewer, viewport);
    mReceivers.clear();
    mSurfaces.clear();
    mReceiverObjects.clear();
    mVisiblePoints.clear();
    mWholes.clear();
    mSurfacesOfWholes.clear();
    mSurfacesOfParts.clear();
    mMostParts = parts;
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
    if (!mSurfacesOfParts.empty())
        traceView(mViewer, mWholes, mSurfacesOfWholes, mSurfacesOfParts, mSampling, mVisiblePoints);
}

void Survey::forgetObjects() const {
    if (NodeStore* const store = findStore(mRules.sceneManager())) store->endReading();
}

void Survey::visit(const NodeWalk::Object& found) {
    Ogre::MovableObject& object = *found.object;
    const auto know = [&](unsigned bits) {
        if (SceneRules::canBeKnown(object, mStore, found.slot))
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
    mLower = mLower.cwiseMin(box.centre - box.halfExtents);
    mUpper = mUpper.cwiseMax(box.centre + box.halfExtents);
    if (mMostParts > 0 && addParts(object, box)) return;
    const std::size_t index = mReceivers.size();
    if (mMostParts > 0) mWholes.add(box);
    if (addWhole(object, box) && needsSurface(box)) addSurface(object, index);
}

bool Survey::addWhole(const Ogre::MovableObject& object, const Aabb& box) {
    const std::size_t before = mReceivers.size();
    const std::size_t unbounded = mReceivers.unbounded();
    mReceivers.add(box);
    // A box may be finite and too large to have bounds.
    if (mReceivers.unbounded() > unbounded && mUnboundedName.empty())
        mUnboundedName = object.getName();
    if (mReceivers.size() == before) return false;
    mReceiverShapes.add(object);
    mReceiverObjects.push_back(&object);
    return true;
}

void Survey::addSurface(const Ogre::MovableObject& object, std::size_t receiver) {
    const auto* const entity = dynamic_cast<const Ogre::Entity*>(&object);
    const SurfaceCloud* const cloud = entity != nullptr ? mMeshes.cloudOf(*entity) : nullptr;
    if (cloud == nullptr) return;
    mSurfaces.push_back(
        {receiver, cloud, relativeTransform(entity->_getParentNodeFullTransform(), mWsOrigin)});
    if (mMostParts == 0) return;
    mSurfacesOfWholes.push_back(mSurfaces.back());
    mSurfacesOfWholes.back().receiver = mWholes.size() - 1;
}

bool Survey::addParts(const Ogre::MovableObject& object, const Aabb& box) {
    if (!(box.centre.norm() < PartsRadii * box.halfExtents.norm()) ||
        mView.classify(box) != ConvexVolume::Side::Straddles)
        return false;
    const auto* const entity = dynamic_cast<const Ogre::Entity*>(&object);
    if (entity == nullptr) return false;
    const std::optional<KnownParts> parts = mMeshes.partsOf(*entity, mMostParts);
    if (!parts) return false;
    const Transform3 wsFromMesh =
        relativeTransform(entity->_getParentNodeFullTransform(), mWsOrigin);
    if (!wsFromMesh.matrix().allFinite()) return false;
    SelfShadowFree known;
    if (mMeshes.isSelfShadowFree(*entity, known)) {
        // Its sides and slopes are known: view rays meet its surface, and it is one receiver.
        addWhole(object, box);
        mSurfacesOfParts.push_back({0, parts->cloud, wsFromMesh});
        return true;
    }
    for (const Eigen::AlignedBox3f& bounds : parts->bounds) {
        const Aabb placed = boundsOf(bounds, wsFromMesh);
        if (mView.classify(placed) == ConvexVolume::Side::Outside) continue;
        const std::size_t before = mReceivers.size();
        mReceivers.add(placed);
        if (mReceivers.size() > before) mReceiverShapes.addPart(object);
    }
    mReceiverObjects.push_back(&object);
    mSurfacesOfParts.push_back({0, parts->cloud, wsFromMesh});
    return true;
}

} // namespace Lixel
