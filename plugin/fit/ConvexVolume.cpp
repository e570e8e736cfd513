#include "fit/ConvexVolume.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace Lixel {
namespace {

// The corners of corners(), bit 0: x, bit 1: y, bit 2: z, in face order; winding is of no matter.
constexpr std::array<std::array<std::size_t, 4>, 6> BoxFaces = {
    {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};

/// Clips one face polygon; the points on the plane that this makes are added to `cut`.
void clipFace(const std::vector<Vec3>& face, const Plane& plane, std::vector<Vec3>& result,
              std::vector<Vec3>& cut) {
    result.clear();
    const std::size_t n = face.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3& a = face[i];
        const Vec3& b = face[(i + 1) % n];
        const double da = plane.distance(a);
        const double db = plane.distance(b);
        if (da >= 0.0) result.push_back(a);
        if (da == 0.0) cut.push_back(a);
        if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) {
            const Vec3 p = a + (b - a) * (da / (da - db));
            result.push_back(p);
            cut.push_back(p);
        }
    }
}

/// Orders coplanar points of a convex polygon around their mean.
void orderAround(const Vec3& normal, std::vector<Vec3>& points,
                 std::vector<std::pair<double, Vec3>>& sorted) {
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : points)
        mean += p;
    mean /= static_cast<double>(points.size());
    // Any two axes in the plane do; the smallest component of the normal gives a stable one.
    Vec3 axis = Vec3::Zero();
    Eigen::Index smallest = 0;
    normal.cwiseAbs().minCoeff(&smallest);
    axis[smallest] = 1.0;
    const Vec3 u = normal.cross(axis).normalized();
    const Vec3 v = normal.cross(u);
    sorted.clear();
    for (const Vec3& p : points)
        sorted.emplace_back(std::atan2((p - mean).dot(v), (p - mean).dot(u)), p);
    std::sort(sorted.begin(), sorted.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    points.clear();
    for (const auto& [angle, p] : sorted)
        points.push_back(p);
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
    if (viewer.shadowDistance > 0.0) {
        // depth = -(row z of the view matrix) . x <= shadowDistance
        const Vec4 depth = viewer.viewFromWorld.row(2).transpose();
        volume.add(depth.head<3>(), depth.w() + viewer.shadowDistance);
    }
    return volume;
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
    std::size_t faces = BoxFaces.size();
    if (scratch.faces.size() < BoxFaces.size() + ConvexVolume::Capacity)
        scratch.faces.resize(BoxFaces.size() + ConvexVolume::Capacity);
    for (std::size_t f = 0; f < faces; ++f) {
        scratch.faces[f].clear();
        for (const std::size_t c : BoxFaces[f])
            scratch.faces[f].push_back(corner[c]);
    }
    for (const Plane& plane : volume.planes()) {
        const double radius = plane.normal.cwiseAbs().dot(box.halfExtents);
        const double distance = plane.distance(box.centre);
        if (distance >= radius) continue;
        if (distance < -radius) return;
        scratch.cap.clear();
        for (std::size_t f = 0; f < faces; ++f) {
            clipFace(scratch.faces[f], plane, scratch.face, scratch.cap);
            scratch.faces[f].swap(scratch.face);
        }
        if (scratch.cap.size() > 2) {
            orderAround(plane.normal, scratch.cap, scratch.sorted);
            scratch.faces[faces++].swap(scratch.cap);
        }
    }
    for (std::size_t f = 0; f < faces; ++f)
        points.insert(points.end(), scratch.faces[f].begin(), scratch.faces[f].end());
}

} // namespace Lixel
