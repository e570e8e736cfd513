#pragma once

#include "scene/NodeCuller.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace Lixel {

/// A box in single precision.
struct FlatBox {
    float centre[3];
    float half[3];

    /// Of a box that is finite.
    static FlatBox of(const Ogre::AxisAlignedBox& bounds);
    /// Whether its ends are finite too, so that it can be sorted and compared.
    bool hasBounds() const;
    /// @see SpatialKey.h
    std::uint64_t key() const;
};

/// A volume's planes in single precision: each number of eight planes lies beside the same of the
/// next, for vector registers. Lanes beyond `count` are no planes.
struct ScanPlanes {
    static constexpr std::size_t Capacity = (NodeCuller::Capacity + 7) / 8 * 8;

    float normal[3][Capacity]{};
    /// The normal's, without signs.
    float size[3][Capacity]{};
    float offset[Capacity]{};
    std::size_t count;

    explicit ScanPlanes(const NodeCuller& volume);
};

/** A block of boxes that are near to each other, with a box around them all.

    Each number of eight boxes lies beside the same of the next, for vector registers; and the
    numbers of one box lie in three lines of the cache, since boxes that move come singly.
*/
struct BoxBlock {
    static constexpr std::size_t Lanes = 8;
    static constexpr std::size_t Capacity = 8 * Lanes;

    struct alignas(64) Eight {
        float centre[3][Lanes];
        float half[3][Lanes];
    };

    enum class Side { Outside, Cut, Inside };
    /// How a volume lies to the block: which of its planes cut the block, and from which distance
    /// to them on a box's side is certain.
    struct Cut {
        Side side = Side::Inside;
        float doubt = 0.0F;
        std::size_t count = 0;
        std::array<std::uint8_t, NodeCuller::Capacity> planes;
    };
    /// Boxes, a bit each.
    struct Found {
        /// Those that touch the volume.
        std::uint64_t certain = 0;
        /// Those that may, as far as single precision tells; and what is not a number.
        std::uint64_t doubtful = 0;
    };

    BoxBlock();

    FlatBox box(std::size_t index) const;
    /// Writes a box, and has the block's own reach around it.
    void write(std::size_t index, const FlatBox& box);
    void append(std::uint32_t slot, const FlatBox& box);
    /// The same for a box that was there.
    /// @returns whether the block's own box may be larger than it need be now
    bool replace(std::size_t index, const FlatBox& box);
    /// Whether a box that was in the block may stay there, whatever its key is: it is of the
    /// block's sizes, and the block needs to be no larger for it.
    bool keeps(const FlatBox& box) const;
    /// Which ends of the block's own box a box reaches, a bit each: without it the block may be
    /// smaller.
    unsigned endsReached(std::size_t index) const;
    /// Has the block's own box be no larger than it need be.
    void findBounds();

    Cut cutBy(const ScanPlanes& planes) const;
    /// The boxes that touch a volume which cuts the block.
    Found touching(const ScanPlanes& planes, const Cut& cut) const;
    /// A bit for each box.
    std::uint64_t allBoxes() const {
        return count < Capacity ? (std::uint64_t{1} << count) - 1 : ~std::uint64_t{0};
    }
    /// The key of the block's part of the order that is next to this one.
    std::uint64_t keyWithin(std::uint64_t key) const {
        return firstKey < endKey ? std::clamp(key, firstKey, endKey - 1) : firstKey;
    }

    /// Boxes that come with keys from the first to before the end belong here. Those that wander
    /// stay for as long as the block keeps them.
    std::uint64_t firstKey = 0;
    std::uint64_t endKey = 0;
    /// Around all boxes.
    float lower[3];
    float upper[3];
    std::uint32_t count = 0;
    /// Whether it may be larger than it need be.
    bool loose = false;

    std::array<Eight, Capacity / Lanes> boxes{}; // lanes without a box are compared too
    std::uint32_t slots[Capacity];
};

} // namespace Lixel
