#pragma once

#include "fit/problem/Option.h"
#include "fit/problem/ShadowProblem.h"

#include <vector>

namespace Lixel {
/// @addtogroup LixelFit
/// @{

/// Where the view is cut into slices, one map each.
struct CascadeOptions {
    /// 0: depths of all slices have one ratio, so that near and far are alike (Zhang et al. 2006,
    /// "logarithmic"); 1: slices are equally deep; the "practical" scheme is between.
    double uniformity = 0.0;
    /// Whether to split the depths from the nearest to the farthest that is seen, or from the near
    /// plane to the far end of shadows: the latter stay where they are as long as the viewer's
    /// projection does. With stable maps (UniformOptions::stable) they should stay.
    bool followReceivers = true;
    /// Whether maps may also be strips of the light's image, where texels are expected to be smaller
    /// so: of views of little depth, as from far above. Not with given depths, with padding, or
    /// without followReceivers. Materials of others that find slices by depth need it off.
    bool stripLight = true;
    /** Where slices meet, as depths in front of the viewer, instead of all that. As many as maps
        less one are taken as they are: a slice that ends before the viewer's near plane is empty,
        and receivers with the same depths read the others' maps. Of more, those up to the near
        plane do not count, nor those that there are no maps for: so these may be all that
        Ogre::PSSMShadowCameraSetup::getSplitPoints() returns. */
    std::vector<double> vsSplitDepths{};
    /** How much farther each slice's map reaches than to where slices meet. 0 is enough for Lixel's
        materials. Others may find slices by another depth: OGRE's receivers compare clip z, which
        is less by up to twice the viewer's near distance. */
    double splitPadding = 0.0;

    LIXEL_API static std::span<const Option> declared();
};

struct CascadeMemory;
struct CascadeScratch;

/** Depths in front of the viewer at which slices meet, ascending, in world units.

    With vsSplitDepths, those are used. With followReceivers, slices lie between the nearest and the
    farthest visible point that may be shadowed (Lauritzen et al. 2011, "sample distribution shadow
    maps", from the fit's few samples instead of all pixels). These two depths follow what is seen
    gradually, and faster the more changes in a frame. So a body that comes into view, or is no
    longer hidden, does not make all edges jump. After a camera cut, or if they are off by more than
    a factor of two, they jump to what is seen now.

    @param count slices, at least 1
    @param[out] vsSplits count - 1 depths; none where nothing in view is shadowed, or the view has
    no end and nothing in it
*/
void cascadeSplits(const ShadowProblem& problem, std::size_t count, const CascadeOptions& options,
                   CascadeMemory& memory, CascadeScratch& scratch, std::vector<double>& vsSplits);

/// Depth of the near plane on the viewer's axis; 0 where it is not in front of the viewer.
double vsNearOf(const ShadowViewer& viewer);

/// @}
} // namespace Lixel
