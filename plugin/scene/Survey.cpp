#include "scene/Survey.h"

#include "scene/OgreMath.h"

#include <Eigen/LU>

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreInstancedEntity.h>
#include <OgreRenderQueue.h>
#include <OgreRenderQueueSortingGrouping.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>

#include <algorithm>

namespace Lixel {
namespace {

/// Whether an object is more than a place for others: cameras and lights are attached to nodes too,
/// and instances, which their batch draws.
bool isDrawn(const Ogre::MovableObject& object) {
    constexpr Ogre::uint32 WithoutFactory = ~Ogre::uint32{0};
    switch (object.getTypeFlags()) {
    case Ogre::SceneManager::FRUSTUM_TYPE_MASK:
    case Ogre::SceneManager::LIGHT_TYPE_MASK:
        return false;
    case WithoutFactory: // terrain, batches, instances, an application's own
        return dynamic_cast<const Ogre::InstancedEntity*>(&object) == nullptr;
    default:
        return true;
    }
}

/// Whether the object is too far from `lodCamera` to be drawn, as
/// MovableObject::_notifyCurrentCamera decides; that function itself would change the object's
/// state and fire its listeners.
bool isBeyondRenderingDistance(const Ogre::MovableObject& object, const Ogre::Camera& lodCamera) {
    const Ogre::Node* const node = object.getParentNode();
    // The radius is the sphere's, scaled by the node as OGRE scales it.
    const Ogre::Vector3& scale = node->_getDerivedScale();
    const Ogre::Real factor = std::max({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)});
    const Ogre::Real reach = object.getRenderingDistance() + object.getBoundingRadius() * factor;
    return node->getSquaredViewDepth(&lodCamera) > reach * reach;
}

/// Whether something on the object's bones receives, which is drawn with it but is on no node.
template <typename Receives>
bool attachmentReceives(const Ogre::MovableObject& object, const Receives& receives) {
    const auto* const entity = dynamic_cast<const Ogre::Entity*>(&object);
    if (entity == nullptr) return false;
    const auto& attached = entity->getAttachedObjects();
    return std::any_of(attached.begin(), attached.end(), [&](Ogre::MovableObject* child) {
        return child->getVisible() && receives(*child);
    });
}

} // namespace

void Survey::take(const Ogre::Camera& viewer, const Ogre::Viewport& viewport) {
    mCasters.clear();
    mReceivers.clear();
    mUnboundedName.clear();
    mObjectCount = 0;

    mCamera = &viewer;
    mSceneManager = viewer.getSceneManager();
    mVisibilityMask = viewport.getVisibilityMask() & mSceneManager->getVisibilityMask();
    mCastersReceive = mSceneManager->getShadowTextureSelfShadow();

    // The matrix of the camera itself: without the argument it is the culling frustum's, if any.
    const Mat4 view = toDouble(Ogre::Matrix4(viewer.getViewMatrix(true)));
    const Mat3 rotation = view.topLeftCorner<3, 3>();
    // A plain camera's position is exact; the view matrix' translation is rounded at the scale of
    // the world. Reflected cameras and custom view matrices have no other.
    const bool plain = !viewer.isReflected() && !viewer.isCustomViewMatrixEnabled();
    mWsOrigin = plain ? toDouble(viewer.getDerivedPosition())
                      : Vec3(-rotation.inverse() * view.topRightCorner<3, 1>());
    mViewer.viewFromWorld = Mat4::Identity();
    mViewer.viewFromWorld.topLeftCorner<3, 3>() = rotation;
    mViewer.clipFromView = toDouble(viewer.getProjectionMatrix());
    mView = viewVolume(mViewer);

    visit(*mSceneManager->getRootSceneNode());
}

void Survey::visit(Ogre::SceneNode& node) {
    for (Ogre::MovableObject* object : node.getAttachedObjects())
        visit(*object);
    for (Ogre::Node* child : node.getChildren())
        visit(static_cast<Ogre::SceneNode&>(*child));
}

void Survey::visit(Ogre::MovableObject& object) {
    // getVisible() is the object's own flag; isVisible() would answer for the last camera drawn.
    if (!object.getVisible() || (object.getVisibilityFlags() & mVisibilityMask) == 0 ||
        !isDrawn(object))
        return;
    ++mObjectCount;
    const Ogre::AxisAlignedBox& bounds = object.getWorldBoundingBox();
    if (bounds.isNull()) return;

    bool casts = object.getCastShadows();
    bool withinDistance = true;
    if (object.getRenderingDistance() > 0 && mCamera->getUseRenderingDistance()) {
        // OGRE makes the viewer the level of detail camera of shadow cameras, whatever its own is.
        casts = casts && !isBeyondRenderingDistance(object, *mCamera);
        withinDistance = !isBeyondRenderingDistance(object, *mCamera->getLodCamera());
    }
    if (bounds.isInfinite()) {
        const bool received = withinDistance && receives(object);
        if (casts) mCasters.addUnbounded();
        if (received) mReceivers.addUnbounded();
        if ((casts || received) && mUnboundedName.empty()) mUnboundedName = object.getName();
        return;
    }
    const Vec3 lower = toDouble(bounds.getMinimum()) - mWsOrigin;
    const Vec3 upper = toDouble(bounds.getMaximum()) - mWsOrigin;
    const Box box{(lower + upper) / 2.0, (upper - lower) / 2.0};
    if (casts) mCasters.add(box);
    // Asking the materials is the dearest question, so it comes last.
    if (withinDistance && mView.classify(box) != ConvexVolume::Side::Outside && receives(object))
        mReceivers.add(box);
}

bool Survey::receives(Ogre::MovableObject& object) const {
    const auto asked = [this](Ogre::MovableObject& body) {
        return (mCastersReceive || !body.getCastShadows()) && body.getReceivesShadows();
    };
    return mSceneManager->getRenderQueue()
               ->getQueueGroup(object.getRenderQueueGroup())
               ->getShadowsEnabled() &&
           (asked(object) || attachmentReceives(object, asked));
}

} // namespace Lixel
