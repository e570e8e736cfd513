#include "fit/parts/SpotAim.h"

#include "fit/focus/LightVolume.h"
#include "fit/focus/ViewVolume.h"
#include "fit/geometry/Cone.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace Lixel {
namespace {

/// Widening of the cone, in radians: directions on its rim stay within, rounded as they are.
constexpr double RimSlack = 1e-6;

/// Narrowest cone, as half angle in radians: a body that is a point from there.
constexpr double NarrowestAim = 1e-4;

/// Directions from the light to all that the volume leaves of the boxes.
/// @return whether there are any
bool directionsTo(const BoxSet& boxes, const ConvexVolume& volume, const Vec3& wsLight,
                  AimScratch& scratch) {
    scratch.directions.clear();
    for (const Aabb& box : boxes.boxes()) {
        const ConvexVolume::Side side = volume.classify(box);
        if (side == ConvexVolume::Side::Outside) continue;
        scratch.wsPoints.clear();
        if (side == ConvexVolume::Side::Inside) {
            const auto eight = corners(box);
            scratch.wsPoints.assign(eight.begin(), eight.end());
        } else {
            clipBox(box, volume, scratch.clip, scratch.wsPoints);
        }
        for (const Vec3& ws : scratch.wsPoints) {
            const Vec3 direction = ws - wsLight;
            if (!direction.isZero(0.0)) scratch.directions.push_back(direction);
        }
    }
    return !scratch.directions.empty();
}

/// Length of the mean of unit vectors below which they point all around.
constexpr double LeastCommon = 0.1;

/// Cosine of the angle to the mean, 15°, beyond which the last axis is given up: what the cone of 80°
/// loses on one side by then is a fifth of it.
constexpr double KeptAimCosine = 0.9659258262890683;

/// The light as a spot.
ShadowLight asSpot(const ShadowLight& light, const Vec3& axis, double halfAngle) {
    ShadowLight spot = light;
    spot.kind = LightKind::Spot;
    spot.wsDirection = axis;
    spot.outerHalfAngle = std::max(halfAngle, NarrowestAim);
    // The near distance is a sphere's radius; this plane does not reach into it.
    spot.nearDistance = light.nearDistance * std::cos(spot.outerHalfAngle);
    return spot;
}

/// Sums up in which directions light reaches points, weighed by the cosines at which it does.
struct LitMean {
    const ShadowLight& light;
    Vec3 sum = Vec3::Zero();
    double weight = 0.0;

    void add(const VisiblePoint& point) {
        const Vec3 away = point.ws - light.wsPosition;
        const double distance = away.norm();
        if (!(distance > light.nearDistance && distance <= light.range)) return;
        const double cosine = std::max(-point.wsNormal.dot(away) / distance, 0.0);
        sum += cosine * away / distance;
        weight += cosine;
    }
    /// Whether the directions have something in common.
    bool isClear() const { return sum.allFinite() && sum.norm() > LeastCommon * weight; }
};

} // namespace

bool spotAround(const ShadowLight& light, double widest, std::vector<Vec3>& directions,
                ShadowLight& spot) {
    for (Vec3& direction : directions)
        direction.stableNormalize();
    const Vec3 axis = smallestConeAxis(directions, widest);
    if (axis.isZero(0.0)) return false;
    double leastCosine = 1.0;
    for (const Vec3& direction : directions)
        leastCosine = std::min(leastCosine, direction.dot(axis));
    const double halfAngle = std::acos(std::clamp(leastCosine, -1.0, 1.0)) + RimSlack;
    if (directions.empty() || !(halfAngle <= widest)) return false;
    spot = asSpot(light, axis, halfAngle);
    return true;
}

bool aimSpot(const ShadowProblem& problem, AimScratch& scratch, ShadowLight& spot) {
    const ShadowLight& light = problem.light;
    ConvexVolume seen = viewVolume(problem.viewer);
    ConvexVolume reached;
    addRange(light, seen);
    addRange(light, reached);

    bool found = false;
    const auto tryAround = [&](const BoxSet& boxes, const ConvexVolume& volume) {
        if (boxes.unbounded() > 0) return;
        // Nothing to shadow: any cone does.
        if (!directionsTo(boxes, volume, light.wsPosition, scratch))
            scratch.directions.assign(1, Vec3(light.wsDirection));
        ShadowLight around;
        if (!spotAround(light, WidestAim, scratch.directions, around)) return;
        if (!found || around.outerHalfAngle < spot.outerHalfAngle) spot = around;
        found = true;
    };
    tryAround(*problem.receivers, seen);
    tryAround(*problem.casters, reached);
    return found;
}

ShadowLight widestSpot(const ShadowProblem& problem, AimScratch& scratch,
                       std::optional<Vec3>& wsAxis) {
    const ShadowViewer& viewer = problem.viewer;
    LitMean mean{problem.light};
    for (const VisiblePoint& point : problem.visiblePoints)
        mean.add(point);
    if (problem.visiblePoints.empty()) {
        scratch.rays.cast(withDepthAhead(viewer.clipFromView) * viewer.viewFromWorld, 0);
        scratch.rays.meet(*problem.receivers, {});
        for (std::size_t i = 0; i < ViewRays::Count; ++i)
            if (scratch.rays.hit(i)) mean.add(scratch.rays.point(i));
    }
    // Where it reaches nothing that is seen, as the viewer looks.
    const Vec3 ahead = -viewer.viewFromWorld.row(2).head<3>();
    const Vec3 axis = (mean.isClear() ? mean.sum : ahead).stableNormalized();
    const bool keeps = wsAxis && (!mean.isClear() || wsAxis->dot(axis) >= KeptAimCosine);
    if (!keeps) wsAxis = axis;
    return asSpot(problem.light, *wsAxis, WidestAim);
}

} // namespace Lixel
