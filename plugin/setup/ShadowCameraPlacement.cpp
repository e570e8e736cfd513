#include "setup/ShadowCameraPlacement.h"

#include "scene/OgreMath.h"

#include <Eigen/LU>

#include <OgreCamera.h>
#include <OgreLight.h>
#include <OgreSceneNode.h>

#include <cmath>

namespace Lixel {
namespace {

/// A float's exponents end at 2⁻¹²⁶: what is multiplied on the way to a determinant like this, or
/// like its inverse, is well within.
constexpr double GreatestDeterminant = 0x1p96;

/** The unit of length in which the shadow camera sees, in world units: 1 except in worlds of some
    10⁹ units and more, or 10⁻⁹ and less.

    OGRE inverts the projection in floats, and asserts that the result is a number. The determinant
    of a sun's projection is proportional to 1 / (map's volume), so it may leave the range of
    floats. The unit is a power of two: projection * view stays the same to the last bit. */
double unitOf(const ShadowFit& fit) {
    const double determinant = std::abs(fit.clipFromLight.determinant());
    const bool isFar = determinant > GreatestDeterminant || determinant < 1.0 / GreatestDeterminant;
    if (!isFar || !fit.hasMap()) return 1.0;
    return std::exp2(std::round(-std::log2(determinant) / 3.0));
}

/** Near and far distance of the shadow camera.

    The matrices do not use them, but casters and receivers of others may. A sun's camera stands at
    the viewer, with casters behind it: there is no distance to give. Without a map the far
    distance is very large, so that the cleared (white) texture means beyond everything. The far
    distance is never 0: the octree would skip the test of the far plane. */
Vec2 clipDistances(const ShadowFit& fit) {
    constexpr double Endless = 1e9;
    if (!fit.hasMap()) return {1.0, Endless};
    const bool isLocal = !fit.directional && fit.lsNear > 0.0 && fit.lsFar > fit.lsNear;
    return isLocal ? Vec2(fit.lsNear, fit.lsFar) : Vec2(1.0, 2.0);
}

/** The orientation of a camera that looks along a direction, upright as those of OGRE's own setups.

    The view matrix does not use it, but billboards and particles face by it. The light image's axes
    are no substitute: they are turned about the direction to suit the map, and billboards would be
    turned with them. */
Ogre::Quaternion orientationAlong(const Vec3& wsDirection) {
    constexpr double Steep = 0.999; // 2.6 degrees
    const Vec3 back = -wsDirection;
    const Vec3 up = std::abs(back.y()) < Steep ? Vec3::UnitY() : Vec3::UnitZ();
    const Vec3 right = up.cross(back).normalized();
    Mat3 axes;
    axes << right, back.cross(right), back;
    return toOgre(Eigen::Quaterniond(axes));
}

} // namespace

ShadowLight shadowLightOf(const Ogre::Light& light, const Ogre::Camera& viewer,
                          const Vec3& wsOrigin) {
    ShadowLight result;
    switch (light.getType()) {
    case Ogre::Light::LT_DIRECTIONAL:
        result.kind = LightKind::Directional;
        break;
    case Ogre::Light::LT_SPOTLIGHT:
        result.kind = LightKind::Spot;
        break;
    default: // rectangles too, which OGRE has since 14: as if all of their light came from the
             // middle
        result.kind = LightKind::Point;
        break;
    }
    result.wsDirection = toDouble(light.getDerivedDirection());
    result.wsPosition = toDouble(light.getDerivedPosition()) - wsOrigin;
    result.outerHalfAngle = light.getSpotlightOuterAngle().valueRadians() / 2.0;
    result.nearDistance = light._deriveShadowNearClipDistance(&viewer);
    result.range = light.getAttenuationRange();
    return result;
}

void placeShadowCamera(Ogre::Camera& camera, const ShadowFit& fit, const Vec3& wsOrigin) {
    // With camera-relative rendering OGRE subtracts the camera's position and drops the view
    // matrix' translation: the camera stands where the fit has its eye, so both are exact.
    const Vec3 wsEye = wsOrigin + fit.wsEye;
    if (Ogre::SceneNode* const node = camera.getParentSceneNode()) {
        node->setPosition(toOgre(wsEye));
        node->setOrientation(orientationAlong(-fit.lsFromWs.row(2)));
    }
    const double unit = unitOf(fit);
    Mat4 view = Mat4::Identity();
    view.topLeftCorner<3, 3>() = fit.lsFromWs / unit;
    view.topRightCorner<3, 1>() = -fit.lsFromWs * wsEye / unit;
    camera.setCustomViewMatrix(true, Ogre::Affine3(toOgre(view)));
    Mat4 clipFromView = fit.clipFromLight;
    clipFromView.leftCols<3>() *= unit;
    camera.setCustomProjectionMatrix(true, toOgre(clipFromView));
    const Vec2 clip = clipDistances(fit) / unit;
    camera.setNearClipDistance(static_cast<Ogre::Real>(clip[0]));
    camera.setFarClipDistance(static_cast<Ogre::Real>(clip[1]));
}

} // namespace Lixel
