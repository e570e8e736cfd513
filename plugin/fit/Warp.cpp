#include "fit/Warp.h"

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

} // namespace Lixel
