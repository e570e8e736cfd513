#pragma once

#include "fit/parts/CascadeMemory.h"
#include "fit/parts/CascadeSplits.h"
#include "fit/parts/LightPartition.h"

#include <functional>

namespace Lixel {

/// The technique of a division's parts. It must not throw.
using PartFit = std::function<ShadowFit(const ShadowProblem&, FitState&)>;

/** Divides what the viewer sees into as many parts as there are maps: into slices by depth
    (cascadeSplits), or into strips of the light image (stripLight), by which of them makes texels
    smaller where the viewer looks.

    Slices by depth serve a view along the ground. Seen from above, all of it is at nearly one depth,
    and what slices have between them overlaps in the light image: there strips are better. Both, and
    strips along either side of the rectangle around the focus region, are fitted and judged by one
    measure, FitExtent over the samples of what is seen: all three after a camera cut, and later one
    of them now and then, which replaces what there is only for a gain of a fifth. Where nothing
    moves, nothing is judged.

    @param vsPadding as sliceView
    @param[out] vsSplits as cascadeSplits
    @param technique fits a part; cheap ones and expensive ones are judged alike
*/
LightPartition divideView(const ShadowProblem& problem, std::size_t count,
                          const CascadeOptions& options, double vsPadding, CascadeMemory& memory,
                          CascadeScratch& scratch, std::vector<double>& vsSplits,
                          const PartFit& technique);

/** Where strips across a direction of the light image meet, as shares of the polygon's extent along
    it, ascending: so that the demand of the samples within a strip times the root of its width,
    summed over strips, is small. The demand of a sample is how large the light image is drawn there.

    @param count strips
    @param[in,out] demands scratch memory
    @return count - 1 shares, and the rest 0
*/
std::array<double, ShadowPart::MostBounds>
stripShares(const std::vector<ViewSample>& samples, const Polygon2& liHull, const Vec2& liDirection,
            std::size_t count, std::vector<std::pair<double, double>>& demands);

} // namespace Lixel
