#include "scene/BoxBlock.h"

#include "fit/geometry/Multiversion.h"
#include "fit/geometry/Simd.h"
#include "scene/SpatialKey.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace Lixel {
namespace {

/// A sum of at most six products and a plane's offset in single precision, in two orders: this much
/// of the sum of the terms' sizes leaves an answer in doubt. It is 32 times the rounding of one
/// operation (2⁻²⁴), and covers the slack of CasterVolume (2⁻²¹).
constexpr float Rounding = 0x1p-19F;

/// A vector in space for each of eight boxes. No array of them: GCC would put it into memory.
struct EightVectors {
    EightFloats x, y, z;

    /// @param from lanes of x, y and z, on a line of the cache
    [[gnu::always_inline]] explicit EightVectors(const float (&from)[3][BoxBlock::Lanes]) {
        loadAligned(from[0], x);
        loadAligned(from[1], y);
        loadAligned(from[2], z);
    }
};

/// Compares boxes with the planes that cut their block, eight at a time.
LIXEL_MULTIVERSION void compare(const BoxBlock& block, const ScanPlanes& planes,
                                const BoxBlock::Cut& cut, BoxBlock::Found& result) {
    BoxBlock::Found found;
    for (std::size_t i = 0; i * BoxBlock::Lanes < block.count; ++i) {
        const EightVectors centre(block.boxes[i].centre);
        const EightVectors half(block.boxes[i].half);
        EightMask inside = EightMask{} == 0;
        EightMask outside{};
        for (std::size_t k = 0; k < cut.count; ++k) {
            const std::size_t plane = cut.planes[k];
            const auto& normal = planes.normal;
            const auto& size = planes.size;
            const EightFloats reach =
                (planes.offset[plane] + normal[0][plane] * centre.x + size[0][plane] * half.x) +
                ((normal[1][plane] * centre.y + size[1][plane] * half.y) +
                 (normal[2][plane] * centre.z + size[2][plane] * half.z));
            inside &= reach > cut.doubt;
            outside |= reach < -cut.doubt;
        }
        const std::size_t shift = i * BoxBlock::Lanes;
        found.certain |= std::uint64_t{bitsOf(inside)} << shift;
        found.doubtful |= std::uint64_t{bitsOf(~inside & ~outside)} << shift;
    }
    result.certain = found.certain & block.allBoxes();
    result.doubtful = found.doubtful & block.allBoxes();
}

/// Compares a block's own box with planes, eight at a time.
LIXEL_MULTIVERSION void cutBlock(const BoxBlock& block, const ScanPlanes& planes,
                                 BoxBlock::Cut& cut) {
    float middle[3];
    float half[3];
    float size = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        middle[axis] = (block.lower[axis] + block.upper[axis]) / 2.0F;
        half[axis] = (block.upper[axis] - block.lower[axis]) / 2.0F;
        size += std::max(std::abs(block.lower[axis]), std::abs(block.upper[axis]));
    }
    for (std::size_t first = 0; first < planes.count; first += BoxBlock::Lanes) {
        EightFloats offset;
        load(planes.offset + first, offset);
        EightFloats at = offset;
        EightFloats reach{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EightFloats normal;
            EightFloats along;
            load(planes.normal[axis] + first, normal);
            load(planes.size[axis] + first, along);
            at += normal * middle[axis];
            reach += along * half[axis];
        }
        const EightFloats doubt = Rounding * ((offset < 0.0F ? -offset : offset) + size);
        const unsigned valid = (1U << std::min(planes.count - first, BoxBlock::Lanes)) - 1;
        if ((bitsOf(at + reach < -doubt) & valid) != 0) {
            cut.side = BoxBlock::Side::Outside;
            return;
        }
        // What is not a number is not inside.
        for (unsigned cuts = ~bitsOf(at - reach > doubt) & valid; cuts != 0; cuts &= cuts - 1) {
            const int lane = std::countr_zero(cuts);
            cut.side = BoxBlock::Side::Cut;
            cut.planes[cut.count++] = static_cast<std::uint8_t>(first + lane);
            cut.doubt = std::max(cut.doubt, doubt[lane]);
        }
    }
}

