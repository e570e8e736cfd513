#pragma once

#include "fit/FocusRegion.h"

namespace Lixel {

/// What the viewer sees through one of its pixels, as the light sees it.
struct ViewSample {
    /// Image of the visible point.
    Vec2 liPoint = Vec2::Zero();
    /// Its depth in front of the viewer, in world units.
    double vsDepth = 0.0;
    /// d(light image) / d(viewer's normalised device coordinates), along the surface's tangent
    /// plane.
    Eigen::Matrix2d liFromNdc = Eigen::Matrix2d::Identity();
};

/// Scratch memory of sampling, kept between frames.
struct ViewSampleScratch {
    struct Ray {
        /// Where it goes through the picture, in device coordinates.
        Vec2 ndc;
        Vec3 origin;
        Vec3 direction;
        Vec3 inverse;
        double nearest;
        Vec3 normal;
    };
    std::vector<Ray> rays;
    /// Points that could be samples.
    std::vector<VisiblePoint> points;
};

/** Samples what the viewer sees of the receivers and the light shines on, within the focus region.

    The visible points are the problem's own where it has any; otherwise view rays, spread evenly
    over the picture, meet the receivers: their known surfaces, or else their boxes. A box that a
    ray starts in is hit where the ray leaves it. A sample must face the light, n . l >= 0.05, as
   pixels of which shadows are judged do.

    @param most samples to keep, evenly out of those found
*/
void sampleView(const ShadowProblem& problem, const LightImage& image, const FocusRegion& region,
                std::size_t most, ViewSampleScratch& scratch, std::vector<ViewSample>& samples);

} // namespace Lixel
