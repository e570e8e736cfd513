#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/** @defgroup LixelSetups Shadow camera setups
    What Light::setCustomShadowCameraSetup takes, and what is told of each map. */
/** @defgroup LixelTechniques Techniques
    What each technique does, and its options. */
/** @defgroup LixelFit Problems and fits
    What a fit is given and what it gives, without OGRE. */
/** @defgroup LixelMaterials Materials
    Parameters that materials bind. */
/** @defgroup LixelHeadless Headless rendering
    OGRE without a display server. */

/// Symbols that libLixel exports.
#define LIXEL_API __attribute__((visibility("default")))

namespace Lixel {
/// @addtogroup LixelFit
/// @{

// Eigen aligns some of its types as far as the compiler's flags allow, so that a structure would be
// laid out otherwise in a program that is built with -mavx than in this library. None of these is.
using Vec2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;
using Vec3 = Eigen::Matrix<double, 3, 1, Eigen::DontAlign>;
using Vec4 = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
using Mat3 = Eigen::Matrix<double, 3, 3, Eigen::DontAlign>;
using Mat4 = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;
/// Needs <Eigen/Geometry>.
using Transform3 = Eigen::Transform<double, 3, Eigen::Affine, Eigen::DontAlign>;

/// Whether a structure lies in memory alike whatever flags a compiler is given: nothing in it is
/// aligned further than a number is.
template <typename Structure>
inline constexpr bool HasOneLayout = alignof(Structure) <= alignof(double);

/// Greatest coordinate that is used. Beyond it a float's square overflows, and so do matrices: a
/// box counts as unbounded, and a light as having no position.
inline constexpr double GreatestExtent = 1e18;

/// An axis-aligned box as its centre and half extents; all half extents are >= 0.
struct Aabb {
    Vec3 centre = Vec3::Zero();
    Vec3 halfExtents = Vec3::Zero();
};

/// @}
} // namespace Lixel
