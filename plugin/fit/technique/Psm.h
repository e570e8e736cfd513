#pragma once

#include "fit/problem/Technique.h"

namespace Lixel {
/// @addtogroup LixelTechniques
/// @{

/** Perspective shadow maps (Stamminger and Drettakis 2002) as Kozlov (2004, "Care and Feeding")
    mends them: a map drawn in the viewer's post-projective space.

    In that space what is near is large, and a directional light is a point. A light camera stands
    there and looks along ω. Let C be the (virtual) viewer's clip matrix and L the homogeneous
    light. Then row w of the camera's map is, for a world point x,

        h(x) = ω . ((CL)_w (Cx)_xyz - (Cx)_w (CL)_xyz),

    linear in ω, zero at the light, and so a covector of the light image: a warp.

    - ω is the axis of the smallest cone around the focus region (§14.2.2), whose rays through the
      light image are directions in post-projective space too. They have a half space in common, so
      the cone is narrower than 180°, and the warp is safe as it is.
    - A light behind the viewer is behind the plane at infinity there; its rays run through
      infinity. Kozlov's inverse projection draws them nevertheless (§14.2.1, Figure 14-5). It
      changes the depth row alone, which here is the shared one: the formula above knows no front
      and back, and needs no virtual camera for casters behind the viewer.
    - The near plane is pulled out to the nearest receiver, the far plane in to the farthest, by
      their bounding volumes (§14.2.1, end; step 1 of §14.2.2).
    - The virtual viewer is slid back (Figure 14-6: its frustum contains the viewer's, and the near
      planes of both coincide), which makes row w of C the depth plus that distance.

    With the light along the view all depths have one density, and the cone's tilt towards a region
    beside the axis is all that is left of the warp; it fades out (LightAlongView). For spots the
    same formula holds. An orthographic viewer gets the uniform map.
*/
struct PsmOptions {
    /** How far the virtual viewer stands behind the viewer, its near plane staying where it is
        (Kozlov 2004, Figure 14-6), relative to sqrt(n f) with n and f the depths of the nearest and
        farthest receiver in the focus region. 0 is the paper without slide-back, which favours
        the near most; 1 makes the perspective error of a side light alike near and far. In
        [0, ∞). */
    double slideBack = 0.25;

    LIXEL_API static const FitTechnique& technique();
};

/// The virtual viewer's OpenGL clip space from world axes: `slideBack` (world units) behind the
/// viewer, with clip planes at depths `nearest` < `farthest` in front of the viewer itself.
Mat4 virtualViewer(const ShadowViewer& viewer, double slideBack, double nearest, double farthest);

/// @}
} // namespace Lixel
