#pragma once

#include "fit/problem/Technique.h"

namespace Lixel {
/// @addtogroup LixelTechniques
/// @{

/** Plane optimal shadow maps (Chong and Gortler 2004; Chong 2006, §2.3).

    A map that shows the plane as the viewer's picture does: a pixel of the plane is a texel,
    whatever viewer and light do, dueling frusta included. World points are moved to the plane along
    the light, x -> (n . L) x - L (n . x), and then seen by the viewer: rows x, y and w of

        C ((n . L) I - L nᵀ),

    C the viewer's clip matrix, L the homogeneous light and n the homogeneous plane.

    Exact: the map is that homography. Where it has as many texels as the viewport has pixels, and
    whatever the filter's radius, m = 1 on the plane. Chong's Figure 2, in words: rays from the
    light to what the viewer sees of the plane fill a wedge; receivers outside of it, behind the
    plane or beside what is seen of it, have no place in the map (denominator <= 0, or beyond the
    border). ShadowFit::wsServed says which, the reason is PlaneCannotServe if there are any in the
    focus region; there is no border kept for the filter. Where plane and light, or plane and
    viewer, meet, where they are on different sides of the plane, or nothing of the focus region is
    served, the map is the uniform one, with the same reason.

    Not exact: row w alone is taken, as a warp. It vanishes where the viewer's own plane (depth 0)
    meets the plane, which is often inside the focus region: then the warp is shortened until the
    least denominator is a fixed part of the greatest (WarpClamped). With the light in the plane
    there is no such row; the warp fades out as it comes near (PlaneCannotServe).

    Directional and spot lights; perspective and orthographic viewers. A normal without length, or
    a plane that is not finite, gives the uniform map and PlaneCannotServe.
*/
struct PlaneOptimalOptions {
    /** The plane of interest (n, d): points x of the world, not relative to the problem's origin,
        with n . x + d = 0. Its normal may have any length except zero, and either side may be up.
        */
    Vec4 wsPlane = Vec4(0.0, 1.0, 0.0, 0.0);
    /** Whether the map is exactly the viewer's picture of the plane. If so, ShadowFit::wsServed
        says what it serves. If not, all that is seen is served, and the plane only picks the
        warp. */
    bool exact = false;

    LIXEL_API static const FitTechnique& technique();
};

/// @}
} // namespace Lixel
