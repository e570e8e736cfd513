#include "fit/geometry/ConvexVolume.h"

#include <algorithm>
#include <cassert>

namespace Lixel {
namespace {

/// Relative rounding within which a vertex counts as lying on a plane. Without it a face that lies
/// in the plane would be cut where rounding happens to say.
constexpr double OnPlane = 0x1p-49;

/// Two corners of corners(), bit 0: x, bit 1: y, bit 2: z, and two faces: 2 * axis, + 1 the upper.
constexpr std::array<ClipScratch::Edge, 12> BoxEdges = {{{{0, 1}, {2, 4}},
                                                         {{2, 3}, {3, 4}},
                                                         {{4, 5}, {2, 5}},
                                                         {{6, 7}, {3, 5}},
                                                         {{0, 2}, {0, 4}},
                                                         {{1, 3}, {1, 4}},
                                                         {{4, 6}, {0, 5}},
                                                         {{5, 7}, {1, 5}},
                                                         {{0, 4}, {0, 2}},
                                                         {{1, 5}, {1, 2}},
                                                         {{2, 6}, {0, 3}},
                                                         {{3, 7}, {1, 3}}}};

/// Cuts off what lies more than `slack` outside the plane; the cut becomes face `newFace`.
void cutOff(const HalfSpace& plane, double slack, std::uint32_t newFace, ClipScratch& scratch) {
    std::vector<Vec3>& vertices = scratch.vertices;
    std::vector<ClipScratch::Edge>& edges = scratch.edges;
    scratch.distances.resize(vertices.size());
    bool cuts = false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        scratch.distances[i] = plane.distance(vertices[i]);
        cuts |= scratch.distances[i] < -slack;
    }
    if (!cuts) return;

    scratch.cuts.clear();
    scratch.lastCut.assign(newFace, ClipScratch::NoCut);
    std::size_t kept = 0;
    const std::size_t count = edges.size();
    for (std::size_t i = 0; i < count; ++i) {
        ClipScratch::Edge edge = edges[i];
        const double a = scratch.distances[edge.vertices[0]];
        const double b = scratch.distances[edge.vertices[1]];
        const bool outsideA = a < -slack;
        const bool outsideB = b < -slack;
        if (outsideA && outsideB) continue;
        if (outsideA || outsideB) {
            const double t = std::clamp(a / (a - b), 0.0, 1.0);
            const Vec3 begin = vertices[edge.vertices[0]];
            const Vec3 end = vertices[edge.vertices[1]];
            const auto cut = static_cast<std::uint32_t>(vertices.size());
            vertices.push_back(begin + t * (end - begin));
            edge.vertices[outsideA ? 0 : 1] = cut;
            for (const std::uint32_t face : edge.faces) {
                assert(face < newFace);
                std::uint32_t& last = scratch.lastCut[face];
                scratch.cuts.push_back({face, cut, last});
                last = static_cast<std::uint32_t>(scratch.cuts.size() - 1);
            }
        }
        edges[kept++] = edge;
    }
    edges.resize(kept);
    // A face is cut in two edges. Where rounding makes it more, all cuts are joined: a segment too
    // many still lies in the volume, and one too few might be missed by the next plane.
    for (const ClipScratch::Cut& cut : scratch.cuts)
        for (std::uint32_t i = cut.previous; i != ClipScratch::NoCut; i = scratch.cuts[i].previous)
            edges.push_back({{cut.vertex, scratch.cuts[i].vertex}, {cut.face, newFace}});
}

/// Appends the vertices that remaining edges use.
void appendVertices(ClipScratch& scratch, std::vector<Vec3>& points) {
    scratch.used.assign(scratch.vertices.size(), 0);
    for (const ClipScratch::Edge& edge : scratch.edges)
        for (const std::uint32_t vertex : edge.vertices) {
            if (scratch.used[vertex] != 0) continue;
            scratch.used[vertex] = 1;
            points.push_back(scratch.vertices[vertex]);
        }
}

} // namespace

void ConvexVolume::add(const Vec3& normal, double offset) {
    const double length = normal.norm();
    if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(offset) || mCount == Capacity)
        return;
    mPlanes[mCount++] = {normal / length, offset / length};
}

ConvexVolume::Side ConvexVolume::classify(const Aabb& box) const {
    Side side = Side::Inside;
    for (const HalfSpace& plane : planes()) {
        const double distance = plane.distance(box.centre);
        const double radius = plane.normal.cwiseAbs().dot(box.halfExtents);
        if (distance < -radius) return Side::Outside;
        if (distance < radius) side = Side::Straddles;
    }
    return side;
}

std::array<Vec3, 8> corners(const Aabb& box) {
    std::array<Vec3, 8> result;
    for (std::size_t i = 0; i < 8; ++i) {
        const Vec3 sign((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                        (i & 4) != 0 ? 1.0 : -1.0);
        result[i] = box.centre + sign.cwiseProduct(box.halfExtents);
    }
    return result;
}

void clipBox(const Aabb& box, const ConvexVolume& volume, ClipScratch& scratch,
             std::vector<Vec3>& points) {
    const auto corner = corners(box);
    scratch.vertices.assign(corner.begin(), corner.end());
    scratch.edges.assign(BoxEdges.begin(), BoxEdges.end());
    auto face = static_cast<std::uint32_t>(6);
    for (const HalfSpace& plane : volume.planes()) {
        const double radius = plane.normal.cwiseAbs().dot(box.halfExtents);
        const double distance = plane.distance(box.centre);
        if (distance >= radius) continue;
        const double slack = OnPlane * (plane.normal.cwiseAbs().dot(box.centre.cwiseAbs()) +
                                        radius + std::abs(plane.offset));
        if (distance < -radius - slack) return;
        cutOff(plane, slack, face++, scratch);
    }
    appendVertices(scratch, points);
}

void clipEdges(const ConvexVolume& volume, std::uint32_t faces, ClipScratch& scratch,
               std::vector<Vec3>& points) {
    Vec3 reach = Vec3::Zero();
    for (const Vec3& vertex : scratch.vertices)
        reach = reach.cwiseMax(vertex.cwiseAbs());
    for (const HalfSpace& plane : volume.planes()) {
        const double slack =
            OnPlane * (plane.normal.cwiseAbs().dot(reach) + std::abs(plane.offset));
        cutOff(plane, slack, faces++, scratch);
    }
    appendVertices(scratch, points);
}

} // namespace Lixel
