#pragma once

#include "fit/problem/ShadowProblem.h"

#include <vector>

namespace Lixel {

/// Where the view is cut into slices, one map each.
struct CascadeOptions {
    /// 0: depths of all slices have one ratio, so that near and far are alike (Zhang et al. 2006,
    /// "logarithmic"); 1: slices are equally deep; the "practical" scheme is between. In [0, 1].
    double uniformity = 0.0;
    /// Whether to split the depths from the nearest to the farthest that is seen, or from the near
    /// plane to the far end of shadows: the latter stay where they are as long as the viewer's
    /// projection does.
    bool followReceivers = true;
};

struct CascadeMemory;

/** Depths in front of the viewer at which slices meet, ascending, in world units.

    With followReceivers: between the nearest and the farthest point that the viewer sees of what
    may be shadowed (Lauritzen et al. 2011, "sample distribution shadow maps", from the fit's few
    samples instead of all pixels). These depths follow little by little, the faster the more
    changes in a frame: so what comes into view, or is no longer hidden, does not make all edges
    jump. After a camera cut, and where they are more than a factor of two from what is seen, they
    are taken as they are.

    @param count slices, at least 1
    @param[out] vsSplits count - 1 depths; none where nothing in view is shadowed, or the view has
    no end and nothing in it
*/
LIXEL_API void cascadeSplits(const ShadowProblem& problem, int count, const CascadeOptions& options,
                             CascadeMemory& memory, std::vector<double>& vsSplits);

} // namespace Lixel
