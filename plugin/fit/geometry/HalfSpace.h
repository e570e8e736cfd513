#pragma once

#include "fit/geometry/Types.h"

namespace Lixel {
/// @addtogroup LixelFit
/// @{

/// The half space normal . x + offset >= 0.
struct HalfSpace {
    Vec3 normal = Vec3::Zero();
    double offset = 0.0;
    double distance(const Vec3& x) const { return normal.dot(x) + offset; }
};

/// @}
} // namespace Lixel
