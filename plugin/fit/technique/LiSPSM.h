#pragma once

#include "fit/problem/Technique.h"

namespace Lixel {
/// @addtogroup LixelTechniques
/// @{

/** Light space perspective shadow maps (Wimmer, Scherzer, Purgathofer 2004).

    A perspective frustum P lies across the light: its axis is the view direction projected along
    the light, its near plane touches the focus region's near end, its far plane the far end. From
    the side: the light's rays come down vertically, P opens away from the viewer, its apex at
    distance n in front of P's near plane. So at distance s behind that plane the denominator is
    n + s, and (§4)

        n_opt = (z_n + sqrt(z_n z_f)) / sin γ,  z_f = z_n + d sin γ,

    with γ the angle between view and light, d the depth of P and z_n, z_f the viewer's depths at
    P's near and far plane, makes the perspective error alike at both ends: their denominators'
    ratio is sqrt(z_f / z_n). z_n is the least depth, in front of the viewer, of receivers in the
    focus region.

    As γ → 0 (or 180°), n_opt grows without bounds: the map fades to the uniform one by itself, and
    the reason is LightAlongView. No point of the region is ever in front of P's near plane, so the
    warp is safe as it is, dueling frusta included.

    For a local light P lies in the light's own image, and sin γ, the change of depth across the
    light, becomes that on a plane across the light's axis through the farthest receiver. The
    light's own perspective is left as it is. An orthographic viewer gets the uniform map.
*/
struct LiSPSMOptions {
    /** The perspective's distance n of near plane and apex, as a multiple of n_opt: 1 is the
        paper's balance of near and far; smaller gives more texels to the near, ∞ is uniform. In
        (0, ∞). */
    double distanceFactor = 1.0;

    LIXEL_API static const FitTechnique& technique();
};

/// @}
} // namespace Lixel
