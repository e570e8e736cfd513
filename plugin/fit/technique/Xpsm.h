#pragma once

#include "fit/problem/Technique.h"

namespace Lixel {
/// @addtogroup LixelTechniques
/// @{

/** Extended perspective shadow maps (Gusev 2007).

    The warp runs along the view direction's image (§3.1). Its length makes the denominator at
    depth d in front of the viewer 1 + coef d (§3.2), and is bounded so that the focus region's
    least denominator is epsilonW (§3.3, eq. 3). Where the paper switches to a uniform map (the
    miner's lamp, §3.11, |V_xy| < 0.1) the warp fades out instead. Local lights, which the paper
    leaves out, get the uniform map: their own perspective does much of what the warp would.
*/
struct XpsmOptions {
    /** Strength of the warp, Gusev's `coef` freed of its unit: coef = strength / sqrt(n f), for n
        and f the depths of the nearest and farthest visible receiver. 1 is the balance of near and
        far that Wimmer et al. (2004, §4) derive for LiSPSM; 0 gives a uniform map. In [0, ∞). */
    double strength = 2.0;
    /** Gusev's epsilonW (2007, eq. 3): the least denominator in the focus region, relative to the
        viewer's. In (0, 1]; near 1 a caster behind the viewer dampens the warp more. */
    double epsilonW = 0.7;
    /** Whether the warp is searched for between none and the one that the constants give, where
        the expected extent of a texel in the viewer's picture is least: no greater than a uniform
        map's, as far as the receivers' boxes tell. From frame to frame the choice is followed
        steadily, and at once after a camera cut. Without, the warp is literally Gusev's. */
    bool guarded = true;

    LIXEL_API static const FitTechnique& technique();
};

/// @}
} // namespace Lixel
