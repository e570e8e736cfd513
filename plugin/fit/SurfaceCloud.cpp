#include "fit/SurfaceCloud.h"

#include "fit/LowDiscrepancy.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace Lixel {
namespace {

/// Discs of the mean area around evenly spread points leave gaps; discs of twice that area cover
/// all but a few percent.
constexpr double Overlap = std::numbers::sqrt2;

} // namespace

SurfaceCloud makeSurfaceCloud(std::span<const Vec3> positions,
                              std::span<const std::array<std::uint32_t, 3>> triangles,
                              std::size_t count) {
    // Twice the triangles' areas, summed up.
    std::vector<double> sums;
    sums.reserve(triangles.size());
    double sum = 0.0;
    const auto normalOf = [&](const std::array<std::uint32_t, 3>& triangle) {
        if (std::max({triangle[0], triangle[1], triangle[2]}) >= positions.size())
            return Vec3(Vec3::Zero());
        const Vec3& a = positions[triangle[0]];
        const Vec3 normal = (positions[triangle[1]] - a).cross(positions[triangle[2]] - a);
        return normal.allFinite() ? normal : Vec3(Vec3::Zero());
    };
    for (const auto& triangle : triangles)
        sums.push_back(sum += normalOf(triangle).norm());

    SurfaceCloud cloud;
    if (!(sum > 0.0) || !std::isfinite(sum)) return cloud;
    const double radius =
        Overlap * std::sqrt(sum / 2.0 / std::numbers::pi / static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const double at = sum * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        const auto found = std::upper_bound(sums.begin(), sums.end(), at);
        const auto index = static_cast<std::size_t>(found - sums.begin());
        const auto& triangle = triangles[std::min(index, triangles.size() - 1)];
        // Evenly over the triangle: the unit square folded along its diagonal.
        Vec2 uv = lowDiscrepancy(i);
        if (uv.sum() > 1.0) uv = Vec2::Ones() - uv;
        const Vec3& a = positions[triangle[0]];
        const Vec3 centre =
            a + uv.x() * (positions[triangle[1]] - a) + uv.y() * (positions[triangle[2]] - a);
        cloud.surfels.push_back({centre, normalOf(triangle).stableNormalized(), radius});
    }
    return cloud;
}

} // namespace Lixel
