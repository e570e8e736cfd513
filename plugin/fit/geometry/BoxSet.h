#pragma once

#include "fit/geometry/Types.h"

#include <algorithm>
#include <bit>
#include <ranges>
#include <span>

namespace Lixel {
/// @addtogroup LixelFit
/// @{

/** The boxes of one frame's casters or receivers, in world axes.

    Bad input is counted instead of stored, so that a reader of the set can say why there is
    no map: a box with a NaN is `invalid`, one with an infinite extent, or one beyond
    1e18, is `unbounded`.

    Boxes are stored in blocks of eight, each number of them beside the same number of the next:
    what asks all of them one question asks it in vector registers.
*/
class BoxSet {
public:
    static constexpr std::size_t BlockSize = 8;
    /// Eight boxes: one array of lanes for each axis. Lanes beyond the last box are zero.
    struct Block {
        using Lanes = std::array<double, BlockSize>;
        std::array<Lanes, 3> centre;
        std::array<Lanes, 3> halfExtents;
        /// Of each lane's box, its index in the set that it was first added to.
        std::array<std::uint32_t, BlockSize> origin;
    };

    void clear() {
        mBlocks.clear();
        mSize = 0;
        mExtent = 0.0;
        mUnbounded = 0;
        mInvalid = 0;
    }
    void add(const Aabb& box) {
        const Vec3 reach = box.centre.cwiseAbs() + box.halfExtents;
        // No comparison with a NaN holds.
        if ((reach.array() <= GreatestExtent).all() && (box.halfExtents.array() >= 0.0).all()) {
            mExtent = std::max(mExtent, reach.maxCoeff());
            store(box);
        } else if (box.centre.hasNaN() || box.halfExtents.hasNaN() ||
                   box.halfExtents.minCoeff() < 0.0) {
            ++mInvalid;
        } else {
            ++mUnbounded;
        }
    }
    /// Adds boxes of a set, which have been judged there: those of a block in these lanes, as bits.
    void copy(const BoxSet& from, std::size_t block, unsigned lanes) {
        const Block& source = from.mBlocks[block];
        mExtent = std::max(mExtent, from.mExtent);
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto sourceLane = static_cast<std::size_t>(std::countr_zero(lanes));
            const std::size_t lane = nextLane();
            Block& target = mBlocks.back();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                target.centre[axis][lane] = source.centre[axis][sourceLane];
                target.halfExtents[axis][lane] = source.halfExtents[axis][sourceLane];
            }
            target.origin[lane] = source.origin[sourceLane];
        }
    }
    /// Counts a body that has no bounds: it may be anywhere.
    void addUnbounded() { ++mUnbounded; }

    /// A bound on the boxes' coordinates: |x|, |y| and |z| of their points are at most this.
    double extent() const { return mExtent; }
    /// How many boxes are stored.
    std::size_t size() const { return mSize; }
    /// The box of that index, below size().
    Aabb box(std::size_t index) const {
        const Block& block = mBlocks[index / BlockSize];
        const std::size_t lane = index % BlockSize;
        return {
            {block.centre[0][lane], block.centre[1][lane], block.centre[2][lane]},
            {block.halfExtents[0][lane], block.halfExtents[1][lane], block.halfExtents[2][lane]}};
    }
    /// The box's index in the set that it was first added to, however often it was copied since.
    std::size_t origin(std::size_t index) const {
        return mBlocks[index / BlockSize].origin[index % BlockSize];
    }
    /// All boxes in turn, by value.
    auto boxes() const {
        return std::views::iota(std::size_t{0}, mSize) |
               std::views::transform([this](std::size_t index) { return box(index); });
    }
    /// The same in blocks; the last one's lanes from size() on are not boxes.
    std::span<const Block> blocks() const { return mBlocks; }
    /// The lanes of that block which are boxes, as bits.
    unsigned lanes(std::size_t block) const {
        return (1U << std::min(mSize - block * BlockSize, BlockSize)) - 1;
    }

    std::size_t unbounded() const { return mUnbounded; }
    std::size_t invalid() const { return mInvalid; }
    bool empty() const { return mSize == 0 && mUnbounded == 0; }

private:
    /// Makes room for one box more, in that lane of the last block.
    std::size_t nextLane() {
        const std::size_t lane = mSize++ % BlockSize;
        if (lane == 0) mBlocks.emplace_back();
        return lane;
    }
    void store(const Aabb& box) {
        const std::size_t lane = nextLane();
        Block& block = mBlocks.back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            block.centre[axis][lane] = box.centre[static_cast<Eigen::Index>(axis)];
            block.halfExtents[axis][lane] = box.halfExtents[static_cast<Eigen::Index>(axis)];
        }
        block.origin[lane] = static_cast<std::uint32_t>(mSize - 1);
    }

    std::vector<Block> mBlocks;
    std::size_t mSize = 0;
    double mExtent = 0.0;
    std::size_t mUnbounded = 0;
    std::size_t mInvalid = 0;
};

/// @}
} // namespace Lixel
