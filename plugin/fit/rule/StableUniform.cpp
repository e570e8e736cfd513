#include "fit/rule/StableUniform.h"

#include "fit/core/MapPlacement.h"
#include "fit/focus/ViewVolume.h"
#include "fit/problem/ShadowPart.h"

#include <algorithm>
#include <cmath>

namespace Lixel {
namespace {

/// Steps of the sphere's radius, relative to it. A float's view matrix makes it differ by 1e-7 from
/// frame to frame, and a grid of texels that is counted from the world's origin with it.
constexpr double RadiusStep = 1.0 / 1024.0;

/// Steps of the search for the sphere's centre. Each leaves two thirds of the interval: 5e-6 of it
/// in the end.
constexpr int CentreSteps = 30;

/// Beyond the cone or the sphere, for what rounding adds to both.
constexpr double Slack = 1e-6;

/// Texels kept free for the rounding of positions to float. It may not depend on where receivers
/// are; this is enough where they are as far from the viewer as 1000 texels are wide.
constexpr double PositionBorder = 0.25;

struct Sphere {
    Vec3 centre;
    double radius;
};

/// Corners of all that is in view of the problem's part, in view space, where it stays as it is
/// while the viewer turns and moves; none for a view without end.
const std::vector<Vec3>& vsCornersInView(const ShadowProblem& problem, RuleScratch& scratch) {
    std::vector<Vec3>& points = scratch.vsPoints;
    points.clear();
    ShadowViewer viewer = problem.viewer;
    viewer.viewFromWorld = Mat4::Identity();
    Aabb box;
    if (!viewBounds(viewer, box)) return points;
    ConvexVolume volume = viewVolume(viewer);
    const Mat4& viewFromWorld = problem.viewer.viewFromWorld;
    if (problem.part != nullptr)
        for (const HalfSpace& plane : problem.part->bounds()) {
            const Vec3 vsNormal = viewFromWorld.topLeftCorner<3, 3>() * plane.normal;
            volume.add(vsNormal, plane.offset - vsNormal.dot(viewFromWorld.topRightCorner<3, 1>()));
        }
    clipBox(box, volume, scratch.clip, points);
    return points;
}

/// A small sphere around points in view space. Its centre is looked for between the middles of the
/// nearer and the farther half, where it is for all views that are alike on both sides.
Sphere vsSphereAround(const std::vector<Vec3>& points) {
    double nearest = -points[0].z();
    double farthest = nearest;
    for (const Vec3& p : points) {
        nearest = std::min(nearest, -p.z());
        farthest = std::max(farthest, -p.z());
    }
    Vec3 sums[2] = {Vec3::Zero(), Vec3::Zero()};
    double counts[2] = {0.0, 0.0};
    for (const Vec3& p : points) {
        const std::size_t half = -p.z() > (nearest + farthest) / 2.0 ? 1 : 0;
        sums[half] += p;
        counts[half] += 1.0;
    }
    const Vec3 begin = sums[0] / std::max(counts[0], 1.0);
    const Vec3 way = counts[1] > 0.0 ? Vec3(sums[1] / counts[1] - begin) : Vec3(Vec3::Zero());
    const auto radiusAt = [&](double t) {
        double squared = 0.0;
        for (const Vec3& p : points)
            squared = std::max(squared, (p - begin - t * way).squaredNorm());
        return std::sqrt(squared);
    };
    // Convex in t: the greatest of some distances.
    double lower = 0.0;
    double upper = 1.0;
    for (int i = 0; i < CentreSteps; ++i) {
        const double third = (upper - lower) / 3.0;
        if (radiusAt(lower + third) < radiusAt(upper - third))
            upper -= third;
        else
            lower += third;
    }
    const double t = (lower + upper) / 2.0;
    return {begin + t * way, radiusAt(t) * (1.0 + Slack)};
}

/// A sphere around all that is in view of the problem's part; false for a view without end.
bool sphereInView(const ShadowProblem& problem, RuleState state, Sphere& sphere) {
    const std::vector<Vec3>& points = vsCornersInView(problem, state.scratch);
    if (points.empty()) return false;
    const Sphere vsSphere = vsSphereAround(points);
    const double radius = vsSphere.radius;
    if (!std::isfinite(radius) || !(radius > 0.0)) return false;
    // The last frame's where it is hardly larger.
    double& steady = state.memory.stableRadius;
    if (!(steady >= radius) || steady > radius * (1.0 + 2.0 * RadiusStep))
        steady = radius * (1.0 + RadiusStep);
    const Mat4& viewFromWorld = problem.viewer.viewFromWorld;
    sphere = {viewFromWorld.topLeftCorner<3, 3>().transpose() *
                  (vsSphere.centre - viewFromWorld.topRightCorner<3, 1>()),
              steady};
    return true;
}

/// The homography of a map that shows a square of the light image.
/// @param middle the square's middle, in the map's own axes
Mat3 squareMap(const Vec2& axis, const Vec2& middle, double half, const Vec2& inner,
               const Vec2& size) {
    const Vec2 scale = inner.cwiseQuotient(size) / half;
    Mat3 map = Mat3::Identity();
    map.topLeftCorner<2, 2>() << axis.x(), axis.y(), -axis.y(), axis.x();
    map.topRightCorner<2, 1>() = -middle;
    map.topRows<2>() = scale.asDiagonal() * map.topRows<2>().eval();
    return map;
}

/// The map's x axis in the light image: the last frame's, carried along with the light, so that a
/// sun that moves turns the texels with it and no further. Light space itself may turn at once.
Vec2 steadyAxis(const LightImage& image, FitMemory& memory) {
    // Least length of the last axis, a unit vector, in the new light image. Where it is shorter,
    // the light has turned too far to keep it.
    constexpr double LeastLength = 0.5;
    // Where nothing moved, nothing may creep.
    constexpr double Same = 1e-12;
    Vec2 axis = Vec2::UnitX();
    if (memory.wsMapAxes) {
        const Vec2 kept = image.lsFromDirection(memory.wsMapAxes->front()).head<2>();
        if (std::abs(kept.norm() - 1.0) < Same) return kept;
        if (kept.norm() > LeastLength) axis = kept.normalized();
    }
    memory.wsMapAxes = axesInWorld({{axis, Vec2(-axis.y(), axis.x())}}, image);
    return axis;
}

} // namespace

WarpChoice stableMap(const WarpContext& context, RuleState state) {
    const ShadowProblem& problem = context.problem;
    const LightImage& image = context.image;
    const Vec2 size(problem.mapWidth, problem.mapHeight);
    const double border = leastBorder(problem.filterRadius) + PositionBorder;
    WarpChoice choice;
    if (!image.directional()) {
        // Not narrower than what leaves texels to a float.
        const double half = std::max(std::tan(problem.light.outerHalfAngle) * (1.0 + Slack),
                                     LeastTexel * size.maxCoeff());
        // In light space's own axes: its planes around the cone fit into this square alone.
        choice.homography =
            squareMap(Vec2::UnitX(), Vec2::Zero(), half, size - Vec2::Constant(2.0 * border), size);
        return choice;
    }
    Sphere sphere;
    // One texel more: snapping moves the middle by up to half a texel from the sphere's.
    const Vec2 inner = size - Vec2::Constant(2.0 * border + 1.0);
    if (!(inner.minCoeff() > 0.0) || !sphereInView(problem, state, sphere)) {
        choice.reason = FitReason::ViewWithoutEnd;
        return choice;
    }
    const Vec2 axis = steadyAxis(image, state.memory);
    const auto turned = [&](const Vec3& ls) {
        return Vec2(axis.dot(ls.head<2>()), cross(axis, ls.head<2>()));
    };
    // Texels are counted from the world's own origin.
    const Vec2 origin = turned(image.lsFromDirection(problem.wsOrigin));
    const Vec2 middle = turned(image.lsFromPoint(sphere.centre));
    const Vec2 texel = (2.0 * sphere.radius * inner.cwiseInverse()).eval();
    const Vec2 snapped =
        (origin + middle).cwiseQuotient(texel).array().round().matrix().cwiseProduct(texel) -
        origin;
    choice.homography = squareMap(axis, snapped, sphere.radius, inner, size);
    return choice;
}

} // namespace Lixel
