#include "fit/Xpsm.h"

#include "fit/Fit.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace Lixel {
namespace {

/// Sine of the angle between view and light below which the warp fades out. Gusev switches at 0.1
/// (step 3); the fade is complete at twice that, so that it passes his threshold at half strength.
constexpr double FadeSine = 0.2;

/// Nearest depth, as a fraction of the farthest, that the strength is balanced with: a receiver
/// that touches the eye must not pull all texels to itself.
constexpr double LeastNearRatio = 1e-3;

double smoothstep(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

WarpChoice xpsmWarp(const WarpContext& context, const XpsmOptions& options) {
    const FocusRegion& region = context.region;
    if (!context.perspective || !(options.strength > 0.0)) return {};

    // §3.2: coef, with depths in place of a scene's scale.
    const double farDepth = region.vsReceiverFar;
    const double nearDepth = std::max(region.vsReceiverNear, LeastNearRatio * farDepth);
    if (!(farDepth > 0.0)) return {};
    const double coef = options.strength / std::sqrt(nearDepth * farDepth);

    // §3.1: the direction in which the view line runs in the light's image. With the line's ℓ at
    // depth t being e + t v, its image moves along v_xy e_z - e_xy v_z; for a directional light
    // that is V_xy.
    const Vec3& e = context.viewer;
    const Vec3& v = context.viewDirection;
    const Vec2 along = v.head<2>() * e.z() - e.head<2>() * v.z();
    if (!(along.norm() > 0.0)) return {Vec2::Zero(), FitReason::LightAlongView};
    const Vec2 direction = along.normalized();

    // Sine between the view and the light ray through the viewer; a local light so near that the
    // ray's direction means nothing fades it too.
    const double sine = context.image.directional()
                            ? along.norm()
                            : e.cross(v).norm() / (e.norm() + FadeSine * region.lsReceiverFar);
    const double fade = smoothstep(sine / FadeSine);

    // The denominator along the view line is affine in t: f0 + t f1 with h = (s u, 1 - s u . c).
    // f1 / f0 = coef gives s; for a directional light this is lengthP = coef / cos γ moved to c.
    const Vec2& c = region.liCentre;
    const double alpha = direction.dot(e.head<2>() - c * e.z());
    const double beta = direction.dot(v.head<2>() - c * v.z());
    const double numerator = coef * e.z() - v.z();
    const double denominator = beta - coef * alpha;
    if (!(numerator > 0.0)) return {}; // a local light's own perspective does as much already

    // Eq. (3): the least denominator, relative to the viewer's, is epsilonW.
    const double lowest = -support(region.liHull, -direction) - direction.dot(c);
    const double viewerAt = e.z() > 0.0 ? direction.dot(e.head<2>() / e.z() - c) : 0.0;
    const double epsilonW = std::clamp(options.epsilonW, 0.0, 1.0);
    const double perLength = epsilonW * viewerAt - lowest;
    double length = std::numeric_limits<double>::infinity();
    if (denominator > 0.0) length = numerator / denominator;
    FitReason reason = FitReason::None;
    if (perLength > 0.0 && length * perLength > 1.0 - epsilonW) {
        length = (1.0 - epsilonW) / perLength;
        reason = FitReason::WarpClamped;
    }
    if (!std::isfinite(length)) return {};
    if (fade < 1.0) reason = FitReason::LightAlongView;
    return {fade * length * direction, reason};
}

} // namespace

ShadowFit fitXpsm(const ShadowProblem& problem, const XpsmOptions& options,
                  FitState& state) noexcept {
    return fitWithRule(problem, state,
                       [&](const WarpContext& context) { return xpsmWarp(context, options); });
}

} // namespace Lixel
