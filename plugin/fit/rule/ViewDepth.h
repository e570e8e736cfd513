#pragma once

#include "fit/core/WarpContext.h"

/// What rules that warp along the view share: the viewer's depth as the light sees it.
namespace Lixel {

/// Nearest depth, as a fraction of the farthest, that a warp is balanced with: a receiver that
/// touches the eye must not pull all texels to itself.
inline constexpr double LeastNearRatio = 1e-3;

/// Depths in front of the viewer, in world units.
struct DepthRange {
    double nearest = 0.0;
    double farthest = 0.0;
};

/** Depth in front of the viewer, in world units, as an affine function of light space.

    A light ray that runs across the view has one depth, that of its image. A ray along the view has
    many, so only a range of depths belongs to it.
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
