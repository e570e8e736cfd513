#include "fit/BoxQuery.h"

#include "fit/Lanes.h"
#include "fit/VectorClones.h"

#include <bit>

namespace Lixel {
namespace {

constexpr std::size_t Parts = BoxSet::BlockSize / 4;
static_assert(BoxSet::BlockSize == 4 * Parts);

constexpr unsigned AllLanes = (1U << BoxSet::BlockSize) - 1;

/// A half space, prepared for the question whether a box reaches into it.
struct Reach {
    /// For each axis the box's face that reaches farthest: 0 the lower, 1 the upper.
    std::array<std::size_t, 3> face;
    std::array<double, 3> normal;
    double offset;
};

/// @param extent of the boxes that it is for
Reach reachOf(const Plane& plane, double extent) {
    Reach reach;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double n = plane.normal[static_cast<Eigen::Index>(axis)];
        reach.face[axis] = n > 0.0 ? 1 : 0;
        reach.normal[axis] = n;
    }
    // One slack for all boxes: what it keeps in vain is found out later.
    reach.offset = plane.offset + TouchingSlack * (std::abs(plane.offset) +
                                                   plane.normal.cwiseAbs().sum() * extent);
    return reach;
}

// Inlined into each clone, the following are compiled for its processor.

/// Collects sign bits: a lane is negative once one of its values was.
[[gnu::always_inline]] inline void collect(const Four& value, FourBits& negative) {
    FourBits bits;
    std::memcpy(&bits, &value, sizeof(bits));
    negative |= bits;
}

/// The lanes that are not negative, as bits.
[[gnu::always_inline]] inline unsigned notNegative(const std::array<FourBits, Parts>& negative) {
    static_assert(Parts == 2);
    const FourBits signs = (negative[0] >> 63) | ((negative[1] >> 63) << 4);
    const std::uint64_t all = signs[0] | (signs[1] << 1) | (signs[2] << 2) | (signs[3] << 3);
    return static_cast<unsigned>(all) ^ AllLanes;
}

/// Blocks that are asked before any of them is looked at again, so that the processor need not wait
/// for the answers.
constexpr std::size_t Batch = 64;

/// Half spaces that all blocks are asked about; most boxes are outside one of the first few.
constexpr std::size_t FirstPlanes = 3;

/// The faces of a block's boxes, for each axis the lower and the upper.
using Faces = std::array<std::array<std::array<Four, Parts>, 2>, 3>;

[[gnu::always_inline]] inline void findFaces(const BoxSet::Block& block, Faces& faces) {
    for (std::size_t part = 0; part < Parts; ++part)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Four centre;
            Four half;
            load(block.centre[axis].data() + 4 * part, centre);
            load(block.halfExtents[axis].data() + 4 * part, half);
            faces[axis][0][part] = centre - half;
            faces[axis][1][part] = centre + half;
        }
}

[[gnu::always_inline]] inline void collectReach(const Faces& faces, const Reach& reach,
                                                std::array<FourBits, Parts>& negative) {
    for (std::size_t part = 0; part < Parts; ++part) {
        const Four farthest = (reach.normal[0] * faces[0][reach.face[0]][part] +
                               reach.normal[1] * faces[1][reach.face[1]][part]) +
                              (reach.normal[2] * faces[2][reach.face[2]][part] + reach.offset);
        collect(farthest, negative[part]);
    }
}

/// For each block of a batch, the lanes of boxes that reach into each half space.
LIXEL_VECTOR_CLONES
void lanesReaching(std::span<const BoxSet::Block> blocks, std::span<const Reach> reaches,
                   unsigned* lanes) {
    const std::size_t first = std::min(FirstPlanes, reaches.size());
    Faces faces;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        findFaces(blocks[i], faces);
        std::array<FourBits, Parts> negative{};
        for (std::size_t k = 0; k < first; ++k)
            collectReach(faces, reaches[k], negative);
        lanes[i] = notNegative(negative);
    }
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (lanes[i] == 0) continue;
        findFaces(blocks[i], faces);
        std::array<FourBits, Parts> negative{};
        for (std::size_t k = first; k < reaches.size(); ++k)
            collectReach(faces, reaches[k], negative);
        lanes[i] &= notNegative(negative);
    }
}

} // namespace

void keepReaching(const BoxSet& boxes, std::span<const Plane> planes, BoxSet& kept,
                  std::vector<std::size_t>& indices) {
    kept.clear();
    indices.clear();
    // A hull of more edges than this drops fewer boxes here; that costs time alone.
    std::array<Reach, 2 * ConvexVolume::Capacity> reaches;
    const std::size_t count = std::min(planes.size(), reaches.size());
    for (std::size_t i = 0; i < count; ++i)
        reaches[i] = reachOf(planes[i], boxes.extent());
    std::array<unsigned, Batch> reaching;
    for (std::size_t first = 0; first < boxes.blocks().size(); first += Batch) {
        const auto blocks =
            boxes.blocks().subspan(first, std::min(Batch, boxes.blocks().size() - first));
        lanesReaching(blocks, {reaches.data(), count}, reaching.data());
        for (std::size_t i = 0; i < blocks.size(); ++i)
            for (unsigned lanes = reaching[i]; lanes != 0; lanes &= lanes - 1) {
                const std::size_t index = (first + i) * BoxSet::BlockSize +
                                          static_cast<std::size_t>(std::countr_zero(lanes));
                if (index >= boxes.size()) continue;
                kept.copy(boxes, index);
                indices.push_back(index);
            }
    }
}

LIXEL_VECTOR_CLONES
unsigned lanesInside(const BoxSet::Block& block, std::span<const Plane> planes) {
    std::array<FourBits, Parts> negative{};
    for (std::size_t part = 0; part < Parts; ++part) {
        std::array<Four, 3> centre;
        std::array<Four, 3> half;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            load(block.centre[axis].data() + 4 * part, centre[axis]);
            load(block.halfExtents[axis].data() + 4 * part, half[axis]);
        }
        for (const Plane& plane : planes) {
            const double x = plane.normal.x();
            const double y = plane.normal.y();
            const double z = plane.normal.z();
            const Four distance = (x * centre[0] + y * centre[1]) + (z * centre[2] + plane.offset);
            const Four reach =
                (std::abs(x) * half[0] + std::abs(y) * half[1]) + std::abs(z) * half[2];
            collect(distance - reach, negative[part]);
        }
    }
    return notNegative(negative);
}

std::size_t largestBox(const BoxSet& boxes) {
    double largest = -1.0;
    std::size_t result = 0;
    std::size_t index = 0;
    for (const BoxSet::Block& block : boxes.blocks())
        for (std::size_t lane = 0; lane < BoxSet::BlockSize; ++lane, ++index) {
            const double size = block.halfExtents[0][lane] + block.halfExtents[1][lane] +
                                block.halfExtents[2][lane];
            if (size > largest && index < boxes.size()) {
                largest = size;
                result = index;
            }
        }
    return result;
}

} // namespace Lixel
