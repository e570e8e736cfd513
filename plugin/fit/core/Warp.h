#pragma once

#include "fit/geometry/Polygon2.h"

/** The warp plane (Gusev 2007, §2.1, eq. 2), moved to where it is well conditioned.

    Gusev divides by 1 + P . (q - e) with the viewer's image e as origin; here the origin is an
    interior point c of the focus region: 1 + w . (q - c), with w = P / (1 + P . (c - e)). The two
    name the same homographies, but the safe set of w is compact and contains 0.
*/
namespace Lixel {

/// Numerical bound on a warp: the least denominator on the focus region is at least this fraction
/// of about its greatest. 2^-13 leaves 10 of a float's 23 mantissa bits to what is divided by it.
inline constexpr double WarpSafety = 0x1p-13;

/// What a warp does at the two ends of the focus region.
struct WarpExtent {
    /// max of -w . (q - c) over the region: 1 minus the least denominator.
    double least = 0.0;
    /// max of w . (q - c): the greatest denominator minus 1.
    double greatest = 0.0;
};

/** The warp's extent over the hull, thickened by `thickness` so that a hull without area (a caster
    seen edge-on) still bounds every direction. */
WarpExtent warpExtent(const Polygon2& hull, const Vec2& centre, const Vec2& warp, double thickness);

/** Pulls a warp radially into the safe set {A(w) + εB(w) <= 1 - ε}, A and B being `least` and
    `greatest` of its extent.

    Both are positively homogeneous in w, so the pull is one factor, continuous in w and hull.
    @param epsilon the shared numerical bound, or more where a technique wants it
    @return the factor in (0, 1] by which `warp` was multiplied; 1 where it was safe.
*/
double pullIntoSafeSet(const Polygon2& hull, const Vec2& centre, double thickness, Vec2& warp,
                       double epsilon = WarpSafety);

/** The warp whose denominator is an oriented covector's: h . (q, 1) = k (1 + w . (q - c)), k > 0.

    A covector that is not positive at the centre, or hardly positive, is no such warp. The result
    then has the covector's direction and is longer than any safe warp. Pulled into the safe set,
    the result is continuous in h as long as h is not the same all over the plane.
*/
Vec2 warpOf(const Vec3& covector, const Polygon2& hull, const Vec2& centre);

/// The hull warped about the centre, q -> (q - c) / (1 + w . (q - c)).
/// @return the least denominator, at most 1
double warpPolygon(const Polygon2& hull, const Vec2& centre, const Vec2& warp, Polygon2& warped);

} // namespace Lixel
