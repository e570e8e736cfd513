#include "fit/FocusRegion.h"

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <numbers>

namespace Lixel {
namespace {

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Number of planes around a spot's cone. Eight overestimate its radius by 1/cos(π/8) = 8 %.
constexpr int ConeSides = 8;

/// The space a local light shines into, in world axes: in front of its near distance, within its
/// range, inside a pyramid around its cone. Everything for a directional light.
void addLightVolume(const ShadowLight& light, const LightImage& image, ConvexVolume& volume) {
    if (image.directional()) return;
    const Vec3 axis = -image.lsFromWs().row(2).transpose();
    const Vec3& eye = image.wsEye();
    const auto add = [&](const Vec3& normal, double distance) {
        volume.add(normal, -normal.dot(eye) - distance);
    };
    add(axis, light.nearDistance);
    if (std::isfinite(light.range)) add(-axis, -light.range);
    for (int i = 0; i < ConeSides; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / ConeSides;
        const Vec3 side = image.lsFromWs().transpose() * Vec3(std::cos(turn), std::sin(turn), 0.0);
        // The plane through the apex that touches the cone along `side`.
        add(std::sin(light.outerHalfAngle) * axis - std::cos(light.outerHalfAngle) * side, 0.0);
    }
}

/// Appends to `points` the vertices of box ∩ volume.
void appendVisible(const Box& box, const ConvexVolume& volume, ClipScratch& scratch,
                   std::vector<Vec3>& points) {
    switch (volume.classify(box)) {
    case ConvexVolume::Side::Outside:
        return;
    case ConvexVolume::Side::Inside:
        for (const Vec3& corner : corners(box))
            points.push_back(corner);
        return;
    case ConvexVolume::Side::Straddles:
        clipBox(box, volume, scratch, points);
        return;
    }
}

/// A box that holds the volume, for bodies without bounds; false where the volume has none either.
bool boundsOf(const ShadowViewer& viewer, Box& box) {
    const Mat4 clipFromWorld = viewer.clipFromView * viewer.viewFromWorld;
    const Mat4 worldFromClip = clipFromWorld.inverse();
    Vec3 lower = Vec3::Constant(Infinity);
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
        double t = farCorner.w() > 0.0 ? 1.0 / farCorner.w() : Infinity;
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

struct CasterReach {
    bool reaches = false;
    double lsNear = 0.0;
};

/// Whether a caster's image, given as points, can touch the polygon: no edge separates them.
bool mayTouch(std::span<const Vec2> caster, const Polygon2& polygon) {
    for (std::size_t i = 0; i < polygon.size() && polygon.size() > 1; ++i) {
        const Vec2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        if (support(caster, Vec2(-edge.y(), edge.x())) < cross(edge, polygon[i])) return false;
    }
    return true;
}

} // namespace

void findFocusRegion(const ShadowProblem& problem, const LightImage& image, FocusScratch& scratch,
                     FocusRegion& region) {
    region = FocusRegion{.reason = FitReason::None, .liHull = std::move(region.liHull)};
    region.liHull.clear();
    const auto stop = [&](FitReason reason) { region.reason = reason; };

    const BoxSet& casters = *problem.casters;
    const BoxSet& receivers = *problem.receivers;
    if (casters.empty()) return stop(FitReason::NoCasters);

    // Visible receivers, clipped to what the viewer sees and the light reaches.
    const ConvexVolume view = viewVolume(problem.viewer);
    ConvexVolume seen = view;
    addLightVolume(problem.light, image, seen);
    scratch.wsPoints.clear();
    for (const Box& box : receivers.boxes())
        appendVisible(box, seen, scratch.clip, scratch.wsPoints);
    if (receivers.unbounded() > 0) {
        Box box;
        if (!boundsOf(problem.viewer, box)) return stop(FitReason::Unbounded);
        appendVisible(box, seen, scratch.clip, scratch.wsPoints);
        region.reason = FitReason::UnboundedBody;
    }
    if (scratch.wsPoints.empty()) return stop(FitReason::NoReceivers);

    region.lsReceiverNear = region.vsReceiverNear = Infinity;
    region.lsReceiverFar = region.vsReceiverFar = -Infinity;
    const Vec4 vsDepth = -problem.viewer.viewFromWorld.row(2).transpose();
    scratch.points.clear();
    for (const Vec3& ws : scratch.wsPoints) {
        const Vec3 ls = image.lsFromPoint(ws);
        const double lsDepth = -ls.z();
        // A clipped vertex lies on the near plane but for rounding; nothing is divided by less.
        if (!image.directional() && lsDepth < 0.5 * problem.light.nearDistance) continue;
        const double depth = vsDepth.head<3>().dot(ws) + vsDepth.w();
        region.lsReceiverNear = std::min(region.lsReceiverNear, lsDepth);
        region.lsReceiverFar = std::max(region.lsReceiverFar, lsDepth);
        region.vsReceiverNear = std::min(region.vsReceiverNear, depth);
        region.vsReceiverFar = std::max(region.vsReceiverFar, depth);
        scratch.points.push_back(image.project(ls));
    }
    if (scratch.points.empty()) return stop(FitReason::NoReceivers);
    convexHull(scratch.points, scratch.receiverHull);

    // Casters between the light and a visible receiver.
    region.lsCasterNear = Infinity;
    bool any = casters.unbounded() > 0;
    scratch.points.clear();
    ConvexVolume lit;
    addLightVolume(problem.light, image, lit);
    std::array<Vec2, 8> box8;
    for (const Box& box : casters.boxes()) {
        const std::size_t before = scratch.points.size();
        double nearest = Infinity;
        if (image.directional()) {
            const Vec3 centre = image.lsFromPoint(box.centre);
            const double radius =
                image.lsFromWs().row(2).cwiseAbs().dot(box.halfExtents.transpose());
            nearest = -centre.z() - radius;
            if (nearest > region.lsReceiverFar) continue;
            const auto corner = corners(box);
            for (std::size_t i = 0; i < 8; ++i)
                box8[i] = image.project(image.lsFromPoint(corner[i]));
            scratch.points.insert(scratch.points.end(), box8.begin(), box8.end());
        } else {
            scratch.wsPoints.clear();
            appendVisible(box, lit, scratch.clip, scratch.wsPoints);
            for (const Vec3& ws : scratch.wsPoints) {
                const Vec3 ls = image.lsFromPoint(ws);
                if (-ls.z() < 0.5 * problem.light.nearDistance) continue;
                nearest = std::min(nearest, -ls.z());
                scratch.points.push_back(image.project(ls));
            }
        }
        const std::span<const Vec2> mine(scratch.points.data() + before,
                                         scratch.points.size() - before);
        if (mine.empty() || nearest > region.lsReceiverFar ||
            !mayTouch(mine, scratch.receiverHull)) {
            scratch.points.resize(before);
            continue;
        }
        any = true;
        region.lsCasterNear = std::min(region.lsCasterNear, nearest);
    }
    if (!any) return stop(FitReason::NothingShadowed);
    if (casters.unbounded() > 0) {
        region.reason = FitReason::UnboundedBody;
        region.lsCasterNear = region.lsReceiverNear;
        region.liHull = scratch.receiverHull;
    } else {
        convexHull(scratch.points, scratch.casterHull);
        intersect(scratch.receiverHull, scratch.casterHull, region.liHull, scratch.polygon);
    }
    if (region.liHull.empty()) return stop(FitReason::NothingShadowed);
    region.liCentre = steinerPoint(region.liHull);
}

} // namespace Lixel
