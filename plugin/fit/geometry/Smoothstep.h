#pragma once

#include <algorithm>

namespace Lixel {

/// 0 up to t = 0, 1 from t = 1 on, with a continuous slope.
inline double smoothstep(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

} // namespace Lixel
