#pragma once

#include "fit/problem/Technique.h"

namespace Lixel {
/// @addtogroup LixelTechniques
/// @{

/** Trapezoidal shadow maps (Martin and Tan 2004).

    Seen from the light, a trapezoid lies around the viewer's frustum: its centre line l is the
    image of the frustum's axis, its top and base line stand across l and touch the frustum's hull,
    the top on the viewer's side. Warped to a square, the trapezoid's upper part, up to the focus
    point p_L on l, shall take 80 % of the square (§4.2, "80 % rule"). With λ the distance of top and
    base line, d' that of p_L from the top line, and ξ = 1 - 2 share, the apex where the
    trapezoid's sides meet is at distance

        η = (λ d' + λ d' ξ) / (λ - 2 d' - λ ξ) = (1 - share) λ d' / (share λ - d')

    before the top line, and the denominator at distance y behind it is η + y. Where d' >= share λ
    there is no apex, and no need for one: the map stays uniform.

    The frustum reaches from the viewer's position to the depth of the farthest receiver in the
    focus region; the sides of the trapezoid, which the paper lays around the frustum too, are
    replaced by the shared fit around the focus region. With the light along the view the centre
    line shrinks to a point; the paper then has no trapezoid, here the warp fades out with the sine
    between them (LightAlongView).

    For a local light, whose image of the frustum may be unbounded, top and base line touch the
    focus region instead, and distances along l are the viewer's depths on a plane across the light's
    axis through the farthest receiver. An orthographic viewer gets the uniform map.
*/
struct TrapezoidalOptions {
    /** Where the focus point lies on the centre line: the paper's δ, as a fraction of the distance
        from the viewer to the farthest receiver in the focus region. In (0, 1). */
    double focusDistance = 0.25;
    /** How much of the map lies before the focus point: the paper's 80 % line. In (0, 1). A share
        that a map without warp gives already leaves the map as it is. */
    double focusShare = 0.8;

    LIXEL_API static const FitTechnique& technique();
};

/// @}
} // namespace Lixel
