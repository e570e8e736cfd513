#pragma once

#include "fit/focus/FrameFingerprint.h"
#include "fit/sampling/EdgeDensity.h"
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
    /// How far around the target the search looks next, and how often it has followed a frame.
    double step = 0.0;
    int turn = 0;
    /// What was thought of the target, and in how many frames in a row nothing changed since.
    double cost = 0.0;
    int calm = 0;
    FrameFingerprint fingerprint;
};

/// A map's axes as directions in the world: light space itself may rotate about the light from one
/// frame to the next.
using WorldAxes = std::array<Vec3, 2>;

MapAxes axesFromWorld(const WorldAxes& wsAxes, const LightImage& image);
WorldAxes axesInWorld(const MapAxes& axes, const LightImage& image);

/// What outlives a frame. A fit without it is as valid; only the choice among equally good maps may
/// differ.
struct FitMemory {
    /// The last map's axes.
    std::optional<WorldAxes> wsMapAxes;
    std::optional<SearchMemory> search;
    /// Radius of the sphere that a stable map was made for, in world units; 0 before.
    double stableRadius = 0.0;
    /// How often the last map's axis was given up, for a smaller map or because of rounding.
    std::size_t orientationJumps = 0;
};

/// Room for a rule's work. Nobody reads it after the rule.
struct RuleScratch {
    ClipScratch clip;
    std::vector<Vec3> vsPoints;
    std::vector<Vec3> directions;
    /// The focus region's hull with few vertices, for evaluating many warps.
    Polygon2 simpleHull;
    SampleScratch sampling;
    std::vector<ViewSample> samples;
    EdgeDensity edges;
    TexelExtent extent;
};

/// Room for placing the map. Nobody reads it after that.
struct PlacementScratch {
    /// The focus region's hull after the warp.
    Polygon2 warped;
    std::vector<Vec2> points;
    Polygon2 grown;
};

/** What is kept for each light, viewer and map: memory, the last fit's focus region, and scratch
    space that saves allocations. */
struct FitState {
    FitMemory memory;
    /// The last fit's.
    FocusRegion region;

    FocusScratch focusing;
    RuleScratch rule;
    PlacementScratch placement;
};

} // namespace Lixel
