#include "fit/geometry/ConvexSurface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace Lixel {
namespace {

/// Vertices nearer to each other than this part of the body's size are at one place: what sines in
/// float leave between the ends of a sphere's seam, and some of it.
constexpr double SamePlace = 0x1p-20;

/// How far a vertex may be before a triangle's plane, relative to the body's size: what rounding to
/// float does to the plane of a small triangle.
constexpr double OffPlane = 0x1p-16;

/// For each position the first one at its place.
std::vector<std::uint32_t> placesOf(std::span<const Vec3> positions, double size) {
    std::vector<std::uint32_t> places(positions.size());
    std::vector<std::uint32_t> firsts;
    for (std::uint32_t i = 0; i < places.size(); ++i) {
        const auto same = std::ranges::find_if(firsts, [&](std::uint32_t first) {
            return (positions[first] - positions[i]).cwiseAbs().maxCoeff() <= SamePlace * size;
        });
        places[i] = same != firsts.end() ? *same : i;
        if (same == firsts.end()) firsts.push_back(i);
    }
    return places;
}

/// Whether each edge is there once in either direction.
bool isClosed(std::vector<std::array<std::uint32_t, 2>>& edges) {
    std::ranges::sort(edges);
    if (std::ranges::adjacent_find(edges) != edges.end()) return false;
    return std::ranges::all_of(edges, [&](const std::array<std::uint32_t, 2>& edge) {
        return std::ranges::binary_search(edges, std::array{edge[1], edge[0]});
    });
}

} // namespace

bool isConvexSurface(std::span<const Vec3> positions,
                     std::span<const std::array<std::uint32_t, 3>> triangles) {
    Eigen::AlignedBox3d bounds;
    for (const Vec3& position : positions) {
        if (!position.allFinite()) return false;
        bounds.extend(position);
    }
    if (positions.empty()) return false;
    const double size = bounds.sizes().maxCoeff();
    const std::vector<std::uint32_t> places = placesOf(positions, size);
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const auto& [i, j, k] : triangles) {
        if (std::max({i, j, k}) >= positions.size()) return false;
        const std::uint32_t a = places[i];
        const std::uint32_t b = places[j];
        const std::uint32_t c = places[k];
        if (a == b || b == c || c == a) continue;
        const Vec3 normal =
            Vec3(positions[b] - positions[a]).cross(Vec3(positions[c] - positions[a]));
        const double most = normal.dot(positions[a]) + OffPlane * size * normal.norm();
        const auto isBefore = [&](const Vec3& position) { return normal.dot(position) > most; };
        if (std::ranges::any_of(positions, isBefore)) return false;
        for (const auto& edge : {std::array{a, b}, {b, c}, {c, a}})
            edges.push_back(edge);
    }
    // Less than a tetrahedron is flat.
    return edges.size() >= 12 && isClosed(edges);
}

} // namespace Lixel
