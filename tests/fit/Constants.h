#pragma once

#include <limits>
#include <numbers>

namespace Lixel::Test {

inline constexpr double Infinity = std::numeric_limits<double>::infinity();
inline constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
/// In radians.
inline constexpr double Degree = std::numbers::pi / 180.0;

} // namespace Lixel::Test
