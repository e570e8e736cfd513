#include "fit/Xpsm.h"

#include "fit/Fit.h"
#include "fit/Warp.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <optional>

namespace Lixel {
namespace {

/// Sine of the angle between view and light below which the warp fades out. Gusev switches at 0.1
/// (step 3); the fade is complete at twice that, so that it passes his threshold at half strength.
constexpr double FadeSine = 0.2;

/// Nearest depth, as a fraction of the farthest, that the strength is balanced with: a receiver
/// that touches the eye must not pull all texels to itself.
constexpr double LeastNearRatio = 1e-3;

/// Evaluations of the search. Golden section narrows the interval by 0.618 with each, to 1 % of it.
constexpr int SearchSteps = 10;

/// Gain over a uniform map, relative, from which on the search is believed in full. Boxes are a
/// coarse model of what is seen: less than a tenth is within its error.
constexpr double ClearGain = 0.1;

/// How much the logarithm of the denominators' ratio may change in a frame in which nothing moves
/// noticeably, a quarter of what a fit may change in all, and how much more for each relative
/// change of the region.
constexpr double SteadyStep = 0.005;
constexpr double SteadyGrowth = 5.0;

/// Relative change of the region from which on it is another one, as after a camera cut.
constexpr double AnotherRegion = 0.05;

/// Vertices of the focus region that the search keeps; the fit itself uses all.
constexpr std::size_t SearchVertices = 12;

double smoothstep(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/** Keeps a searched warp from jumping while the region hardly moves.

    The samples that the search judges by come and go one by one, and two warps can be equally good;
    so the ratio of denominators may change by SteadyStep, and by as much more as the region
   changes. A camera cut changes the region altogether, and is followed at once.
*/
double steadyLogRatio(const WarpContext& context, double logRatio) {
    const FocusRegion& region = context.region;
    double perimeter = 0.0;
    for (std::size_t i = 0; i < region.liHull.size(); ++i)
        perimeter += (region.liHull[(i + 1) % region.liHull.size()] - region.liHull[i]).norm();
    const Vec3 measures((region.liCentre - context.viewer.head<2>()).norm(), perimeter,
                        region.vsReceiverFar);
    std::optional<SearchMemory>& last = context.state.search;
    if (last) {
        const double change =
            ((measures - last->region).cwiseAbs().array() /
             (measures + last->region).cwiseAbs().array().max(std::numeric_limits<double>::min()))
                .maxCoeff();
        const double step = SteadyStep + SteadyGrowth * change;
        if (change < AnotherRegion)
            logRatio = std::clamp(logRatio, last->logRatio - step, last->logRatio + step);
    }
    last = SearchMemory{logRatio, measures};
    return logRatio;
}

/** The fraction of `warp` at which the expected texel extent is least, in [0, 1].

    Along a direction the extent has one minimum in the logarithm of the ratio between greatest and
    least denominator; the search runs in that, by golden section (Kiefer 1953), and compares with
    both ends. As the extent falls from no warp to that minimum, stopping short of it is never worse
    than no warp either.
*/
double bestFraction(const WarpContext& context, const Vec2& warp) {
    FitState& state = context.state;
    const FocusRegion& region = context.region;
    sampleView(context.problem, context.image, region, state.sampling, state.samples);
    if (state.samples.empty()) return 0.0;
    state.simpleHull = region.liHull;
    simplifyOutward(state.simpleHull, SearchVertices);

    // A simplified hull reaches farther than the hull: the warp must be safe on it too.
    Vec2 longest = warp;
    pullIntoSafeSet(state.simpleHull, region.liCentre, 0.0, longest);
    const WarpExtent extent = warpExtent(state.simpleHull, region.liCentre, longest, 0.0);
    // With denominators 1 - f A to 1 + f B at fraction f, their ratio is e^s at
    // f = (1 - e^-s) / (A + e^-s B).
    const double greatest = std::log((1.0 + extent.greatest) / (1.0 - extent.least));
    if (!(greatest > 0.0) || !std::isfinite(greatest)) return 0.0;
    const auto fractionAt = [&](double s) {
        const double r = std::exp(-s);
        return std::min(1.0, (1.0 - r) / (extent.least + r * extent.greatest));
    };
    const auto cost = [&](double s) {
        return expectedTexelExtent(state.samples, state.simpleHull, region.liCentre,
                                   fractionAt(s) * longest, state.warped);
    };
    constexpr double Golden = 0.6180339887498949;
    double lower = 0.0;
    double upper = greatest;
    double a = upper - Golden * (upper - lower);
    double b = lower + Golden * (upper - lower);
    double costA = cost(a);
    double costB = cost(b);
    for (int i = 2; i < SearchSteps; ++i) {
        if (costA < costB) {
            upper = b;
            b = a;
            costB = costA;
            a = upper - Golden * (upper - lower);
            costA = cost(a);
        } else {
            lower = a;
            a = b;
            costA = costB;
            b = lower + Golden * (upper - lower);
            costB = cost(b);
        }
    }
    double best = costA < costB ? a : b;
    double bestCost = std::min(costA, costB);
    if (const double costAll = cost(greatest); costAll < bestCost) {
        best = greatest;
        bestCost = costAll;
    }
    const double gain = 1.0 - bestCost / cost(0.0);
    const double belief = smoothstep(gain / ClearGain);
    const double found = belief * fractionAt(best);
    const double steady = steadyLogRatio(
        context, std::log((1.0 + found * extent.greatest) / (1.0 - found * extent.least)));
    return fractionAt(std::min(steady, greatest)) * (longest.norm() / warp.norm());
}

WarpChoice xpsmWarp(const WarpContext& context, const XpsmOptions& options) {
    const FocusRegion& region = context.region;
    if (!context.image.directional() || !context.perspective) return {};
    if (!(options.strength > 0.0) || !(region.vsReceiverFar > 0.0)) return {};

    // §3.1: along the image of the view direction, whose length is the sine between view and light.
    const Vec2 along = context.viewDirection.head<2>();
    const double sine = along.norm();
    if (!(sine > 0.0)) return {Vec2::Zero(), FitReason::LightAlongView};
    const Vec2 direction = along / sine;
    const double fade = smoothstep(sine / FadeSine);

    // §3.2: at depth t in front of the viewer the denominator is affine in t, f0 + t f1; f1 / f0 =
    // coef is lengthP = coef / cos γ. Depths stand for the scale of the scene, and the warp is
    // about the region's centre instead of the viewer.
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
    if (options.guarded && !warp.isZero(0.0)) warp *= bestFraction(context, warp);
    return {warp, fade < 1.0 ? FitReason::LightAlongView : reason};
}

} // namespace

ShadowFit fitXpsm(const ShadowProblem& problem, const XpsmOptions& options,
                  FitState& state) noexcept {
    return fitWithRule(problem, state,
                       [&](const WarpContext& context) { return xpsmWarp(context, options); });
}

} // namespace Lixel
