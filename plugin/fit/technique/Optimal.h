#pragma once

#include "fit/problem/Technique.h"

namespace Lixel {
/// @addtogroup LixelTechniques
/// @{

/** The warp that makes texels smallest, on average over what the viewer sees.

    The papers choose the warp by a formula for one case; Chong (2006, §3.3) asks for an algorithm
    that minimises "one combined measure of aliasing". This one does: samples of the viewer's
    picture that face the light, and the expected extent of a texel on them as a function of the
    warp (TexelExtent.h), searched over all directions and strengths, from along the view's
    direction (golden section, then simplex), or from the last frame's best (simplex alone). Duels,
    lamps and lights nearly along the view, where no warp along the view's direction is any good,
    get what there is to gain; where nothing is, the map is uniform.

    Serves directional and spot lights, perspective and orthographic viewers. From frame to frame
    the choice is followed steadily, and at once after a camera cut.
*/
struct OptimalOptions {
    /// Samples of what the viewer sees, at most, by which warps are judged; about half as many of
    /// what fills little of the picture. At least 1.
    int samples = 64;
    /// Warps judged where nothing is known of the frame before, at least 8. A frame that follows
    /// another goes on from there with a quarter, and at least 8.
    int evaluations = 32;
    /// How much more those samples count around which shadows have many edges, from 0 to 1: what
    /// errs is a texel across an edge (EdgeDensity.h). Costs some 40 ns for each caster that may
    /// shadow something that is seen.
    double edgeWeight = 0.0;
    /// Whether the map may be a parallelogram of the warped light image instead of the smallest
    /// rectangle around the region, where that makes texels smaller. What a viewer sees of a plane
    /// is one, seen by a light from aside. Costs 2 to 3 us.
    bool skewedMaps = true;

    LIXEL_API static const FitTechnique& technique();
};

/// @}
} // namespace Lixel
