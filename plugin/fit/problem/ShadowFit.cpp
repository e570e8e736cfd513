#include "fit/problem/ShadowFit.h"

#include <Eigen/LU>

namespace Lixel {

const char* toString(FitReason reason) noexcept {
    switch (reason) {
    case FitReason::None:
        return "none";
    case FitReason::LightAlongView:
        return "light along the view";
    case FitReason::WarpClamped:
        return "warp clamped";
    case FitReason::UnboundedBody:
        return "a body without bounds";
    case FitReason::PlaneCannotServe:
        return "the plane is edge-on or cannot serve all";
    case FitReason::ViewWithoutEnd:
        return "a stable map needs a view that ends";
    case FitReason::PartOfLight:
        return "the light shines wider than its map serves";
    case FitReason::NoReceivers:
        return "no receiver in view";
    case FitReason::NothingShadowed:
        return "nothing in view is shadowed";
    case FitReason::Unbounded:
        return "a receiver without bounds and a view without end";
    case FitReason::InvalidInput:
        return "invalid input";
    case FitReason::TooFewMaps:
        return "the light shines too wide for the maps that it has";
    }
    return "unknown";
}

Mat4 texelMatrix(const ShadowFit& fit, int mapWidth, int mapHeight) noexcept {
    if (!fit.hasMap()) return Mat4::Identity();
    // x -> M^-1 (M x + c w), c one texel in clip space: Kozlov's (P M + c) M^-1 with the division
    // by w multiplied out.
    Mat4 shift = Mat4::Identity();
    shift(0, 3) = 2.0 / mapWidth;
    shift(1, 3) = 2.0 / mapHeight;
    return fit.clipFromWorld.inverse() * shift * fit.clipFromWorld;
}

} // namespace Lixel
