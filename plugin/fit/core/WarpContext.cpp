#include "fit/core/WarpContext.h"

#include "fit/core/MapPlacement.h"
#include "fit/geometry/Smoothstep.h"

#include <Eigen/LU>

#include <algorithm>

namespace Lixel {
namespace {

/// Depth from which on a local light's receivers keep their margin against rounding, relative to
/// the farthest's: those in the first part of a spot's depth are few, and must not cost the map.
constexpr double NearestExactDepth = 1.0 / 64.0;

/// A projection's row w may hold rounding of this part of its constant and still be orthographic.
constexpr double NoPerspective = 1e-9;

ViewImage viewImage(const Vec3& viewDirection) {
    ViewImage view;
    const Vec2 along = viewDirection.head<2>();
    view.sine = along.norm();
    if (view.vanishes()) return view;
    view.direction = along / view.sine;
    view.fade = fadeBySine(view.sine);
    return view;
}

double liSizeOf(const Polygon2& hull) {
    return (support(hull, Vec2::UnitX()) + support(hull, -Vec2::UnitX())) +
           (support(hull, Vec2::UnitY()) + support(hull, -Vec2::UnitY()));
}

} // namespace

double fadeBySine(double sine, double complete) {
    return smoothstep(sine / complete);
}

RegionScale scaleOf(const LightImage& image, const FocusRegion& region) {
    const bool directional = image.directional();
    RegionScale scale{};
    scale.wsReach = std::max({std::abs(region.lsReceiverNear), std::abs(region.lsReceiverFar),
                              directional ? region.liCentre.norm() : image.wsEye().norm()});
    // Where receivers are a point at the origin, any length will do.
    if (!(scale.wsReach > 0.0)) scale.wsReach = 1.0;
    const double nearDepth =
        std::max(region.lsReceiverNear, region.lsReceiverFar * NearestExactDepth);
    scale.liReach = directional ? scale.wsReach : scale.wsReach / nearDepth;
    scale.liSize = liSizeOf(region.liHull);
    return scale;
}

WarpContext warpContext(const ShadowProblem& problem, const LightImage& image,
                        const FocusRegion& region) {
    const ShadowViewer& viewer = problem.viewer;
    const Mat4 worldFromView = viewer.viewFromWorld.inverse();
    const RegionScale scale = scaleOf(image, region);
    WarpContext context{
        .problem = problem,
        .image = image,
        .region = region,
        .viewer = image.oriented(image.lsFromPoint(worldFromView.topRightCorner<3, 1>())),
        .viewDirection = image.orientedDirection(
            image.lsFromDirection(-worldFromView.block<3, 1>(0, 2).stableNormalized())),
        .view = {},
        .perspective = viewer.clipFromView.row(3).head<3>().norm() >
                       NoPerspective * std::abs(viewer.clipFromView(3, 3)),
        .scale = scale,
        // At least the least texel that float positions allow, however small the region.
        .thickness = std::max(scale.liSize / std::max(problem.mapWidth, problem.mapHeight),
                              LeastTexel * scale.liReach),
    };
    context.view = viewImage(context.viewDirection);
    return context;
}

} // namespace Lixel
