#include "fit/Warp.h"

#include <algorithm>

namespace Lixel {

WarpExtent warpExtent(const Polygon2& hull, const Vec2& centre, const Vec2& warp,
                      double thickness) {
    const double at = warp.dot(centre);
    const double rim = warp.norm() * thickness;
    return {support(hull, -warp) + at + rim, support(hull, warp) - at + rim};
}

double pullIntoSafeSet(const Polygon2& hull, const Vec2& centre, double thickness, Vec2& warp) {
    const WarpExtent extent = warpExtent(hull, centre, warp, thickness);
    const double load = extent.least + WarpSafety * extent.greatest;
    if (!(load > 1.0 - WarpSafety)) return 1.0;
    const double factor = (1.0 - WarpSafety) / load;
    warp *= factor;
    return factor;
}

double warpPolygon(const Polygon2& hull, const Vec2& centre, const Vec2& warp, Polygon2& warped) {
    warped.clear();
    double least = 1.0;
    for (const Vec2& vertex : hull) {
        const Vec2 q = vertex - centre;
        const double denominator = 1.0 + warp.dot(q);
        least = std::min(least, denominator);
        warped.push_back(q / denominator);
    }
    return least;
}

} // namespace Lixel