/// Lowest and highest coordinates of the block's boxes along one axis.
LIXEL_MULTIVERSION void findEnds(const BoxBlock& block, int axis, float& lowest, float& highest) {
    EightFloats lower = EightFloats{} + std::numeric_limits<float>::infinity();
    EightFloats upper = -lower;
    const std::size_t whole = block.count / BoxBlock::Lanes;
    for (std::size_t i = 0; i < whole; ++i) {
        EightFloats centre;
        EightFloats half;
        load(block.boxes[i].centre[axis], centre);
        load(block.boxes[i].half[axis], half);
        const EightFloats low = centre - half;
        const EightFloats high = centre + half;
        lower = low < lower ? low : lower;
        upper = high > upper ? high : upper;
    }
    lowest = lower[0];
    highest = upper[0];
    for (std::size_t lane = 1; lane < BoxBlock::Lanes; ++lane) {
        lowest = std::min(lowest, lower[lane]);
        highest = std::max(highest, upper[lane]);
    }
    for (std::size_t lane = 0; lane < block.count % BoxBlock::Lanes; ++lane) {
        const BoxBlock::Eight& last = block.boxes[whole];
        lowest = std::min(lowest, last.centre[axis][lane] - last.half[axis][lane]);
        highest = std::max(highest, last.centre[axis][lane] + last.half[axis][lane]);
    }
}

} // namespace

FlatBox FlatBox::of(const Ogre::AxisAlignedBox& bounds) {
    const Ogre::Vector3 centre = bounds.getCenter();
    const Ogre::Vector3 half = bounds.getHalfSize();
    return {{centre.x, centre.y, centre.z}, {half.x, half.y, half.z}};
}

bool FlatBox::hasBounds() const {
    // Sums that do not wait for each other.
    return std::isfinite((std::abs(centre[0]) + half[0]) +
                         ((std::abs(centre[1]) + half[1]) + (std::abs(centre[2]) + half[2])));
}

std::uint64_t FlatBox::key() const {
    return spatialKey(centre, half);
}

ScanPlanes::ScanPlanes(const NodeCuller& volume) : count(volume.size()) {
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            normal[axis][i] = static_cast<float>(volume[i].normal[axis]);
            size[axis][i] = std::abs(normal[axis][i]);
        }
        offset[i] = static_cast<float>(volume[i].offset);
    }
}

BoxBlock::BoxBlock() {
    findBounds();
}

FlatBox BoxBlock::box(std::size_t index) const {
    const Eight& eight = boxes[index / Lanes];
    const std::size_t lane = index % Lanes;
    FlatBox result;
    for (int axis = 0; axis < 3; ++axis) {
        result.centre[axis] = eight.centre[axis][lane];
        result.half[axis] = eight.half[axis][lane];
    }
    return result;
}

void BoxBlock::write(std::size_t index, const FlatBox& box) {
    Eight& eight = boxes[index / Lanes];
    const std::size_t lane = index % Lanes;
    for (int axis = 0; axis < 3; ++axis) {
        eight.centre[axis][lane] = box.centre[axis];
        eight.half[axis][lane] = box.half[axis];
        lower[axis] = std::min(lower[axis], box.centre[axis] - box.half[axis]);
        upper[axis] = std::max(upper[axis], box.centre[axis] + box.half[axis]);
    }
}

void BoxBlock::append(std::uint32_t slot, const FlatBox& box) {
    slots[count] = slot;
    write(count++, box);
}

bool BoxBlock::replace(std::size_t index, const FlatBox& box) {
    const unsigned before = endsReached(index);
    write(index, box);
    // Most boxes reach no end.
    return before != 0 && (before & ~endsReached(index)) != 0;
}

bool BoxBlock::keeps(const FlatBox& box) const {
    const std::uint64_t size = sizeClass(box.half);
    bool kept = size >= firstKey >> SizeClassShift && size <= endKey >> SizeClassShift;
    // No comparison with a NaN holds.
    for (int axis = 0; axis < 3; ++axis)
        kept = kept & (box.centre[axis] - box.half[axis] >= lower[axis]) &
               (box.centre[axis] + box.half[axis] <= upper[axis]);
    return kept;
}

unsigned BoxBlock::endsReached(std::size_t index) const {
    const FlatBox at = box(index);
    unsigned ends = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (at.centre[axis] - at.half[axis] <= lower[axis]) ends |= 1U << (2 * axis);
        if (at.centre[axis] + at.half[axis] >= upper[axis]) ends |= 2U << (2 * axis);
    }
    return ends;
}

void BoxBlock::findBounds() {
    for (int axis = 0; axis < 3; ++axis)
        findEnds(*this, axis, lower[axis], upper[axis]);
}

BoxBlock::Cut BoxBlock::cutBy(const ScanPlanes& planes) const {
    Cut cut;
    if (count == 0)
        cut.side = Side::Outside;
    else
        cutBlock(*this, planes, cut);
    return cut;
}

BoxBlock::Found BoxBlock::touching(const ScanPlanes& planes, const Cut& cut) const {
    Found found;
    compare(*this, planes, cut, found);
    return found;
}

} // namespace Lixel
