#include "fit/geometry/BoxQuery.h"

#include "fit/geometry/Multiversion.h"
#include "fit/geometry/Simd.h"

#include <limits>

namespace Lixel {
namespace {

// A block is two times four boxes.
static_assert(BoxSet::BlockSize == 8);

constexpr unsigned AllLanes = (1U << BoxSet::BlockSize) - 1;

/// The faces of a block's boxes: for each axis the lower ones, and behind them the upper ones.
using Faces = std::array<std::array<double, 2 * BoxSet::BlockSize>, 3>;

/// One corner of every box: for each axis, the index in Faces at which its coordinates begin.
using Corner = std::array<std::size_t, 3>;

/// A half space, prepared for the question whether a box reaches into it.
struct Reach {
    /// The one that reaches farthest.
    Corner farthest;
    std::array<double, 3> normal;
    double offset;
};

/// @param extent of the boxes that it is for
Reach reachOf(const HalfSpace& plane, double extent) {
    Reach reach;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double n = plane.normal[static_cast<Eigen::Index>(axis)];
        reach.farthest[axis] = n > 0.0 ? BoxSet::BlockSize : 0;
        reach.normal[axis] = n;
    }
    // One slack for all boxes: a later question drops what it keeps too much.
    reach.offset = plane.offset + TouchingSlack * (std::abs(plane.offset) +
                                                   plane.normal.cwiseAbs().sum() * extent);
    return reach;
}

// Inlined into each clone, the following are compiled for its processor.

/// Collects sign bits: a lane is negative once one of its values was.
[[gnu::always_inline]] inline void collect(const Four& value, FourMask& negative) {
    FourMask bits;
    std::memcpy(&bits, &value, sizeof(bits));
    negative |= bits;
}

/// The lanes that are not negative, as bits.
[[gnu::always_inline]] inline unsigned notNegative(const FourMask& low, const FourMask& high) {
    return (bitsOf(low) | bitsOf(high) << 4) ^ AllLanes;
}

[[gnu::always_inline]] inline void findFaces(const BoxSet::Block& block, Faces& faces) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t lane = 0; lane < BoxSet::BlockSize; lane += 4) {
            Four centre;
            Four half;
            load(&block.centre[axis][lane], centre);
            load(&block.halfExtents[axis][lane], half);
            store(centre - half, &faces[axis][lane]);
            store(centre + half, &faces[axis][BoxSet::BlockSize + lane]);
        }
}

/// Collects the signs of a plane's distances from that corner, of four boxes from `lane` on.
/// (Without a loop: in one GCC copies them.)
[[gnu::always_inline]] inline void collectCorners(const Faces& faces, const Corner& at,
                                                  std::size_t lane, const double* normal,
                                                  double offset, FourMask& negative) {
    Four x;
    Four y;
    Four z;
    load(&faces[0][at[0] + lane], x);
    load(&faces[1][at[1] + lane], y);
    load(&faces[2][at[2] + lane], z);
    collect((normal[0] * x + normal[1] * y) + (normal[2] * z + offset), negative);
}

/// Blocks that are asked before any of them is looked at again, so that the processor need not wait
/// for the answers.
constexpr std::size_t Batch = 64;

/// Half spaces that all boxes are asked about; most are outside one of the first few.
constexpr std::size_t FirstPlanes = 3;

/// For each block of a batch, the lanes of boxes that reach into each half space.
LIXEL_MULTIVERSION
void lanesReaching(std::span<const BoxSet::Block> blocks, std::span<const Reach> reaches,
                   unsigned* lanes) {
    Faces faces;
    for (const BoxSet::Block& block : blocks) {
        findFaces(block, faces);
        FourMask low{};
        FourMask high{};
        for (const Reach& reach : reaches) {
            collectCorners(faces, reach.farthest, 0, reach.normal.data(), reach.offset, low);
            collectCorners(faces, reach.farthest, 4, reach.normal.data(), reach.offset, high);
        }
        *lanes++ = notNegative(low, high);
    }
}

/// Copies the boxes that reach into each half space.
void copyReaching(const BoxSet& boxes, std::span<const Reach> reaches, BoxSet& kept) {
    kept.clear();
    const std::span<const BoxSet::Block> blocks = boxes.blocks();
    std::array<unsigned, Batch> reaching;
    for (std::size_t first = 0; first < blocks.size(); first += Batch) {
        const std::size_t count = std::min(Batch, blocks.size() - first);
        lanesReaching(blocks.subspan(first, count), reaches, reaching.data());
        for (std::size_t i = 0; i < count; ++i)
            kept.copy(boxes, first + i, reaching[i] & boxes.lanes(first + i));
    }
}

} // namespace

