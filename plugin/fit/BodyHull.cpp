#include "fit/BodyHull.h"

#include <algorithm>
#include <cmath>

namespace Lixel {
namespace {

/// Vertices nearer to each other than this part of the body's size are one, but for rounding: cuts
/// through one vertex leave several of them.
constexpr double SameVertex = 0x1p-42;

/// By how much the hull is larger in the end, so that nothing is outside for rounding.
constexpr double Outward = 0x1p-36;

/// Least that a face cuts off, relative to the body's size: less is not worth its vertices.
constexpr double LeastBevel = 1.0 / 64.0;

/// The half spaces around the points whose normals run towards a box's edges and corners.
ConvexVolume bevels(std::span<const Vec3> positions, const Box& box) {
    ConvexVolume volume;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                if (x * x + y * y + z * z < 2) continue;
                const Vec3 outward = Vec3(x, y, z).normalized();
                double farthest = outward.dot(positions[0]);
                for (const Vec3& position : positions)
                    farthest = std::max(farthest, outward.dot(position));
                const double reach =
                    outward.dot(box.centre) + outward.cwiseAbs().dot(box.halfExtents);
                if (reach - farthest > LeastBevel * box.halfExtents.maxCoeff())
                    volume.add(-outward, farthest);
            }
    return volume;
}

/// Sums up the tetrahedra between a body's middle, a face's middle and each of its edges.
double volumeOf(const BodyHull& hull) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& vertex : hull.vertices)
        middle += vertex / static_cast<double>(hull.vertices.size());
    double volume = 0.0;
    for (std::uint32_t face = 0; face < hull.faces; ++face) {
        Vec3 faceMiddle = Vec3::Zero();
        double ends = 0.0;
        const auto forEdges = [&](const auto& visit) {
            for (const ClipScratch::Edge& edge : hull.edges)
                if (edge.faces[0] == face || edge.faces[1] == face)
                    visit(hull.vertices[edge.vertices[0]], hull.vertices[edge.vertices[1]]);
        };
        forEdges([&](const Vec3& a, const Vec3& b) {
            faceMiddle += a + b;
            ends += 2.0;
        });
        if (ends == 0.0) continue;
        const Vec3 top = faceMiddle / ends - middle;
        forEdges([&](const Vec3& a, const Vec3& b) {
            volume += std::abs(top.dot((a - middle).cross(b - middle))) / 6.0;
        });
    }
    return volume;
}

} // namespace

BodyHull makeBodyHull(std::span<const Vec3> positions) {
    BodyHull hull;
    if (positions.empty()) return hull;
    Eigen::AlignedBox3d bounds;
    for (const Vec3& position : positions) {
        if (!position.allFinite()) return hull;
        bounds.extend(position);
    }
    const Box box{bounds.center(), bounds.sizes() / 2.0};
    ClipScratch scratch;
    std::vector<Vec3> all;
    clipBox(box, bevels(positions, box), scratch, all);

    // The edges that are left, and their vertices.
    const double same = SameVertex * (bounds.min().cwiseAbs() + bounds.max().cwiseAbs()).maxCoeff();
    const auto indexOf = [&](const Vec3& vertex) {
        std::size_t i = 0;
        while (i < hull.vertices.size() && !((hull.vertices[i] - vertex).norm() <= same))
            ++i;
        if (i == hull.vertices.size()) hull.vertices.push_back(vertex);
        return static_cast<std::uint32_t>(i);
    };
    for (const ClipScratch::Edge& edge : scratch.edges) {
        ClipScratch::Edge own = edge;
        for (std::uint32_t& vertex : own.vertices)
            vertex = indexOf(scratch.vertices[vertex]);
        // A body that is but a point keeps one, or it would be none.
        if (own.vertices[0] == own.vertices[1] && !hull.edges.empty()) continue;
        for (const std::uint32_t face : own.faces)
            hull.faces = std::max(hull.faces, face + 1);
        hull.edges.push_back(own);
    }
    for (Vec3& vertex : hull.vertices)
        vertex += Outward * (vertex - box.centre);
    hull.volume = volumeOf(hull);
    return hull;
}

void clipHull(const BodyHull& hull, const Eigen::Affine3d& wsFromBody, const ConvexVolume& volume,
              ClipScratch& scratch, std::vector<Vec3>& points) {
    scratch.vertices.clear();
    for (const Vec3& vertex : hull.vertices)
        scratch.vertices.push_back(wsFromBody * vertex);
    scratch.edges = hull.edges;
    clipEdges(volume, hull.faces, scratch, points);
}

} // namespace Lixel
