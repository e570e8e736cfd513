#include "fit/ConvexVolume.h"

#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <limits>

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
void cutOff(const Plane& plane, double slack, std::uint32_t newFace, ClipScratch& scratch) {
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

/// Appends the vertices that edges are left of.
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

ConvexVolume::Side ConvexVolume::classify(const Box& box) const {
    Side side = Side::Inside;
    for (const Plane& plane : planes()) {
        const double distance = plane.distance(box.centre);
        const double radius = plane.normal.cwiseAbs().dot(box.halfExtents);
        if (distance < -radius) return Side::Outside;
        if (distance < radius) side = Side::Straddles;
    }
    return side;
}

ConvexVolume viewVolume(const ShadowViewer& viewer) {
    const Mat4 m = viewer.clipFromView * viewer.viewFromWorld;
    ConvexVolume volume;
    // The planes that most bodies are beyond come first.
    if (viewer.shadowDistance > 0.0) {
        // depth = -(row z of the view matrix) . x <= shadowDistance
        const Vec4 depth = viewer.viewFromWorld.row(2).transpose();
        volume.add(depth.head<3>(), depth.w() + viewer.shadowDistance);
    }
    // A row whose normal is this small beside the w row's is rounding of an infinite far plane.
    constexpr double VanishingPlane = 1e-12;
    const double scale = m.topLeftCorner<4, 3>().cwiseAbs().maxCoeff();
    for (int row = 0; row < 3; ++row) {
        for (const double sign : {1.0, -1.0}) {
            const Vec4 plane = (m.row(3) + sign * m.row(row)).transpose();
            if (plane.head<3>().norm() > VanishingPlane * scale)
                volume.add(plane.head<3>(), plane.w());
        }
    }
    return volume;
}

Vec3 wsEyeOf(const ShadowViewer& viewer) {
    return viewer.viewFromWorld.inverse().topRightCorner<3, 1>();
}

Mat4 withDepthAhead(const Mat4& clipFromView) {
    Mat4 result = clipFromView;
    // The sign of d(z / w) / d(depth) along the view's axis, where z = z0 - zz depth and so on.
    const double slope =
        clipFromView(2, 3) * clipFromView(3, 2) - clipFromView(2, 2) * clipFromView(3, 3);
    if (slope < 0.0) result.row(2) *= -1.0;
    return result;
}

bool viewBounds(const ShadowViewer& viewer, Box& box) {
    const Mat4 clipFromWorld = withDepthAhead(viewer.clipFromView) * viewer.viewFromWorld;
    const Mat4 worldFromClip = clipFromWorld.inverse();
    Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 upper = -lower;
    const auto include = [&](const Vec3& p) {
        lower = lower.cwiseMin(p);
        upper = upper.cwiseMax(p);
    };
    for (int i = 0; i < 4; ++i) {
        const double x = (i & 1) != 0 ? 1.0 : -1.0;
        const double y = (i & 2) != 0 ? 1.0 : -1.0;
        const Vec4 nearCorner = worldFromClip * Vec4(x, y, -1.0, 1.0);
        const Vec4 farCorner = worldFromClip * Vec4(x, y, 1.0, 1.0);
        if (!(nearCorner.w() > 0.0)) return false;
        const Vec3 a = nearCorner.head<3>() / nearCorner.w();
        // The corner of the shadow distance lies on the same edge of the view, which runs towards
        // farCorner - w * a, a direction also where the far corner itself is at infinity.
        const Vec3 edge = farCorner.head<3>() - farCorner.w() * a;
        const auto depth = [&](const Vec4& p) { return -viewer.viewFromWorld.row(2).dot(p); };
        const double perUnit = depth(Vec4(edge.x(), edge.y(), edge.z(), 0.0));
        double t =
            farCorner.w() > 0.0 ? 1.0 / farCorner.w() : std::numeric_limits<double>::infinity();
        if (viewer.shadowDistance > 0.0 && perUnit > 0.0)
            t = std::min(t,
                         (viewer.shadowDistance - depth(Vec4(a.x(), a.y(), a.z(), 1.0))) / perUnit);
        if (!std::isfinite(t)) return false;
        include(a);
        include(a + std::max(t, 0.0) * edge);
    }
    box = {(lower + upper) / 2.0, (upper - lower) / 2.0};
    return box.centre.allFinite() && box.halfExtents.allFinite();
}

std::array<Vec3, 8> corners(const Box& box) {
    std::array<Vec3, 8> result;
    for (std::size_t i = 0; i < 8; ++i) {
        const Vec3 sign((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                        (i & 4) != 0 ? 1.0 : -1.0);
        result[i] = box.centre + sign.cwiseProduct(box.halfExtents);
    }
    return result;
}

void clipBox(const Box& box, const ConvexVolume& volume, ClipScratch& scratch,
             std::vector<Vec3>& points) {
    const auto corner = corners(box);
    scratch.vertices.assign(corner.begin(), corner.end());
    scratch.edges.assign(BoxEdges.begin(), BoxEdges.end());
    auto face = static_cast<std::uint32_t>(6);
    for (const Plane& plane : volume.planes()) {
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
    for (const Plane& plane : volume.planes()) {
        const double slack =
            OnPlane * (plane.normal.cwiseAbs().dot(reach) + std::abs(plane.offset));
        cutOff(plane, slack, faces++, scratch);
    }
    appendVertices(scratch, points);
}

} // namespace Lixel
