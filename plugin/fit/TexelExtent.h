#pragma once

#include "fit/Polygon2.h"
#include "fit/ViewSamples.h"

namespace Lixel {

/** How large a map's texels are on average over the samples, as a function of the warp: Chong's
   "one combined measure of aliasing" (2006, §3.3), to be minimised.

    A pixel is classified wrongly where a texel lies across a shadow's edge, so how often that
    happens is the density of edges times the extent of a texel in the same plane. Edges spread
    evenly over the light image call for the texel's extent there, edges spread evenly over the
    viewer's picture for its extent in pixels; scenes are in between, and this is the mean of the
    geometric means of the two. Extents are Frobenius norms of d(plane) / d(texel): perspective and
    projection aliasing together. Values are only to be compared with those of other warps.
*/
class TexelExtent {
public:
    /// @param hull the focus region's; the map is the smallest rectangle around it after the warp
    void reset(const std::vector<ViewSample>& samples, const Polygon2& hull, const Vec2& centre);

    bool hasSamples() const { return mCount > 0; }

    /// The mean for a warp about the centre, which must be positive all over the hull.
    double operator()(const Vec2& warp);

private:
    Vec2 mCentre = Vec2::Zero();
    Polygon2 mHull;
    Polygon2 mWarped;
    // Samples as arrays, which only grow: position about the centre, and d(device) / d(light image)
    // by columns.
    Eigen::ArrayXd mX, mY, mXx, mXy, mYx, mYy;
    Eigen::Index mCount = 0;
};

} // namespace Lixel
