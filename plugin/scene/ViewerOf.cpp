#include "scene/ViewerOf.h"

#include "scene/OgreMath.h"

#include <Eigen/LU>

#include <OgreCamera.h>

namespace Lixel {

ShadowViewer viewerOf(const Ogre::Camera& camera, Vec3& wsOrigin) {
    // The matrix of the camera itself: without the argument it is the culling frustum's, if any.
    const Mat4 view = toDouble(Ogre::Matrix4(camera.getViewMatrix(true)));
    const Mat3 rotation = view.topLeftCorner<3, 3>();
    // A plain camera's position is exact; the view matrix' translation is rounded at the scale of
    // the world. Reflected cameras and custom view matrices have no other.
    const bool plain = !camera.isReflected() && !camera.isCustomViewMatrixEnabled();
    wsOrigin = plain ? toDouble(camera.getDerivedPosition())
                     : Vec3(-rotation.inverse() * view.topRightCorner<3, 1>());
    ShadowViewer viewer;
    viewer.viewFromWorld.topLeftCorner<3, 3>() = rotation;
    viewer.clipFromView = toDouble(camera.getProjectionMatrix());
    return viewer;
}

} // namespace Lixel
