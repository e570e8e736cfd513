#include "fit/technique/Xpsm.h"

#include "fit/core/Declare.h"
#include "fit/core/Warp.h"
#include "fit/rule/ViewDepth.h"
#include "fit/rule/WarpSearch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>

namespace Lixel {
namespace {

/// Evaluations of the guard's search. Golden section narrows the interval by 0.618 with each, to
/// 2 % of it.
constexpr int SearchSteps = 11;

/// Samples that the guard judges by. The warp chosen with 64 has, within a few percent, the error
/// of the warp chosen with a thousand.
constexpr std::size_t Samples = 64;

/** The warp between none and `warp` at which texels are expected to be smallest.

    As their extent falls from no warp to that minimum, stopping short of it is never worse than no
    warp either.
*/
Vec2 guardedWarp(const WarpContext& context, const Vec2& warp, RuleState state) {
    WarpSearch search(context, {.most = Samples}, state);
    Vec2 longest = warp;
    // A simplified hull reaches farther than the hull: the warp must be safe on it too.
    pullIntoSafeSet(search.hull(), context.region.liCentre, 0.0, longest);
    const Vec2 greatest = search.spread(longest);
    const double length = greatest.norm();
    if (!(length > 0.0) || !std::isfinite(length)) return Vec2::Zero();
    const Vec2 direction = greatest / length;
    WarpSearch::Judged best;
    if (search.usable()) {
        const auto target = search.target();
        best = target ? search.followAlong(direction, length, *target)
                      : search.along(direction, length, SearchSteps);
    }
    // What settles from frame to frame may lie beside the line, or beyond its end.
    const double settled = direction.dot(search.settle(best));
    return search.warp(std::clamp(settled, 0.0, length) * direction);
}

WarpChoice xpsmWarp(const WarpContext& context, const XpsmOptions& options, RuleState state) {
    const FocusRegion& region = context.region;
    if (!context.image.directional() || !context.hasDepths() || !(options.strength > 0.0))
        return {};

    // §3.1: along the image of the view direction, whose length is the sine between view and light.
    const auto& [direction, sine, fade] = context.view;
    if (context.view.vanishes()) return {Vec2::Zero(), FitReason::LightAlongView};

    // §3.2: at depth t in front of the viewer the denominator is affine in t, f0 + t f1.
    // Gusev's lengthP = coef / cos γ, with γ between the view direction and its image, makes
    // f1 / f0 = coef. The depths give the scale of the scene, and the warp is about the region's
    // centre instead of the viewer.
    const double farDepth = region.vsReceiverFar;
    const double nearDepth = std::max(region.vsReceiverNear, LeastNearRatio * farDepth);
    const double coef = options.strength / std::sqrt(nearDepth * farDepth);
    const double centre = direction.dot(region.liCentre);
    const double viewer = direction.dot(context.viewer.head<2>()) - centre;
    const double slope = sine - coef * viewer;
    double length = slope > 0.0 ? coef / slope : std::numeric_limits<double>::infinity();

    // §3.3, eq. (3): the region's least denominator, relative to the viewer's, is at least
    // epsilonW.
    FitReason reason = FitReason::None;
    const double epsilonW = std::clamp(options.epsilonW, 0.0, 1.0);
    const double lowest = -support(region.liHull, -direction) - centre;
    const double perLength = epsilonW * viewer - lowest;
    if (perLength > 0.0 && length * perLength > 1.0 - epsilonW) {
        length = (1.0 - epsilonW) / perLength;
        reason = FitReason::WarpClamped;
    }
    if (!std::isfinite(length)) return {};

    Vec2 warp = fade * length * direction;
    if (options.guarded && !warp.isZero(0.0)) warp = guardedWarp(context, warp, state);
    return {warp, fade < 1.0 ? FitReason::LightAlongView : reason};
}

} // namespace

const FitTechnique& XpsmOptions::technique() {
    static constexpr std::array options{
        option<&XpsmOptions::strength>(
            "strength", atLeast(0.0), "",
            "strength of the warp: 0 is uniform, 1 is LiSPSM's balance of near and far"),
        option<&XpsmOptions::epsilonW>(
            "epsilon_w", aboveAndAtMost(0.0, 1.0), "",
            "Gusev's εW: the least denominator in the focus region, relative to the viewer's; near "
            "1 a caster behind the viewer dampens the warp more"),
        option<&XpsmOptions::guarded>(
            "guarded",
            "whether the warp is weakened where that makes texels smaller in the picture, so that "
            "it is never expected to be worse than a uniform map; without, it is literally the "
            "paper's"),
    };
    static constexpr FitTechnique declared = declare<XpsmOptions, xpsmWarp>(
        "XPSM", "extended perspective shadow map", "Gusev 2007", options);
    return declared;
}

} // namespace Lixel
