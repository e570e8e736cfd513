#pragma once

#include "fit/problem/Technique.h"

namespace Lixel {
/// @addtogroup LixelTechniques
/// @{

/** One face of Kozlov's cube map in post-projective space (2004, §14.2.2): one map of the view
    volume's face through which its light rays leave. @see facesOfView

    On the face, texels are to be as large as the viewer sees them: a ray's denominator is the depth
    (from the slid-back viewer, Figure 14-6) at which it meets the face, row w of

        C ((n . L) I - L nᵀ),

    with C the viewer's clip matrix, L the homogeneous light and n the face's plane. It is row w of
    the map that is plane optimal (Chong and Gortler 2004) for the face. Kozlov draws whole faces;
    here the shared fit focuses each face on the receivers that it serves.

    @param problem one with a part that facesOfView made; any other gives the uniform map, as an
    orthographic viewer does
*/
struct CubeOptions {
    /// As PsmOptions::slideBack: 0 favours the near most, 1 makes near and far alike. In [0, ∞).
    double slideBack = 0.25;

    LIXEL_API static const FitTechnique& technique();
};

/// @}
} // namespace Lixel
