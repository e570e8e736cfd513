#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Symbols that libLixel exports.
#define LIXEL_API __attribute__((visibility("default")))

namespace Lixel {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;

/// Beyond it a float's square overflows, and matrices with it: a box has no bounds, a light no
/// place.
inline constexpr double GreatestExtent = 1e18;

/// An axis-aligned box as its centre and half extents; all half extents are >= 0.
struct Box {
    Vec3 centre = Vec3::Zero();
    Vec3 halfExtents = Vec3::Zero();
};

} // namespace Lixel
