#pragma once

#include "fit/focus/FocusRegion.h"
#include "fit/sampling/ViewRays.h"

namespace Lixel {

/// What the viewer sees through one of its pixels, as the light sees it.
struct ViewSample {
    /// Image of the visible point.
    Vec2 liPoint = Vec2::Zero();
    /// Its depth in front of the viewer, in world units.
    double vsDepth = 0.0;
    /// Its distance along the light's axis, in world units.
    double lsDepth = 0.0;
    /// d(viewer's normalised device coordinates) / d(light image), along the surface's tangent
    /// plane.
    Eigen::Matrix2d ndcFromLi = Eigen::Matrix2d::Identity();
    /// How much it counts among others.
    double weight = 1.0;
};

/// How many samples are wanted.
struct SampleCount {
    std::size_t most;
    /// So many that another round of rays is not worth its time; at most `most`.
    std::size_t enough;
};

/// Scratch memory of sampling, kept between frames.
struct SampleScratch {
    ViewRays rays;
    /// Known surfaces in the world.
    std::vector<Surfel> discs;
};

/** What the viewer sees of some receivers, for all lights at once: a point for each view ray of
    every round, in the order of rays, and one without a normal, which is no sample, for a ray that
    meets nothing. So a point that comes or goes leaves all others where they are.

    @param boxes of receivers
    @param surfaces that are met instead of a box, by ascending index of the boxes
    @param others surfaces of receivers that have no box among these
    @param[out] points to be a problem's visible points; overwritten
*/
void traceView(const ShadowViewer& viewer, const BoxSet& boxes,
               std::span<const KnownSurface> surfaces, std::span<const KnownSurface> others,
               SampleScratch& scratch, std::vector<VisiblePoint>& points);

/** Samples what the viewer sees of the receivers and the light shines on, within the focus region.

    The visible points are the problem's own where it has any; otherwise view rays, spread evenly
    over the picture, meet the receivers: their known surfaces, or else their boxes. A box that a
    ray starts in is hit where the ray leaves it. Where the problem knows what an earlier frame
    showed, the point nearest to the ray's place stands in for what the ray would meet. A sample
    must face the light, n . l >= 0.05, like the pixels whose shadows are judged.

    Where there are more points than wanted, they are taken in an order whose every beginning is
    spread over all of them, until there are enough: so one that comes or goes changes few samples.
    A further round of rays goes on until there are as many as are enough.

    @param liHull of the focus region, or a little more; samples lie within it
    @param receiversInView the receivers that may be in view and lit, as the focus region's search
    left them
*/
void sampleView(const ShadowProblem& problem, const LightImage& image, const Polygon2& liHull,
                const BoxSet& receiversInView, const SampleCount& count, SampleScratch& scratch,
                std::vector<ViewSample>& samples);

} // namespace Lixel
