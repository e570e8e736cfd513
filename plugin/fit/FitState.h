#pragma once

#include "fit/ViewSamples.h"

#include <optional>

namespace Lixel {

/** What outlives a frame, per light, viewer and map: memory of the last choice and scratch space.

    A fit from a fresh state is as valid as one from a used state; only the choice among equally
    good maps may differ.
*/
struct FitState {
    FocusScratch scratch;
    FocusRegion region;
    Polygon2 warped;
    ViewSampleScratch sampling;
    std::vector<ViewSample> samples;
    /// The focus region's hull with few vertices, for evaluating many warps.
    Polygon2 simpleHull;
    /// Direction of the last map's x axis in its warped light image, in [0, π/2).
    std::optional<double> mapAngle;
    /// How often the direction was given up for a smaller map.
    std::size_t orientationJumps = 0;
};

} // namespace Lixel
