#include "fit/technique/LiSPSM.h"

#include "fit/core/Fit.h"
#include "fit/technique/ViewDepth.h"

namespace Lixel {
namespace {

WarpChoice lispsmWarp(const WarpContext& context, const LiSPSMOptions& options) {
    const FocusRegion& region = context.region;
    if (!context.perspective || !(region.vsReceiverFar > 0.0)) return {};
    const Vec2 along = context.viewDirection.head<2>();
    const double sine = along.norm();
    if (!(sine > 0.0)) return {Vec2::Zero(), FitReason::LightAlongView};
    const Vec2 direction = along / sine;

    // Depth gained per unit of the light image: sin γ, where a unit of the image is one of length.
    const double slope = sine * (context.image.directional() ? 1.0 : region.lsReceiverFar);
    const double top = -support(region.liHull, -direction);
    const double d = support(region.liHull, direction) - top;
    const double zn = ViewDepth(context).ofRegion(context).nearest;
    const double zf = zn + slope * d;
    const double nTimesSlope = options.distanceFactor * (zn + std::sqrt(zn * zf));

    // Denominator n + s - top, about the centre instead of the apex.
    const double centre = direction.dot(region.liCentre);
    const double length = slope / (nTimesSlope + slope * (centre - top));
    if (!std::isfinite(length)) return {};
    return {length * direction, sine < FadeSine ? FitReason::LightAlongView : FitReason::None};
}

} // namespace

ShadowFit fitLiSPSM(const ShadowProblem& problem, const LiSPSMOptions& options,
                    FitState& state) noexcept {
    return fitWithRule(problem, state,
                       [&](const WarpContext& context) { return lispsmWarp(context, options); });
}

} // namespace Lixel
