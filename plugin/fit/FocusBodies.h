#pragma once

#include "fit/BodyHull.h"
#include "fit/BoxQuery.h"

#include <bit>

/// What collecting receivers and collecting casters have in common.
namespace Lixel {

/** Calls `add` for the boxes of a set and their origins, but for those in `within(block)`, a set of
    lanes as bits which may grow where `add` returns true. The largest comes first: it is the
    likeliest to spare the others. */
template <typename Within, typename Add>
void addAllBut(const BoxSet& boxes, const Within& within, const Add& add) {
    if (boxes.size() == 0) return;
    const std::size_t largest = largestBox(boxes);
    add(boxes.box(largest), boxes.origin(largest));
    std::size_t first = 0;
    for (const BoxSet::Block& block : boxes.blocks()) {
        const std::size_t count = std::min(boxes.size() - first, BoxSet::BlockSize);
        unsigned rest = (1U << count) - 1;
        if (largest - first < count) rest &= ~(1U << (largest - first));
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
    Eigen::Affine3d wsFromBody;

    PlacedHull(const BodyShapes* shapes, std::size_t index) {
        if (shapes != nullptr) hull = shapes->hullOf(index, wsFromBody);
        if (hull != nullptr && !wsFromBody.matrix().allFinite()) hull = nullptr;
    }
};

} // namespace Lixel
