#include "fit/geometry/SurfaceCloud.h"

#include "fit/geometry/LowDiscrepancy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace Lixel {
namespace {

/// Discs of the mean area around evenly spread points leave gaps; discs of twice that area cover
/// all but a few percent.
constexpr double Overlap = std::numbers::sqrt2;

/// Twice the area; 0 where that is not a number.
double doubledArea(const Vec3& normal) {
    const double area = normal.norm();
    return std::isfinite(area) ? area : 0.0;
}

} // namespace

void SurfaceCloudBuilder::measure(const Vec3& a, const Vec3& b, const Vec3& c) {
    mSum += doubledArea((b - a).cross(c - a));
}

bool SurfaceCloudBuilder::isNextBefore(double sum) const {
    const auto index = static_cast<double>(mCloud.surfels.size());
    const auto count = static_cast<double>(mCount);
    return mCloud.surfels.size() < mCount && mSum > 0.0 && std::isfinite(mSum) &&
           sum > mSum * (index + 0.5) / count;
}

bool SurfaceCloudBuilder::skip(double sum) {
    if (isNextBefore(sum)) return false;
    mPassed = sum;
    return true;
}

void SurfaceCloudBuilder::spread(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = (b - a).cross(c - a);
    mPassed += doubledArea(normal);
    while (isNextBefore(mPassed)) {
        // Evenly over the triangle: the unit square folded along its diagonal.
        Vec2 uv = lowDiscrepancy(mCloud.surfels.size());
        if (uv.sum() > 1.0) uv = Vec2::Ones() - uv;
        const Vec3 centre = a + uv.x() * (b - a) + uv.y() * (c - a);
        const double radius =
            Overlap * std::sqrt(mSum / 2.0 / std::numbers::pi / static_cast<double>(mCount));
        mCloud.surfels.push_back({centre, normal.stableNormalized(), radius});
    }
}

SurfaceCloud makeSurfaceCloud(std::span<const Vec3> positions,
                              std::span<const std::array<std::uint32_t, 3>> triangles,
                              std::size_t count) {
    SurfaceCloudBuilder builder(count);
    const auto forTriangles = [&](auto visit) {
        for (const auto& corners : triangles)
            if (std::max({corners[0], corners[1], corners[2]}) < positions.size())
                (builder.*visit)(positions[corners[0]], positions[corners[1]],
                                 positions[corners[2]]);
    };
    forTriangles(&SurfaceCloudBuilder::measure);
    forTriangles(&SurfaceCloudBuilder::spread);
    return builder.cloud();
}

} // namespace Lixel
