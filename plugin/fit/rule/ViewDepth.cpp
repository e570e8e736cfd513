#include "fit/rule/ViewDepth.h"

#include <algorithm>
#include <limits>

namespace Lixel {

ViewDepth::ViewDepth(const WarpContext& context) {
    // View space looks along -z; ws = lsFromWs^T ls + wsEye.
    const Mat4& viewFromWorld = context.problem.viewer.viewFromWorld;
    const Vec3 wsGradient = -viewFromWorld.row(2).head<3>().transpose();
    mLsGradient = context.image.lsFromDirection(wsGradient);
    mOffset = wsGradient.dot(context.image.wsEye()) - viewFromWorld(2, 3);
}

DepthRange ViewDepth::ofRegion(const WarpContext& context) const {
    const FocusRegion& region = context.region;
    DepthRange range{std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity()};
    for (const Vec2& q : region.liHull)
        for (const double depth : {region.lsReceiverNear, region.lsReceiverFar}) {
            const Vec2 ls = context.image.directional() ? q : Vec2(depth * q);
            const double z = at(Vec3(ls.x(), ls.y(), -depth));
            range.nearest = std::min(range.nearest, z);
            range.farthest = std::max(range.farthest, z);
        }
    range.farthest = std::clamp(range.farthest, region.vsReceiverNear, region.vsReceiverFar);
    range.nearest = std::clamp(range.nearest, region.vsReceiverNear, region.vsReceiverFar);
    range.nearest = std::max(range.nearest, LeastNearRatio * range.farthest);
    return range;
}

} // namespace Lixel
