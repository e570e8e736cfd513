#include "fit/technique/Psm.h"

#include "fit/core/Fit.h"
#include "fit/core/Warp.h"
#include "fit/geometry/Cone.h"
#include "fit/technique/ViewDepth.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace Lixel {
namespace {

/// Least ratio of far and near plane: all receivers may be at one depth.
constexpr double LeastFarRatio = 1.0 + 1e-3;

WarpChoice psmWarp(const WarpContext& context, const PsmOptions& options) {
    const FocusRegion& region = context.region;
    const LightImage& image = context.image;
    if (!context.perspective || !(region.vsReceiverFar > 0.0)) return {};
    const double sine = context.viewDirection.head<2>().norm();
    if (image.directional() && !(sine > 0.0)) return {Vec2::Zero(), FitReason::LightAlongView};

    const DepthRange depths = ViewDepth(context).ofRegion(context);
    const double farthest = std::max(depths.farthest, LeastFarRatio * depths.nearest);
    const double slideBack = options.slideBack * std::sqrt(depths.nearest * farthest);
    const Mat4 clip = virtualViewer(context.problem.viewer, slideBack, depths.nearest, farthest);

    // Directions in post-projective space, from the light, of the rays of the light image.
    const Vec4 light = clip * image.wsLight();
    Eigen::Matrix<double, 3, 4> fromWorld;
    for (int row = 0; row < 3; ++row)
        fromWorld.row(row) = light.w() * clip.row(row) - light[row] * clip.row(3);
    const Mat3 fromLightImage = fromWorld * image.wsFromOriented();

    std::vector<Vec3>& directions = context.state.directions;
    directions.clear();
    for (const Vec2& q : region.liHull)
        directions.push_back((fromLightImage * q.homogeneous()).stableNormalized());
    const Vec3 covector = fromLightImage.transpose() * smallestConeAxis(directions);
    const Vec2 warp = warpOf(covector, region.liHull, region.liCentre);
    if (!image.directional()) return {warp, FitReason::None};
    const double fade = fadeBySine(sine);
    return {fade * warp, fade < 1.0 ? FitReason::LightAlongView : FitReason::None};
}

} // namespace

Mat4 virtualViewer(const ShadowViewer& viewer, double slideBack, double nearest, double farthest) {
    Mat4 back = Mat4::Identity();
    back(2, 3) = -slideBack;
    Mat4 clip = viewer.clipFromView * back;
    // Row w is the depth from the virtual viewer, times some factor; row z goes with it.
    const double factor = viewer.clipFromView.row(3).head<3>().norm();
    const double n = nearest + slideBack;
    const double f = farthest + slideBack;
    // OpenGL's ((f + n) depth - 2 f n) / (f - n), with depth = slideBack - z.
    clip.row(2) = factor / (f - n) *
                  Eigen::RowVector4d(0.0, 0.0, -(f + n), (f + n) * slideBack - 2.0 * f * n);
    return clip * viewer.viewFromWorld;
}

ShadowFit fitPsm(const ShadowProblem& problem, const PsmOptions& options,
                 FitState& state) noexcept {
    return fitWithRule(problem, state,
                       [&](const WarpContext& context) { return psmWarp(context, options); });
}

} // namespace Lixel
