#pragma once

#include "fit/problem/ShadowFit.h"
#include "fit/problem/ShadowProblem.h"

#include <optional>

namespace Lixel {
/// @addtogroup LixelFit
/// @{

/** m (Lloyd et al. 2007): the largest extent of a map's texel in the viewer's picture, in pixels.

    On the surface's tangent plane through a point, a step of one texel in whatever direction of the
    map moves the picture by at most m pixels: m = 1 / σ_min(d texel / d pixel). 1 is perfect.
    Below 1 the map has texels to spare; above 1 its texels show. m includes both perspective and
    projection aliasing. Nothing needs to be drawn, so any fit can be judged anywhere, also fits of
    other setups that a ShadowMapObserver is told of.

    For a point beside the map, but in front of it (w > 0), it is what a larger map of the same
    matrices would have there. It grows without bound, up to infinity, towards where the surface is
    edge-on to the light: one texel's rays never end on it. Edge-on to the viewer it stays finite.
    Measures of whole pictures leave out what is flatter than 5 % to either.

    @param fit its matrices alone count: any positive multiple of them gives the same
    @param mapSize width and height in texels
    @param viewer its matrices alone count, not how far shadows reach
    @param pictureSize width and height in pixels
    @param ws a point in world axes, relative to the origin of fit and viewer
    @param wsNormal the surface's, of any length but zero, on either side
    @return never a NaN: none where there is no such extent, as the fit has no map, the point is not
            in front of the viewer or of the map (w <= 0), the normal is zero, or a number is NaN
*/
LIXEL_API std::optional<double> texelInPixels(const ShadowFit& fit, const Vec2& mapSize,
                                              const ShadowViewer& viewer, const Vec2& pictureSize,
                                              const Vec3& ws, const Vec3& wsNormal) noexcept;

/// @}
} // namespace Lixel
