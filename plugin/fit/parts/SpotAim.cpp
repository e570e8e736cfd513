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
    spot = light;
    spot.kind = LightKind::Spot;
    spot.wsDirection = axis;
    spot.outerHalfAngle = std::max(halfAngle, NarrowestAim);
    // The near distance is a sphere's radius; this plane does not reach into it.
    spot.nearDistance = light.nearDistance * std::cos(spot.outerHalfAngle);
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

} // namespace Lixel
