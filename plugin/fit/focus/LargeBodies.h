#pragma once

#include "fit/geometry/BoxQuery.h"

#include <array>
#include <limits>
#include <span>

namespace Lixel {

/** The few largest bodies of a set, by their boxes: those that are worth asking about their shapes.
    What is smaller hardly changes a map. */
class LargeBodies {
public:
    static constexpr std::size_t Most = 8;
    /// Bodies whose half extents add up to less than this part of the largest's are not large.
    static constexpr double LeastPart = 0.25;

    /// None.
    LargeBodies() = default;
    explicit LargeBodies(const BoxSet& boxes) : mCount(largestBoxes(boxes, mIndices)) {
        if (mCount == 0) return;
        const auto sizeOf = [&](std::size_t i) { return boxes.box(mIndices[i]).halfExtents.sum(); };
        mLeastSize = LeastPart * sizeOf(0);
        while (sizeOf(mCount - 1) < mLeastSize)
            --mCount;
        mSmallest = sizeOf(mCount - 1);
    }

    /// Their indices in the set, the largest first.
    std::span<const std::size_t> indices() const { return {mIndices.data(), mCount}; }
    /// Sum of half extents from which on a body may be large; infinite where none is.
    double leastSize() const { return mLeastSize; }
    /// Whether a body of the set is among them, or as large as the smallest of them.
    bool holds(const Aabb& box) const { return box.halfExtents.sum() >= mSmallest; }

private:
    std::array<std::size_t, Most> mIndices{};
    std::size_t mCount = 0;
    double mLeastSize = std::numeric_limits<double>::infinity();
    double mSmallest = std::numeric_limits<double>::infinity();
};

} // namespace Lixel
