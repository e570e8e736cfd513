#pragma once

#include "fit/FocusRegion.h"

namespace Lixel {

/// What tells whether viewer, light and focus region are the same as a frame before, however light
/// space is turned.
struct Situation {
    /// Lengths that do not depend on how light space is turned: the focus region's distance from
    /// the viewer, its perimeter, the farthest depth.
    Vec3 measures = Vec3::Zero();
    /// Unit directions of the viewer and of the light's axis.
    Vec3 wsView = Vec3::Zero();
    Vec3 wsLight = Vec3::Zero();
};

/// @param viewer ℓ of the viewer's position
Situation situationOf(const ShadowProblem& problem, const LightImage& image,
                      const FocusRegion& region, const Vec3& viewer);

/// How much has changed from one to the other: relative for lengths, radians for directions.
double changeBetween(const Situation& a, const Situation& b);

} // namespace Lixel
