#include "fit/technique/Psm.h"

#include "fit/core/Declare.h"
#include "fit/core/Warp.h"
#include "fit/geometry/Cone.h"
#include "fit/rule/ViewDepth.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace Lixel {
namespace {

/// Least ratio of far and near plane: all receivers may be at one depth.
constexpr double LeastFarRatio = 1.0 + 1e-3;

WarpChoice psmWarp(const WarpContext& context, const PsmOptions& options, RuleState state) {
    const FocusRegion& region = context.region;
    const LightImage& image = context.image;
    const ViewImage& view = context.view;
    if (!context.hasDepths()) return {};
    if (image.directional() && view.vanishes()) return {Vec2::Zero(), FitReason::LightAlongView};

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

    std::vector<Vec3>& directions = state.scratch.directions;
    directions.clear();
    for (const Vec2& q : region.liHull)
        directions.push_back((fromLightImage * q.homogeneous()).stableNormalized());
    const Vec3 covector = fromLightImage.transpose() * smallestConeAxis(directions);
    const Vec2 warp = warpOf(covector, region.liHull, region.liCentre);
    if (!image.directional()) return {warp, FitReason::None};
    return {view.fade * warp, view.reason()};
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

const FitTechnique& PsmOptions::technique() {
    static constexpr std::array options{
        option<&PsmOptions::slideBack>(
            "slide_back", atLeast(0.0), "",
            "how far the virtual viewer slides back, relative to the geometric mean of the nearest "
            "and farthest receiver's depth: 0 favours the near, 1 makes near and far alike"),
    };
    static constexpr FitTechnique declared =
        declare<PsmOptions, psmWarp>("PSM", "perspective, in the viewer's space",
                                     "Stamminger and Drettakis 2002, Kozlov 2004", options);
    return declared;
}

} // namespace Lixel
