#pragma once

#include "fit/geometry/HalfSpace.h"
#include "fit/problem/ShadowProblem.h"

#include <array>
#include <limits>
#include <numbers>
#include <span>

namespace Lixel {
/// @addtogroup LixelFit
/// @{

/// Widest cone of a single map, as half angle in radians: tan(89.5°) = 115 spreads the map, but no
/// plane holds the rays of 90°.
inline constexpr double WidestHalfAngle = 89.5 * std::numbers::pi / 180.0;

/// Whether the light shines too wide for one map: a point light, or a spot of more than
/// WidestHalfAngle.
LIXEL_API bool needsParts(const ShadowLight& light);

/// What one of a light's maps is for.
struct ShadowPart {
    /// The most that a light has.
    static constexpr std::size_t Most = 8;
    /// A part has a bound with each of the others.
    static constexpr std::size_t MostBounds = Most - 1;

    /// The light as this map sees it: a face of a point light is a spot.
    ShadowLight light;
    /// (n, d): n . x + d is the part's function, in world axes relative to the problem's origin.
    Vec4 wsRow = Vec4::Zero();
    /// Half spaces that bound where this part's function is greater than the other parts'. Where
    /// slices overlap they reach somewhat farther.
    std::array<HalfSpace, MostBounds> wsBounds{};
    std::size_t boundCount = 0;
    /// Depth in front of the viewer at which a slice ends, in world units; infinite for the last
    /// one, and for parts of another kind.
    double vsEnd = std::numeric_limits<double>::infinity();
    /// The plane (n, d) of the viewer's volume through which the part's light rays leave it; 0 for
    /// parts of another kind.
    Vec4 wsExit = Vec4::Zero();

    std::span<const HalfSpace> bounds() const { return {wsBounds.data(), boundCount}; }
};

static_assert(HasOneLayout<ShadowPart>);

/// @}
} // namespace Lixel
