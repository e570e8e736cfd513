#include "fit/BodyHull.h"

#include <cmath>

namespace Lixel {
namespace {

/// By how much faces are moved out, relative to the body's size: some thousand units in the last
/// place, so that no vertex is outside for rounding.
constexpr double OutwardSlack = 0x1p-40;

/// The half spaces around the points whose normals run towards a box's edges and corners.
ConvexVolume bevels(std::span<const Vec3> positions, double slack) {
    ConvexVolume volume;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                if (x * x + y * y + z * z < 2) continue;
                const Vec3 outward = Vec3(x, y, z).normalized();
                double farthest = outward.dot(positions[0]);
                for (const Vec3& position : positions)
                    farthest = std::max(farthest, outward.dot(position));
                volume.add(-outward, farthest + slack);
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
    Vec3 lower = positions[0];
    Vec3 upper = lower;
    for (const Vec3& position : positions) {
        if (!position.allFinite()) return hull;
        lower = lower.cwiseMin(position);
        upper = upper.cwiseMax(position);
    }
    const double slack = OutwardSlack * (upper.cwiseAbs() + lower.cwiseAbs()).maxCoeff();
    const Box box{(lower + upper) / 2.0, (upper - lower) / 2.0 + Vec3::Constant(slack)};
    ClipScratch scratch;
    std::vector<Vec3> all;
    clipBox(box, bevels(positions, slack), scratch, all);

    // The edges that are left, and their vertices.
    std::vector<std::uint32_t> index(scratch.vertices.size());
    for (const ClipScratch::Edge& edge : scratch.edges) {
        ClipScratch::Edge own = edge;
        for (std::uint32_t& vertex : own.vertices) {
            std::uint32_t& at = index[vertex];
            if (at == 0) {
                hull.vertices.push_back(scratch.vertices[vertex]);
                at = static_cast<std::uint32_t>(hull.vertices.size());
            }
            vertex = at - 1;
        }
        for (const std::uint32_t face : own.faces)
            hull.faces = std::max(hull.faces, face + 1);
        hull.edges.push_back(own);
    }
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
