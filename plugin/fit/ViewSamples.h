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

    The visible points are the problem's own where it has any; otherwise view rays, spread evenly
    over the picture, meet the receivers' boxes; a box that a ray starts in is hit where the ray
    leaves it. A sample must face the light, n . l >= 0.05, as pixels of which shadows are judged
   do.
*/
void sampleView(const ShadowProblem& problem, const LightImage& image, const FocusRegion& region,
                ViewSampleScratch& scratch, std::vector<ViewSample>& samples);

/** How large texels are on average over the samples, up to a factor that is the same for all warps:
    Chong's "one combined measure of aliasing" (2006, §3.3), to be minimised.

    A pixel is classified wrongly where a texel lies across a shadow's edge, so how often that
    happens is the density of edges times the extent of a texel in the same plane. Edges spread
    evenly over the light image call for the texel's extent there, edges spread evenly over the
    viewer's picture for its extent in pixels; scenes are in between, and this is the mean of the
    geometric means of the two. Extents are Frobenius norms of d(plane) / d(texel), that is
    sqrt(sum J^2) / |det J| for J = d(texel) / d(plane): perspective and projection aliasing
    together.

    @param hull the focus region's; the map is the smallest rectangle around it after the warp
*/
double expectedTexelExtent(const std::vector<ViewSample>& samples, const Polygon2& hull,
                           const Vec2& centre, const Vec2& warp, Polygon2& scratch);

} // namespace Lixel
