#include "fit/focus/ViewVolume.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Lixel {

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

ShadowViewer widened(const ShadowViewer& viewer, double share) {
    ShadowViewer wide = viewer;
    if (!(share > 0.0)) return wide;
    wide.clipFromView.topRows<2>() /= 1.0 + share;
    // The depth at which a plane of view coordinates meets the view's axis.
    const auto depthOf = [](const Vec4& plane) { return plane.w() / plane.z(); };
    const Mat4 ahead = withDepthAhead(viewer.clipFromView);
    const double nearDepth = depthOf((ahead.row(3) + ahead.row(2)).transpose());
    const double farDepth = depthOf((ahead.row(3) - ahead.row(2)).transpose());
    const bool perspective = ahead.row(3) == Vec4(0.0, 0.0, -1.0, 0.0).transpose();
    if (perspective && nearDepth > 0.0) {
        if (!(wide.shadowDistance > 0.0) && farDepth > nearDepth && std::isfinite(farDepth))
            wide.shadowDistance = farDepth;
        wide.clipFromView.row(2) = Vec4(0.0, 0.0, -1.0, -2.0 * nearDepth).transpose();
    }
    wide.shadowDistance *= 1.0 + share;
    return wide;
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

bool viewBounds(const ShadowViewer& viewer, Aabb& box) {
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

} // namespace Lixel
