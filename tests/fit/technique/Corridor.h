#pragma once

#include "fit/Problems.h"

/// What the formulas of perspective warps are stated for: receivers from a near to a far depth.
namespace Lixel::Test {

inline constexpr double NearDepth = 5.0;
inline constexpr double FarDepth = 45.0;

/// The viewer at the origin looks along -z at a beam that casts and receives, from NearDepth to
/// FarDepth, of the given half height around a height; wholly in view.
inline Scene corridor(const Vec3& lightDirection, double halfHeight = 1.0, double height = 0.0) {
    Scene scene;
    scene.size = FarDepth;
    scene.viewer.clipFromView = perspective(100.0 * Degree, 1.0, 0.1, 100.0);
    scene.light.wsDirection = lightDirection;
    scene.addBody({Vec3(0.0, height, -(NearDepth + FarDepth) / 2.0),
                   Vec3(1.0, halfHeight, (FarDepth - NearDepth) / 2.0)});
    return scene;
}

/// Row w at depth d in front of the viewer, relative to the viewer's own.
inline double denominatorAt(const ShadowFit& fit, double depth) {
    const Vec4 at = clipOf(fit.clipFromWorld, Vec3(0.0, 0.0, -depth));
    const Vec4 viewer = clipOf(fit.clipFromWorld, Vec3::Zero());
    return at.w() / viewer.w();
}

} // namespace Lixel::Test
