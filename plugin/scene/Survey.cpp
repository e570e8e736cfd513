#include "scene/Survey.h"

#include "scene/OgreMath.h"

#include <Eigen/LU>

#include <OgreCamera.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

namespace Lixel {
void Survey::take(const Ogre::Camera& viewer, const Ogre::Viewport& viewport) {
    mRules = SceneRules(viewer, viewport);
    mCasters.clear();
    mReceivers.clear();
    mUnboundedName.clear();
    mObjectCount = 0;

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

    visit(*mRules.sceneManager().getRootSceneNode());
}

void Survey::visit(Ogre::SceneNode& node) {
    for (Ogre::MovableObject* object : node.getAttachedObjects())
        visit(*object);
    for (Ogre::Node* child : node.getChildren())
        visit(static_cast<Ogre::SceneNode&>(*child));
}

void Survey::visit(Ogre::MovableObject& object) {
    if (!mRules.draws(object)) return;
    ++mObjectCount;
    const Ogre::AxisAlignedBox& bounds = object.getWorldBoundingBox();
    if (bounds.isNull()) return;

    const bool casts = mRules.casts(object);
    if (bounds.isInfinite()) {
        const bool received = mRules.receives(object);
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
    if (mView.classify(box) != ConvexVolume::Side::Outside && mRules.receives(object))
        mReceivers.add(box);
}

} // namespace Lixel
