#pragma once

#include "fit/core/FitState.h"

/// Maps that a rule gives whole, and what they can serve.
namespace Lixel {

enum class Served { Everything, Part, Nothing };

/** Cuts the focus region to the light rays that a map has a place for: those q for which
    H (q, 1) = (x, y, w) has -w <= x <= w and -w <= y <= w, which makes w > 0.

    Where that is nothing, or H is not finite, even in float, or turns orientation, the region stays
    as it is.
    @param homography rows x, y and w of the map, acting on ℓ
*/
Served cutToMap(const Mat3& homography, FocusRegion& region, PlacementScratch& scratch);

} // namespace Lixel
