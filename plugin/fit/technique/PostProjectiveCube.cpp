#include "fit/technique/PostProjectiveCube.h"

#include "fit/core/Declare.h"
#include "fit/core/Warp.h"
#include "fit/problem/ShadowPart.h"
#include "fit/rule/ViewDepth.h"

#include <array>

#include <Eigen/Geometry>

#include <cmath>

namespace Lixel {
namespace {

WarpChoice faceWarp(const WarpContext& context, const CubeOptions& options) {
    const ShadowPart* const part = context.problem.part;
    const FocusRegion& region = context.region;
    if (part == nullptr || part->wsExit.isZero(0.0) || !context.hasDepths()) return {};
    const DepthRange depths = ViewDepth(context).ofRegion(context);
    const double slideBack = options.slideBack * std::sqrt(depths.nearest * depths.farthest);

    Eigen::RowVector4d depth = -context.problem.viewer.viewFromWorld.row(2);
    depth.w() += slideBack;
    const Vec4& face = part->wsExit;
    const Vec4 light = context.image.wsLight();
    // Row w of C ((n . L) I - L n^T), with n . L > 0 for all faces that rays leave through.
    const Eigen::RowVector4d row = face.dot(light) * depth - depth.dot(light) * face.transpose();
    const Vec3 covector = (row * context.image.wsFromOriented()).transpose();
    return {warpOf(covector, region.liHull, region.liCentre), FitReason::None};
}

} // namespace

const FitTechnique& CubeOptions::technique() {
    static constexpr std::array options{
        option<&CubeOptions::slideBack>("slide_back", atLeast(0.0), "", "as for PSM"),
    };
    static constexpr FitTechnique declared = declare<CubeOptions, faceWarp>(
        "PostProjectiveCube", "cube map of post-projective space", "Kozlov 2004", options);
    return declared;
}

} // namespace Lixel
