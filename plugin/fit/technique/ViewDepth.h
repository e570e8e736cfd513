#pragma once

#include "fit/core/Fit.h"

/// What rules that warp along the view share: the viewer's depth as the light sees it.
namespace Lixel {

/// Sine of the angle between view and light below which a warp along the view fades out. Gusev
/// (2007, step 3) switches at 0.1; the fade is complete at twice that, so that it passes his
/// threshold at half strength.
inline constexpr double FadeSine = 0.2;

/// Nearest depth, as a fraction of the farthest, that a warp is balanced with: a receiver that
/// touches the eye must not pull all texels to itself.
inline constexpr double LeastNearRatio = 1e-3;

/// 0 at sine 0, 1 from `complete` on, with a continuous slope.
double fadeBySine(double sine, double complete = FadeSine);

/// Depths in front of the viewer, in world units.
struct DepthRange {
    double nearest = 0.0;
    double farthest = 0.0;
};

/** Depth in front of the viewer, in world units, as an affine function of light space.

    Where a light's rays run across the view, a ray has one depth: that of its image. Along the view
    they have many, and only a range of depths belongs to a ray.
*/
class ViewDepth {
public:
    explicit ViewDepth(const WarpContext& context);

    /// Depth of a light-space point; positive in front of the viewer.
    double at(const Vec3& ls) const { return mLsGradient.dot(ls) + mOffset; }

    /// Bounds of the depths of the visible receivers that the focus region's rays meet: those of
    /// the rays between the nearest and the farthest receiver of the light, within those of all
    /// visible receivers. The nearest is at least LeastNearRatio of the farthest.
    DepthRange ofRegion(const WarpContext& context) const;

private:
    Vec3 mLsGradient;
    double mOffset;
};

} // namespace Lixel
