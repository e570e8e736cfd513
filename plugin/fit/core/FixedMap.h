#pragma once

#include "fit/core/FitState.h"

/// Maps that a rule gives whole, and what they can serve.
namespace Lixel {

enum class Served { Everything, Part, Nothing };

/** Cuts the focus region to the light rays that a map has a place for: those q for which
    H (q, 1) = (x, y, w) has -w <= x <= w and -w <= y <= w, which makes w > 0.

    The region stays as it is where no ray is left, where H is not finite (in float too), or where
    H reverses orientation.
    @param homography rows x, y and w of the map, acting on ℓ
*/
Served cutToMap(const Mat3& homography, FocusRegion& region, PlacementScratch& scratch);

} // namespace Lixel
