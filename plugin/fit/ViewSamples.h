#pragma once

#include "fit/FocusRegion.h"

namespace Lixel {

/// What the viewer sees through one of its pixels, as the light sees it.
struct ViewSample {
    /// Image of the visible point.
    Vec2 liPoint = Vec2::Zero();
    /// d(light image) / d(viewer's normalised device coordinates), along the surface's tangent
    /// plane.
    Eigen::Matrix2d liFromNdc = Eigen::Matrix2d::Identity();
};

/// Scratch memory of sampling, kept between frames.
struct ViewSampleScratch {
    struct Ray {
        Vec3 origin;
        Vec3 direction;
        Vec3 inverse;
        double nearest;
        Vec3 normal;
    };
    std::vector<Ray> rays;
};

/** Samples what the viewer sees of the receivers and the light shines on, within the focus region.

    View rays, spread evenly over the picture, meet the receivers' boxes; a box that a ray starts
    in is hit where the ray leaves it. A sample must face the light, n . l >= 0.05, as pixels of
    which shadows are judged do.
*/
void sampleView(const ShadowProblem& problem, const LightImage& image, const FocusRegion& region,
                ViewSampleScratch& scratch, std::vector<ViewSample>& samples);

/** The expected extent of a texel in pixels, up to a factor that is the same for all warps.

    The mean over the samples of the Frobenius norm of d(pixel) / d(texel), that is of
    sqrt(sum J^2) / |det J| for J = d(texel) / d(pixel): Chong's "one combined measure of aliasing"
    (2006, §3.3), perspective and projection aliasing together.

    @param hull the focus region's; the map is the smallest rectangle around it after the warp
*/
double expectedTexelExtent(const std::vector<ViewSample>& samples, const Polygon2& hull,
                           const Vec2& centre, const Vec2& warp, Polygon2& scratch);

} // namespace Lixel