void keepReaching(const BoxSet& boxes, std::span<const HalfSpace> planes, BoxSet& scratch,
                  BoxSet& kept) {
    // A hull of more edges than this drops fewer boxes here; that costs time alone.
    std::array<Reach, 2 * ConvexVolume::Capacity> reaches;
    const std::size_t count = std::min(planes.size(), reaches.size());
    for (std::size_t i = 0; i < count; ++i)
        reaches[i] = reachOf(planes[i], boxes.extent());
    const std::span<const Reach> all(reaches.data(), count);
    if (count <= FirstPlanes) return copyReaching(boxes, all, kept);
    // The few that are left move together first.
    copyReaching(boxes, all.first(FirstPlanes), scratch);
    copyReaching(scratch, all.subspan(FirstPlanes), kept);
}

LIXEL_MULTIVERSION
unsigned lanesInside(const BoxSet::Block& block, std::span<const HalfSpace> planes) {
    Faces faces;
    findFaces(block, faces);
    FourMask low{};
    FourMask high{};
    for (const HalfSpace& plane : planes) {
        Corner nearest;
        for (std::size_t axis = 0; axis < 3; ++axis)
            nearest[axis] =
                plane.normal[static_cast<Eigen::Index>(axis)] < 0.0 ? BoxSet::BlockSize : 0;
        collectCorners(faces, nearest, 0, plane.normal.data(), plane.offset, low);
        collectCorners(faces, nearest, 4, plane.normal.data(), plane.offset, high);
    }
    return notNegative(low, high);
}

namespace {

/// Blocks that are looked at for the farthest box, at most: more cost more time than they spare.
constexpr std::size_t FarBlocks = 64;

/// The box farthest along a direction, of every `step`th block.
LIXEL_MULTIVERSION
std::size_t farthestBox(const BoxSet& boxes, const Vec3& direction, std::size_t step) {
    const std::span<const BoxSet::Block> blocks = boxes.blocks();
    double most = -std::numeric_limits<double>::infinity();
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < blocks.size(); i += step) {
        std::array<double, BoxSet::BlockSize> along;
        Four greatest = Four{} + most;
        for (std::size_t lane = 0; lane < BoxSet::BlockSize; lane += 4) {
            Four x;
            Four y;
            Four z;
            load(&blocks[i].centre[0][lane], x);
            load(&blocks[i].centre[1][lane], y);
            load(&blocks[i].centre[2][lane], z);
            const Four value = direction[0] * x + direction[1] * y + direction[2] * z;
            store(value, &along[lane]);
            greater(value, greatest, greatest);
        }
        const FourMask better = greatest > most;
        if (bitsOf(better) == 0) continue;
        for (unsigned lanes = boxes.lanes(i); lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            if (!(along[lane] > most)) continue;
            most = along[lane];
            farthest = i * BoxSet::BlockSize + lane;
        }
    }
    return farthest;
}

} // namespace

void farBoxes(const BoxSet& boxes, std::span<const Vec3> directions,
              std::span<std::size_t> farthest) {
    const std::size_t step = (boxes.blocks().size() + FarBlocks - 1) / FarBlocks;
    for (std::size_t i = 0; i < directions.size(); ++i)
        farthest[i] = farthestBox(boxes, directions[i], std::max(step, std::size_t{1}));
}

std::size_t largestBox(const BoxSet& boxes) {
    std::size_t result = 0;
    largestBoxes(boxes, {&result, 1});
    return result;
}

namespace {

/// The lanes of a block whose sum of half extents is greater than that.
LIXEL_MULTIVERSION
unsigned lanesLargerThan(const BoxSet::Block& block, double size) {
    std::array<FourMask, 2> larger;
    for (std::size_t half = 0; half < 2; ++half) {
        Four x;
        Four y;
        Four z;
        load(&block.halfExtents[0][4 * half], x);
        load(&block.halfExtents[1][4 * half], y);
        load(&block.halfExtents[2][4 * half], z);
        larger[half] = x + y + z > size;
    }
    return bitsOf(larger[0]) | bitsOf(larger[1]) << 4;
}

} // namespace

std::size_t largestBoxes(const BoxSet& boxes, std::span<std::size_t> largest) {
    std::size_t count = 0;
    double least = -1.0; // the size that there is no room for
    const auto sizeOf = [&](std::size_t index) { return boxes.box(index).halfExtents.sum(); };
    for (std::size_t block = 0; block < boxes.blocks().size(); ++block) {
        unsigned lanes = lanesLargerThan(boxes.blocks()[block], least) & boxes.lanes(block);
        for (; lanes != 0; lanes &= lanes - 1) {
            const std::size_t index =
                block * BoxSet::BlockSize + static_cast<std::size_t>(std::countr_zero(lanes));
            const double size = sizeOf(index);
            if (!(size > least)) continue;
            std::size_t at = count < largest.size() ? count++ : count - 1;
            for (; at > 0 && sizeOf(largest[at - 1]) < size; --at)
                largest[at] = largest[at - 1];
            largest[at] = index;
            if (count == largest.size()) least = sizeOf(largest[count - 1]);
        }
    }
    return count;
}

} // namespace Lixel
