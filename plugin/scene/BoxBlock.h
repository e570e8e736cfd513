#pragma once

#include "scene/NodeCuller.h"

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

/// A volume's planes in single precision.
struct ScanPlanes {
    struct Plane {
        float normal[3];
        float size[3];
        float offset;
    };
    std::array<Plane, NodeCuller::Capacity> list;
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
    using Reach = float[Capacity];

    struct alignas(64) Eight {
        float centre[3][Lanes];
        float half[3][Lanes];
    };

    enum class Side { Outside, Cut, Inside };
    /// How a volume lies to the block: which of its planes cut the block, and from which distance to
    /// them on a box's side is certain.
    struct Cut {
        Side side = Side::Inside;
        float doubt = 0.0F;
        std::size_t count = 0;
        std::array<std::size_t, NodeCuller::Capacity> planes;
    };

    BoxBlock();

    FlatBox box(std::size_t index) const;
    /// Writes a box, and has the block's own reach around it.
    void write(std::size_t index, const FlatBox& box);
    void append(std::uint32_t slot, const FlatBox& box);
    /// The same for a box that was there.
    /// @returns whether the block's own box may be larger than it need be now
    bool replace(std::size_t index, const FlatBox& box);
    /// Which ends of the block's own box a box reaches, a bit each: without it the block may be
    /// smaller.
    unsigned endsReached(std::size_t index) const;
    /// Has the block's own box be no larger than it need be.
    void findBounds();

    Cut cutBy(const ScanPlanes& planes) const;
    /// For each box, how far it reaches into the half spaces of the cutting planes at least:
    /// negative where it is outside of one.
    void reachInto(const ScanPlanes& planes, const Cut& cut, Reach& least) const;

    /// Boxes whose keys are at least this and less than the next block's first one are here.
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
