#pragma once

#include "fit/core/FitState.h"

/** Where the warped focus region lies in the map: the affine part of a fit. */
namespace Lixel {

/// Rounding of positions and of the matrix to float, relative to the distance over which positions
/// are measured: four terms, each of half a unit in the last place, 2^-24.
inline constexpr double PositionRounding = 4.0 * 0x1p-24;

/// Least size of a texel at the region's centre, relative to the distance over which positions are
/// measured: PositionRounding is an eighth of it.
inline constexpr double LeastTexel = 0x1p-19;

/// Texels that such rounding may move an address by, which a map's border makes up for. Where a
/// warp makes texels finer than that, rounding would show, and nobody could see them.
inline constexpr double GreatestRounding = 1.0;

/// The same bound for a map that keeps the last frame's axes. The warp does not depend on them.
/// Beyond the bound the axes are given up.
inline constexpr double GreatestBorderRounding = 2.0 * GreatestRounding;

/// Texels to keep free on each side of a map, with nothing added for the rounding of positions.
double leastBorder(double filterRadius);

/// What makes a map of the warped light image, and the texels that it keeps free on each side.
struct Affine {
    Mat3 mapFromWarped;
    Vec2 border;
    double mapAngle;
    double mapSkew;
    /// Texels that rounding of positions moves addresses by at most, in the smallest rectangle.
    double rounding = 0.0;
    /// The map's axes, for the next frame.
    std::optional<WorldAxes> wsMapAxes;
    /// Whether the last frame's axes were given up.
    bool turned = false;
};

/// (q - c) / (1 + w . (q - c)), as a homography of ℓ = (q, 1).
Mat3 warpMatrix(const Vec2& warp, const Vec2& centre);

/** The warped region's smallest rectangle, unless the last frame's orientation is nearly as good;
    its sides, without the border, become -1 and 1.

    @param warped the focus region's hull after the warp
    @param liReach the distance over which positions are measured, as a length in the light image
    @param wsLast the last map's axes; the first one alone counts
*/
Affine placeRegion(const ShadowProblem& problem, const LightImage& image, const Polygon2& warped,
                   const Vec2& warp, double liReach, const std::optional<WorldAxes>& wsLast);

/** The same along given axes: a parallelogram of the warped light image.

    @param smallest what placeRegion gives: it is returned where texels along the axes are finer
    than a border makes up for
*/
Affine placeAlong(const ShadowProblem& problem, const LightImage& image, const Polygon2& warped,
                  const Vec2& warp, double liReach, const MapAxes& axes,
                  const std::optional<WorldAxes>& wsLast, const Affine& smallest);

/// Splits a map that is given whole into its warp, read from row w, and the affine rest.
/// @param[out] warp of its row w
Affine affineOf(const Mat3& homography, const Vec2& centre, double filterRadius, Vec2& warp);

/** A map that was placed for another region, moved by whole texels to where it shows this one in
    its middle, with a border as of placeRegion's maps.

    Whole texels leave all of its texels where they are: on the same rays of the light.

    @param homography rows x, y and w of the map, acting on ℓ
    @param thickness, liReach as WarpContext has them
    @return none where the region is too large for the map, or where the map's warp is not safe
    there
*/
std::optional<Mat3> movedByTexels(const Mat3& homography, const ShadowProblem& problem,
                                  const FocusRegion& region, double thickness, double liReach,
                                  PlacementScratch& scratch);

/// The focus region and what a receiver's filter reaches beyond it, in the light image: the warped
/// hull's sum with a rectangle of the map's border, with few vertices, unwarped.
/// @param size of the map, in texels
/// @param scratch `warped` is the warped hull; `points` is overwritten
void growByBorder(const Affine& affine, const Vec2& size, const Vec2& warp,
                  const FocusRegion& region, PlacementScratch& scratch, Polygon2& grown);

} // namespace Lixel
