#pragma once

#include "fit/FitState.h"

#include <functional>

/** The one fit that every technique shares.

    A technique is a rule that picks the warp; focusing, the warp's safety, the affine fit, the
    depth row and the matrices are here.
*/
namespace Lixel {

/// What a rule may look at to pick its warp.
struct WarpContext {
    const ShadowProblem& problem;
    const LightImage& image;
    const FocusRegion& region;
    FitState& state;
    /// ℓ of the viewer's position; its third component is <= 0 where the viewer is behind a local
    /// light.
    Vec3 viewer;
    /// ℓ of the unit view direction.
    Vec3 viewDirection;
    /// Whether the viewer's projection is a perspective one; an orthographic one sees everything
    /// at one size.
    bool perspective;
};

/// A rule's choice: the warp about region.liCentre, and what kept it from its ideal.
struct WarpChoice {
    Vec2 liWarp = Vec2::Zero();
    FitReason reason = FitReason::None;
};

/// Runs the shared fit around a rule. Never throws; bad input gives a fit without a map.
ShadowFit fitWithRule(const ShadowProblem& problem, FitState& state,
                      const std::function<WarpChoice(const WarpContext&)>& rule) noexcept;

} // namespace Lixel
