#include "fit/Optimal.h"

#include "fit/WarpSearch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace Lixel {
namespace {

/// Bounds of the options, so that bad ones cost neither the map nor the frame.
constexpr int LeastEvaluations = 8;
constexpr int MostEvaluations = 4096;
constexpr int MostSamples = 4096;

/// Least spread that is probed beside the view's direction.
constexpr double ProbedSpread = 0.7;

/// Direction in which the view's rays run in the light image at the region's centre; zero where
/// they do not, as for a light along the view.
Vec2 viewDirectionAt(const WarpContext& context) {
    // d(xy / z) = (dxy - q dz) / z; for a directional light dz = 0.
    const Vec3& direction = context.viewDirection;
    return direction.head<2>() - direction.z() * context.region.liCentre;
}

WarpChoice optimalWarp(const WarpContext& context, const OptimalOptions& options) {
    WarpSearch search(context,
                      static_cast<std::size_t>(std::clamp(options.samples, 1, MostSamples)));
    Vec2 best = Vec2::Zero();
    if (search.usable()) {
        const int evaluations = std::clamp(options.evaluations, LeastEvaluations, MostEvaluations);
        double least = 1.0;
        const auto consider = [&](const Vec2& spread) {
            const double cost = search(spread);
            if (cost < least) {
                least = cost;
                best = spread;
            }
        };
        // Along the view first, where near and far differ most.
        int left = evaluations;
        Vec2 direction = viewDirectionAt(context);
        if (direction.norm() > 0.0) {
            direction.normalize();
            consider(search.along(direction, WarpSearch::GreatestSpread, evaluations / 3));
            left -= evaluations / 3 + 1;
        } else {
            direction = Vec2::UnitX();
        }
        if (const auto last = search.last()) {
            consider(*last);
            --left;
        }
        // Elsewhere there may be a better place to start from, above all where that found little.
        const double length = std::max(best.norm(), ProbedSpread);
        const int probes = left / 3;
        for (int i = 1; i <= probes; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / (probes + 1);
            consider(length *
                     Vec2(std::cos(angle) * direction.x() - std::sin(angle) * direction.y(),
                          std::sin(angle) * direction.x() + std::cos(angle) * direction.y()));
        }
        left -= probes;
        consider(search.around(best, left - 1));
    }
    return {search.warp(search.settle(best)), FitReason::None};
}

} // namespace

ShadowFit fitOptimal(const ShadowProblem& problem, const OptimalOptions& options,
                     FitState& state) noexcept {
    return fitWithRule(problem, state,
                       [&](const WarpContext& context) { return optimalWarp(context, options); });
}

} // namespace Lixel
