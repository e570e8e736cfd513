#include "fit/technique/Trapezoidal.h"

#include "fit/core/Declare.h"
#include "fit/focus/ViewVolume.h"
#include "fit/rule/ViewDepth.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>

namespace Lixel {
namespace {

/// One over η, the distance between apex and top line; 0 where the map gives the share already.
double inverseApexDistance(const TrapezoidalOptions& options, double height, double focus) {
    const double share = std::clamp(options.focusShare, 0.0, 1.0);
    const double numerator = share * height - focus;
    if (!(numerator > 0.0)) return 0.0;
    return numerator / ((1.0 - share) * height * focus);
}

/// The corners of the viewer's picture at a depth, in world axes.
std::array<Vec3, 4> cornersAt(const ShadowViewer& viewer, double depth) {
    const Mat4 worldFromClip = viewer.viewFromWorld.inverse() * viewer.clipFromView.inverse();
    std::array<Vec3, 4> result;
    for (std::size_t i = 0; i < 4; ++i) {
        // Two points of the corner's ray; clip depths -1 and 0 are finite without a far plane too.
        const double x = (i & 1) != 0 ? 1.0 : -1.0;
        const double y = (i & 2) != 0 ? 1.0 : -1.0;
        const Vec3 a = (worldFromClip * Vec4(x, y, -1.0, 1.0)).hnormalized();
        const Vec3 b = (worldFromClip * Vec4(x, y, 0.0, 1.0)).hnormalized();
        const auto depthOf = [&](const Vec3& p) {
            return -viewer.viewFromWorld.row(2).dot(p.homogeneous());
        };
        result[i] = a + (depth - depthOf(a)) / (depthOf(b) - depthOf(a)) * (b - a);
    }
    return result;
}

/// The warp around the viewer's frustum.
WarpChoice warpOfASun(const WarpContext& context, const TrapezoidalOptions& options,
                      double farthest) {
    const LightImage& image = context.image;
    const Vec2 liEye = context.viewer.head<2>();
    const std::array<Vec3, 4> wsFar = cornersAt(context.problem.viewer, farthest);
    std::array<Vec2, 5> hull;
    hull[4] = liEye;
    Vec2 liFar = Vec2::Zero();
    Vec3 wsFarCentre = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
        hull[i] = image.project(image.lsFromPoint(wsFar[i]));
        liFar += hull[i] / 4.0;
        wsFarCentre += wsFar[i] / 4.0;
    }

    // The centre line and the trapezoid's top and base line; the region is inside up to rounding.
    const Vec2 along = liFar - liEye;
    const double axis = (wsFarCentre - wsEyeOf(context.problem.viewer)).norm();
    if (!(along.norm() > 0.0) || !(axis > 0.0)) return {Vec2::Zero(), FitReason::LightAlongView};
    const double sine = along.norm() / axis;
    const Vec2 direction = along.normalized();
    const double top = -support(hull, -direction);
    const double height = support(hull, direction) - top;
    const double focus = direction.dot(liEye + options.focusDistance * along) - top;

    const double inverse = inverseApexDistance(options, height, focus);
    const double centre = direction.dot(context.region.liCentre) - top;
    const double length = fadeBySine(sine) * inverse / (1.0 + inverse * centre);
    if (!std::isfinite(length)) return {};
    return {length * direction, sine < FadeSine ? FitReason::LightAlongView : FitReason::None};
}

/// The same in depths along the centre line, on a plane across the light's axis.
WarpChoice warpOfALamp(const WarpContext& context, const TrapezoidalOptions& options,
                       const DepthRange& depths) {
    const FocusRegion& region = context.region;
    const auto& [direction, sine, fade] = context.view;
    if (context.view.vanishes()) return {Vec2::Zero(), FitReason::LightAlongView};
    const double slope = sine * region.lsReceiverFar;
    const double inverse =
        inverseApexDistance(options, depths.farthest, options.focusDistance * depths.farthest);
    const double top = -support(region.liHull, -direction);
    const double centre = depths.nearest + slope * (direction.dot(region.liCentre) - top);
    const double length = fade * slope * inverse / (1.0 + inverse * centre);
    if (!std::isfinite(length)) return {};
    return {length * direction, context.view.reason()};
}

WarpChoice trapezoidalWarp(const WarpContext& context, const TrapezoidalOptions& options) {
    if (!context.hasDepths()) return {};
    const DepthRange depths = ViewDepth(context).ofRegion(context);
    return context.image.directional() ? warpOfASun(context, options, depths.farthest)
                                       : warpOfALamp(context, options, depths);
}

} // namespace

const FitTechnique& TrapezoidalOptions::technique() {
    static constexpr std::array options{
        option<&TrapezoidalOptions::focusDistance>(
            "focus_distance", strictlyBetween(0.0, 1.0), "",
            "up to where the focus reaches, as a part of the distance to the farthest receiver "
            "that matters"),
        option<&TrapezoidalOptions::focusShare>("focus_share", strictlyBetween(0.0, 1.0), "",
                                                "how much of the map the focus takes"),
    };
    static constexpr FitTechnique declared = declare<TrapezoidalOptions, trapezoidalWarp>(
        "Trapezoidal", "trapezoid, 80 % for the near", "Martin and Tan 2004", options);
    return declared;
}

} // namespace Lixel
