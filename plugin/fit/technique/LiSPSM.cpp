#include "fit/technique/LiSPSM.h"

#include "fit/core/Declare.h"
#include "fit/rule/ViewDepth.h"

#include <array>

namespace Lixel {
namespace {

WarpChoice lispsmWarp(const WarpContext& context, const LiSPSMOptions& options) {
    const FocusRegion& region = context.region;
    const ViewImage& view = context.view;
    if (!context.hasDepths()) return {};
    if (view.vanishes()) return {Vec2::Zero(), FitReason::LightAlongView};

    // Depth gained per unit of the light image: sin γ, where a unit of the image is one of length.
    const double slope = view.sine * (context.image.directional() ? 1.0 : region.lsReceiverFar);
    const double top = -support(region.liHull, -view.direction);
    const double d = support(region.liHull, view.direction) - top;
    const double zn = ViewDepth(context).ofRegion(context).nearest;
    const double zf = zn + slope * d;
    const double nTimesSlope = options.distanceFactor * (zn + std::sqrt(zn * zf));

    // Denominator n + s - top, about the centre instead of the apex.
    const double centre = view.direction.dot(region.liCentre);
    const double length = slope / (nTimesSlope + slope * (centre - top));
    if (!std::isfinite(length)) return {};
    return {length * view.direction, view.reason()};
}

} // namespace

const FitTechnique& LiSPSMOptions::technique() {
    static constexpr std::array options{
        option<&LiSPSMOptions::distanceFactor>(
            "distance_factor", above(0.0), "",
            "distance of the perspective's apex: 1 is the paper's n_opt, with the same perspective "
            "error near and far; smaller favours the near"),
    };
    static constexpr FitTechnique declared = declare<LiSPSMOptions, lispsmWarp>(
        "LiSPSM", "light space perspective", "Wimmer, Scherzer and Purgathofer 2004", options);
    return declared;
}

} // namespace Lixel
