#include "fit/problem/KeptFit.h"

#include <Eigen/Geometry>

#include <cmath>

namespace Lixel {
namespace {

/// How far the fresh focus region may reach beyond the kept map, in half sides of the map. That is a
/// twentieth of a texel of a map of 1024; the region holds a whole texel more than filters reach.
constexpr double EdgeSlack = 1e-4;

/// How far a depth may be beyond the kept range, which is 0 to 1: float rounding of depths.
constexpr double DepthSlack = 1e-6;

/// A point on the light ray q of a fit's image, relative to its origin.
Vec3 pointOn(const ShadowFit& fit, const Vec2& q) {
    return fit.wsEye + fit.lsFromWs.transpose() * Vec3(q.x(), q.y(), fit.directional ? 0.0 : -1.0);
}

/// Rounding of positions in the light image, relative to the polygon's extent.
constexpr double FocusSlack = 1e-9;

/// The light image of a point, in the fit's light space.
Vec2 imageOf(const ShadowFit& fit, const Vec3& ws) {
    const Vec3 ls = fit.lsFromWs * (ws - fit.wsEye);
    return fit.directional ? Vec2(ls.head<2>()) : Vec2(ls.head<2>() / -ls.z());
}

/// Whether casters were drawn on a light ray: on others the map shows none.
bool isDrawnAt(const ShadowFit& fit, const Vec2& q) {
    const std::span<const Vec2> focus = fit.liFocus.span();
    double extent = 0.0;
    for (const Vec2& vertex : focus)
        extent = std::max(extent, (vertex - focus.front()).norm());
    for (std::size_t i = 0; i < focus.size(); ++i) {
        const Vec2 edge = focus[(i + 1) % focus.size()] - focus[i];
        const Vec2 way = q - focus[i];
        if (!(edge.x() * way.y() - edge.y() * way.x() >= -FocusSlack * extent * edge.norm()))
            return false;
    }
    return true;
}

/// The area, in clip space, of a unit square across the light at a point; 0 behind the light.
double density(const ShadowFit& fit, const Vec3& ws, const Vec3& across, const Vec3& along) {
    const Vec4 clip = fit.clipFromWorld * ws.homogeneous();
    if (!(clip.w() > 0.0)) return 0.0;
    const auto change = [&](const Vec3& direction) {
        const Vec4 d = fit.clipFromWorld.leftCols<3>() * direction;
        return Vec2((d.head<2>() * clip.w() - clip.head<2>() * d.w()) / (clip.w() * clip.w()));
    };
    const Vec2 a = change(across);
    const Vec2 b = change(along);
    return std::abs(a.x() * b.y() - a.y() * b.x());
}

} // namespace

KeptFit compareFits(const ShadowFit& kept, const ShadowFit& fresh, const Vec3& wsShift) noexcept {
    if (!kept.hasMap() || !fresh.hasMap()) return {};
    const std::span<const Vec2> focus = fresh.liFocus.span();
    if (focus.empty()) return {};

    constexpr double Limit = 1.0 + EdgeSlack;
    for (const Vec2& q : focus) {
        const Vec3 ws = pointOn(fresh, q) + wsShift;
        const Vec4 clip = kept.clipFromWorld * ws.homogeneous();
        if (!isDrawnAt(kept, imageOf(kept, ws)) || !(clip.w() > 0.0) ||
            !(std::abs(clip.x()) <= Limit * clip.w()) || !(std::abs(clip.y()) <= Limit * clip.w()))
            return {};
    }
    // Both ends of the fresh depth range; casters in front of it are clamped in either map.
    const Vec3 wsAxis = fresh.lsFromWs.row(2);
    for (const double distance : {fresh.lsNear, fresh.lsFar}) {
        const Vec3 ws = fresh.wsEye - distance * wsAxis + wsShift;
        const double z = kept.clipFromWorld.row(2).dot(ws.homogeneous());
        const double depth = kept.depthScale * z + kept.depthOffset;
        if (!(depth >= -DepthSlack && depth <= 1.0 + DepthSlack)) return {};
    }

    const Vec3 across = fresh.lsFromWs.row(0);
    const Vec3 along = fresh.lsFromWs.row(1);
    Vec2 middle = Vec2::Zero();
    for (const Vec2& q : focus)
        middle += q / static_cast<double>(focus.size());
    double sum = 0.0;
    double weights = 0.0;
    const auto add = [&](const Vec2& q) {
        const Vec3 ws = pointOn(fresh, q);
        const double now = density(fresh, ws, across, along);
        const double then = density(kept, ws + wsShift, across, along);
        if (!(now > 0.0) || !(then > 0.0)) return;
        sum += now * std::sqrt(now / then);
        weights += now;
    };
    add(middle);
    for (std::size_t i = 0; i < focus.size(); ++i) {
        const Vec2& q = focus[i];
        const Vec2 edge = (q + focus[(i + 1) % focus.size()]) / 2.0;
        for (const Vec2& end : {q, edge}) {
            // Not the vertices themselves, where a map may end.
            add(middle + 0.95 * (end - middle));
            add(middle + 0.5 * (end - middle));
        }
    }
    if (!(weights > 0.0) || !std::isfinite(sum)) return {};
    return {true, sum / weights};
}

} // namespace Lixel
