#include "fit/technique/Optimal.h"

#include "fit/core/Declare.h"
#include "fit/rule/WarpSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace Lixel {
namespace {

/// Bounds of the options, so that bad ones cost neither the map nor the frame.
constexpr int LeastEvaluations = 8;
constexpr int MostEvaluations = 4096;
constexpr int MostSamples = 4096;

/// A frame that follows another takes one in this many of the evaluations.
constexpr int FollowingPart = 4;

/// Direction in which the view's rays run in the light image at the region's centre; zero where
/// they do not, as for a light along the view.
Vec2 viewDirectionAt(const WarpContext& context) {
    // d(xy / z) = (dxy - q dz) / z; for a directional light dz = 0.
    const Vec3& direction = context.viewDirection;
    return direction.head<2>() - direction.z() * context.region.liCentre;
}

/// Searches all directions and strengths.
WarpSearch::Judged bestOfAll(const WarpContext& context, WarpSearch& search, int evaluations) {
    WarpSearch::Judged best;
    const auto consider = [&](const WarpSearch::Judged& judged) {
        if (judged.cost < best.cost) best = judged;
    };
    // Along the view first, where near and far differ most.
    int left = evaluations;
    Vec2 direction = viewDirectionAt(context);
    if (direction.norm() > 0.0) {
        direction.normalize();
        consider(search.along(direction, WarpSearch::GreatestSpread, evaluations / 3));
        left -= evaluations / 3;
    } else {
        direction = Vec2::UnitX();
    }
    // Elsewhere there may be a better place to start from, above all where that found little.
    const double length = std::max(best.spread.norm(), WarpSearch::ProbedSpread);
    const int probes = left / 3;
    for (int i = 1; i <= probes; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / (probes + 1);
        consider(search.judge(
            length * Vec2(std::cos(angle) * direction.x() - std::sin(angle) * direction.y(),
                          std::sin(angle) * direction.x() + std::cos(angle) * direction.y())));
    }
    return search.around(best, left - probes);
}

WarpChoice optimalWarp(const WarpContext& context, const OptimalOptions& options, RuleState state) {
    const WarpSearch::Sampling sampling{
        .most = static_cast<std::size_t>(std::clamp(options.samples, 1, MostSamples)),
        .edgeWeight = std::clamp(options.edgeWeight, 0.0, 1.0)};
    WarpSearch search(context, sampling, state);
    WarpSearch::Judged best;
    if (search.usable()) {
        const int evaluations = std::clamp(options.evaluations, LeastEvaluations, MostEvaluations);
        const auto target = search.target();
        best = target
                   ? search.follow(*target, std::max(evaluations / FollowingPart, LeastEvaluations))
                   : bestOfAll(context, search, evaluations);
    }
    WarpChoice choice;
    choice.liWarp = search.warp(search.settle(best));
    if (options.skewedMaps) choice.axes = search.axes(choice.liWarp, state.memory.wsMapAxes);
    return choice;
}

} // namespace

const FitTechnique& OptimalOptions::technique() {
    static constexpr std::array options{
        option<&OptimalOptions::samples>(
            "samples", between(1, MostSamples), "",
            "points of the picture by which warps are judged, at most; about half as many where "
            "shadows fill little of the picture"),
        option<&OptimalOptions::evaluations>(
            "evaluations", between(LeastEvaluations, MostEvaluations), "",
            "warps judged after a camera cut; a quarter of it, and at least 8, in a frame that "
            "follows another"),
        option<&OptimalOptions::edgeWeight>(
            "edge_weight", between(0.0, 1.0), "",
            "how much more those points count around which casters' boxes, as the light sees them, "
            "have many edges; 0: all alike, which takes less time"),
        option<&OptimalOptions::skewedMaps>(
            "skewed_maps",
            "whether a map may be a parallelogram as the light sees it, where that makes texels "
            "smaller"),
    };
    static constexpr FitTechnique declared = declare<OptimalOptions, optimalWarp>(
        "Optimal", "texels smallest where the viewer looks", "Chong 2006, §3.3", options);
    return declared;
}

} // namespace Lixel
