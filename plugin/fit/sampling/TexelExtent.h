#pragma once

#include "fit/geometry/Polygon2.h"
#include "fit/sampling/ViewSamples.h"

#include <array>
#include <optional>

namespace Lixel {

/// Of the extent of a texel in the light image and of that in the viewer's picture, in what a sample
/// adds to the measure; and of the mean over samples, in the measure. @see TexelExtent
inline constexpr double LightPower = 3.0 / 4.0;
inline constexpr double PicturePower = 1.0 / 2.0;
inline constexpr double MeanPower = 4.0 / 5.0;

/// Two sides of a map's rectangle, as vectors.
struct MapSides {
    Vec2 u = Vec2::Zero();
    Vec2 v = Vec2::Zero();
};

/** What a map's two coordinates grow along: unit normals of its sides in the warped light image,
    the second to the left of the first. Where they are not at right angles the map is a
    parallelogram there. */
struct MapAxes {
    std::array<Vec2, 2> normals;
    /// Whether they are the last map's, to the last bit.
    bool kept = false;
};

/** The sides of the smallest rectangle around a convex polygon; zero around a point.

    All edges are tried, four at once: for few vertices that is faster than calipers turned about
    them, which wait for one comparison after the other.
    @param count vertices, a multiple of four; one more than that is read. Fill up with the first.
*/
MapSides smallestMap(const double* x, const double* y, std::size_t count);

/** How large a map's texels are on average over the samples, as a function of the warp: Chong's
    "one combined measure of aliasing" (2006, §3.3), to be minimised.

    A pixel is classified wrongly where a texel lies across a shadow's edge, so how often that
    happens is the density of edges times the extent of a texel in the same plane. Edges spread
    evenly over the light image call for the texel's extent there, eL, edges spread evenly over the
    viewer's picture for its extent in pixels, eP. Scenes are in between, and large texels do more
    than their share of harm: this is the mean of degree 5/4 of eL^(3/5) eP^(2/5),

        (mean of eL^(3/4) eP^(1/2))^(4/5).

    Of the powers that were tried over samples of 14 kinds, maps erred least with these; with
    sqrt(eL eP) and a plain mean 1.007 times as much. Extents are Frobenius norms of
    d(plane) / d(texel): perspective and projection aliasing together. Each sample counts by its
    weight. Values are only to be compared with those of other warps.
*/
class TexelExtent {
public:
    /// @param hull the focus region's; the map is the smallest rectangle around it after the warp
    void reset(const std::vector<ViewSample>& samples, const Polygon2& hull, const Vec2& centre);

    bool hasSamples() const { return mCount > 0; }

    /// The mean for a warp about the centre, which must be positive all over the hull.
    double operator()(const Vec2& warp);

    /** The axes of the parallelogram around the warped hull that makes texels smallest, of those
        whose sides lie along two of the hull's edges, or of the smallest rectangle, where that is
        hardly worse.
        @param warp as above
        @param last the last map's axes: they are kept as long as no others are much better
        @return none where the hull has no area */
    std::optional<MapAxes> chooseAxes(const Vec2& warp, const std::optional<MapAxes>& last);

private:
    /// Numbers of samples beside each other: position about the centre, and d(device x, y) /
    /// d(light image x, y) by rows. They only grow.
    struct SampleColumns {
        std::vector<double> x, y;
        std::array<std::vector<double>, 4> ndcFromLi;
        std::array<std::vector<double>*, 6> all() {
            return {&x, &y, &ndcFromLi[0], &ndcFromLi[1], &ndcFromLi[2], &ndcFromLi[3]};
        }
    };

    /// @param scale of the light image
    static double sumOver(const SampleColumns& columns, std::size_t count, const Vec2& warp,
                          const MapSides& map, double scale);
    double sumOver(const Vec2& warp, const MapSides& map) const;
    /// Warps the hull. @return the sides of the smallest rectangle around it
    MapSides warpHull(const Vec2& warp);
    /// A unit normal, and how far the warped hull reaches along it, from end to end.
    struct Extent {
        Vec2 normal;
        double length;
    };
    Extent extentAlong(const Vec2& normal) const;
    /// The sides of the map with these two axes around the warped hull; none where they are nearly
    /// parallel.
    static std::optional<MapSides> sidesOf(const Extent& a, const Extent& b);

    /// Brings the light image to the hull's size, its greatest coordinate about the centre: so the
    /// measure knows no unit, to the last bit.
    double mScale = 1.0;
    SampleColumns mSamples;
    std::size_t mCount = 0;
    // The hull about the centre, and warped.
    std::size_t mVertices = 0;
    std::vector<double> mHullX, mHullY, mWarpedX, mWarpedY;
    /// Across each edge of the warped hull, while axes are chosen.
    std::vector<Extent> mAcross;
};

} // namespace Lixel
