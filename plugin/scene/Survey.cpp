#include "scene/Survey.h"

#include "scene/OgreMath.h"

#include <Eigen/LU>

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreRenderQueue.h>
#include <OgreRenderQueueSortingGrouping.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>

namespace Lixel {
namespace {

/// Cameras and lights are attached to nodes like objects, but are not drawn.
bool isDrawn(const Ogre::MovableObject& object) {
    return (object.getTypeFlags() &
            (Ogre::SceneManager::FRUSTUM_TYPE_MASK | Ogre::SceneManager::LIGHT_TYPE_MASK)) == 0;
}

/// Whether the object is too far from the viewer to be drawn, as
/// MovableObject::_notifyCurrentCamera decides; that function itself would change the object's
/// state and fire its listeners.
bool isBeyondRenderingDistance(const Ogre::MovableObject& object, const Ogre::Camera& camera) {
    const Ogre::Real distance = object.getRenderingDistance();
    if (!(distance > 0) || !camera.getUseRenderingDistance() || object.getParentNode() == nullptr)
        return false;
    // The radius is the sphere's, scaled by the node as OGRE scales it.
    const Ogre::Vector3& scale = object.getParentNode()->_getDerivedScale();
    const Ogre::Real factor = std::max({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)});
    const Ogre::Real reach = distance + object.getBoundingRadius() * factor;
    return object.getParentNode()->getSquaredViewDepth(camera.getLodCamera()) > reach * reach;
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
    if (!isDrawn(object) || !object.getVisible() ||
        (object.getVisibilityFlags() & mVisibilityMask) == 0)
        return;
    ++mObjectCount;
    const Ogre::AxisAlignedBox& bounds = object.getWorldBoundingBox();
    if (bounds.isNull() || isBeyondRenderingDistance(object, *mCamera)) return;

    const bool casts = object.getCastShadows();
    const auto receives = [&] {
        return (mCastersReceive || !casts) &&
               mSceneManager->getRenderQueue()
                   ->getQueueGroup(object.getRenderQueueGroup())
                   ->getShadowsEnabled() &&
               object.getReceivesShadows();
    };
    if (bounds.isInfinite()) {
        const bool received = receives();
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
    if (mView.classify(box) != ConvexVolume::Side::Outside && receives()) mReceivers.add(box);
}

} // namespace Lixel
