#pragma once

#include "fit/focus/FrameFingerprint.h"
#include "fit/sampling/TexelExtent.h"

#include <optional>

namespace Lixel {

/// What a search for a warp found last, and for whom.
struct SearchMemory {
    /// The spread, a vector of the light image, as a direction in the world.
    Vec3 wsSpread = Vec3::Zero();
    /// The best that it knew of, which the spread settles towards; none where there was nothing to
    /// judge by.
    std::optional<Vec3> wsTarget;
    /// How far around the target it looks next, and how often it has.
    double step = 0.0;
    int turn = 0;
    FrameFingerprint fingerprint;
};

/** What outlives a frame, per light, viewer and map: memory of the last choice and scratch space.

    A fit from a fresh state is as valid as one from a used state; only the choice among equally
    good maps may differ.
*/
struct FitState {
    FocusScratch scratch;
    FocusRegion region;
    Polygon2 warped;
    SampleScratch sampling;
    std::vector<ViewSample> samples;
    /// The focus region's hull with few vertices, for evaluating many warps.
    Polygon2 simpleHull;
    TexelExtent extent;
    /// The focus region's rays in another space, for rules that look from there.
    std::vector<Vec3> directions;
    /// The last map's x axis, as a direction in the world: light space itself may turn about the
    /// light from one frame to the next.
    std::optional<Vec3> wsMapAxis;
    std::optional<SearchMemory> search;
    /// Radius of the sphere that a stable map was made for, in world units; 0 before.
    double stableRadius = 0.0;
    /// How often the direction was given up for a smaller map.
    std::size_t orientationJumps = 0;
};

} // namespace Lixel
