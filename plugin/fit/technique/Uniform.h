#pragma once

#include "fit/problem/Technique.h"

namespace Lixel {
/// @addtogroup LixelTechniques
/// @{

/** The uniform shadow map (Williams 1978): warp 0.

    Focused: the focus region's smallest rectangle, divided into as many parts as the map has
    texels. On any plane across the light, texels are equal rectangles. A warped technique must not
    do worse than this.

    Stable (the "stable light frustum" of Valient, ShaderX6 2008, which cascades on large landscapes
    use): the map does not depend on where receivers and casters are, so that shadows' edges stay as
    they are while the viewer turns and moves. For a directional light it is a square across the
    sphere around all that is in view (around the slice, with cascades): the sphere has one size
    however the viewer turns, and its centre moves in whole texels of a grid that is fixed in the
    world. For a spot it is all of the cone. A view without end, which has no such sphere, gets the
    focused map and the reason ViewWithoutEnd. A light that moves changes the map.
*/
struct UniformOptions {
    /** Steady texels instead of small ones. The map covers all that is in view up to the shadow
        distance, which is worth setting low; or use it for the slices of cascades under a sun. A
        spot's map covers its cone, in every slice too; a point light's face covers the cone around
        it, and is stable only where the light has six maps. */
    bool stable = false;

    LIXEL_API static const FitTechnique& technique();
};

/// @}
} // namespace Lixel
