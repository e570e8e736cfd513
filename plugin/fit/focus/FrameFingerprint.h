#pragma once

#include "fit/focus/FocusRegion.h"

namespace Lixel {

/// What tells whether viewer, light and focus region are the same as a frame before, however light
/// space is turned.
struct FrameFingerprint {
    /// Lengths that do not depend on how light space is turned: the focus region's distance from
    /// the viewer, its perimeter, the farthest depth.
    Vec3 measures = Vec3::Zero();
    /// Unit directions of the viewer and of the light's axis.
    Vec3 wsView = Vec3::Zero();
    Vec3 wsLight = Vec3::Zero();
};

FrameFingerprint fingerprintOf(const ShadowProblem& problem, const LightImage& image,
                               const FocusRegion& region);

/// Relative difference of two lengths: their difference divided by their sum.
double relativeChange(double a, double b);

/// How far viewer or light have turned, in radians.
double turnBetween(const FrameFingerprint& a, const FrameFingerprint& b);

/// The larger of that turn and the greatest relative change of the three lengths.
double changeBetween(const FrameFingerprint& a, const FrameFingerprint& b);

/// A change of at least this is taken for a camera cut.
inline constexpr double CameraCutChange = 0.05;

} // namespace Lixel
