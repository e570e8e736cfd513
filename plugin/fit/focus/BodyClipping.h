#pragma once

#include "fit/focus/FocusScratch.h"
#include "fit/geometry/BodyHull.h"
#include "fit/geometry/BoxQuery.h"

#include <bit>

/// What collecting receivers and collecting casters have in common.
namespace Lixel {

/** Calls `add` for the boxes of a set and their origins, except those in `within(block)`, a set of
    lanes as bits which may grow where `add` returns true. The largest comes first: it is the
    likeliest to spare the others. */
template <typename Within, typename Add>
void addAllBut(const BoxSet& boxes, const Within& within, const Add& add) {
    if (boxes.size() == 0) return;
    const std::size_t largest = largestBox(boxes);
    add(boxes.box(largest), boxes.origin(largest));
    std::size_t first = 0;
    for (const BoxSet::Block& block : boxes.blocks()) {
        unsigned rest = boxes.lanes(first / BoxSet::BlockSize);
        if (largest - first < BoxSet::BlockSize) rest &= ~(1U << (largest - first));
        rest &= ~within(block);
        while (rest != 0) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
            rest &= rest - 1;
            if (add(boxes.box(first + lane), boxes.origin(first + lane)) && rest != 0)
                rest &= ~within(block);
        }
        first += BoxSet::BlockSize;
    }
}

/// A body's hull, if it is known, and where it is.
struct PlacedHull {
    const BodyHull* hull = nullptr;
    Transform3 wsFromBody;

    PlacedHull(const BodyShapes* shapes, std::size_t index) {
        if (shapes != nullptr) hull = shapes->hullOf(index, wsFromBody);
        if (hull != nullptr && !wsFromBody.matrix().allFinite()) hull = nullptr;
    }

    /// Leaves in the scratch memory the vertices of what the volume leaves of the body: of its
    /// hull, if it is known, else of its box.
    void clip(const Aabb& box, const ConvexVolume& volume, FocusScratch& scratch) const {
        scratch.wsPoints.clear();
        if (hull != nullptr)
            clipHull(*hull, wsFromBody, volume, scratch.clip, scratch.wsPoints);
        else
            clipBox(box, volume, scratch.clip, scratch.wsPoints);
    }
};

/// Calls `visit` with each clipped point in the scratch memory, in the world and in light space.
template <typename Visit>
void forClipped(const ShadowProblem& problem, const LightImage& image, const FocusScratch& scratch,
                const Visit& visit) {
    for (const Vec3& ws : scratch.wsPoints) {
        const Vec3 ls = image.lsFromPoint(ws);
        // Clipping leaves no depth below the near distance, except for rounding. Skipping below
        // half of it makes the division by depth safe.
        if (!image.directional() && -ls.z() < 0.5 * problem.light.nearDistance) continue;
        visit(ws, ls);
    }
}

} // namespace Lixel
