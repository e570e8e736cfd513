#include "fit/core/Warp.h"

#include <algorithm>
#include <limits>

namespace Lixel {

WarpExtent warpExtent(const Polygon2& hull, const Vec2& centre, const Vec2& warp,
                      double thickness) {
    const double at = warp.dot(centre);
    const double rim = warp.norm() * thickness;
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (const Vec2& vertex : hull) {
        const double along = warp.dot(vertex);
        least = std::min(least, along);
        greatest = std::max(greatest, along);
    }
    return {at - least + rim, greatest - at + rim};
}

double pullIntoSafeSet(const Polygon2& hull, const Vec2& centre, double thickness, Vec2& warp,
                       double epsilon) {
    const WarpExtent extent = warpExtent(hull, centre, warp, thickness);
    const double load = extent.least + epsilon * extent.greatest;
    if (!(load > 1.0 - epsilon)) return 1.0;
    const double factor = (1.0 - epsilon) / load;
    warp *= factor;
    return factor;
}

Vec2 warpOf(const Vec3& covector, const Polygon2& hull, const Vec2& centre) {
    const Vec2 slope = covector.head<2>();
    // At half of what the safe set's border has at the centre, the warp is twice as long as there.
    const WarpExtent extent = warpExtent(hull, centre, slope, 0.0);
    const double unsafe = 0.5 * (extent.least + WarpSafety * extent.greatest);
    const double at = std::max(slope.dot(centre) + covector.z(), unsafe);
    return at > 0.0 ? Vec2(slope / at) : Vec2(Vec2::Zero());
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
