#include "scene/BoxBlock.h"

#include "fit/geometry/Multiversion.h"
#include "scene/SpatialKey.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Lixel {
namespace {

/// A sum of at most six products and a plane's offset in single precision, in two orders: this much
/// of the sum of the terms' sizes leaves an answer in doubt. It is 32 times the rounding of one
/// operation (2⁻²⁴), and covers the slack of CasterVolume (2⁻²¹).
constexpr float Rounding = 0x1p-19F;

LIXEL_MULTIVERSION void reachIntoPlane(const BoxBlock& block, const ScanPlanes::Plane& plane,
                                       BoxBlock::Reach& least) {
    for (std::size_t i = 0; i < BoxBlock::Capacity; ++i) {
        float reach = plane.offset;
        for (int axis = 0; axis < 3; ++axis)
            reach +=
                plane.normal[axis] * block.centre[axis][i] + plane.size[axis] * block.half[axis][i];
        least[i] = least[i] < reach ? least[i] : reach;
    }
}

/// Lowest and highest coordinate of the block's boxes along one axis.
LIXEL_MULTIVERSION void findEnds(const BoxBlock& block, int axis, float& lowest, float& highest) {
    const float* const centre = block.centre[axis];
    const float* const half = block.half[axis];
    float lower = std::numeric_limits<float>::infinity();
    float upper = -lower;
    for (std::size_t i = 0; i < block.count; ++i) {
        const float low = centre[i] - half[i];
        const float high = centre[i] + half[i];
        lower = low < lower ? low : lower;
        upper = high > upper ? high : upper;
    }
    lowest = lower;
    highest = upper;
}

} // namespace

FlatBox FlatBox::of(const Ogre::AxisAlignedBox& bounds) {
    const Ogre::Vector3 centre = bounds.getCenter();
    const Ogre::Vector3 half = bounds.getHalfSize();
    return {{centre.x, centre.y, centre.z}, {half.x, half.y, half.z}};
}

bool FlatBox::hasBounds() const {
    float sum = 0.0F;
    for (int axis = 0; axis < 3; ++axis)
        sum += std::abs(centre[axis]) + half[axis];
    return std::isfinite(sum);
}

std::uint64_t FlatBox::key() const {
    return spatialKey(centre, half);
}

ScanPlanes::ScanPlanes(const NodeCuller& volume) : count(volume.size()) {
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            list[i].normal[axis] = static_cast<float>(volume[i].normal[axis]);
            list[i].size[axis] = std::abs(list[i].normal[axis]);
        }
        list[i].offset = static_cast<float>(volume[i].offset);
    }
}

BoxBlock::BoxBlock() {
    // Lanes without a box are compared too.
    std::fill_n(&centre[0][0], 3 * Capacity, 0.0F);
    std::fill_n(&half[0][0], 3 * Capacity, 0.0F);
    findBounds();
}

FlatBox BoxBlock::box(std::size_t index) const {
    FlatBox result;
    for (int axis = 0; axis < 3; ++axis) {
        result.centre[axis] = centre[axis][index];
        result.half[axis] = half[axis][index];
    }
    return result;
}

void BoxBlock::write(std::size_t index, const FlatBox& box) {
    for (int axis = 0; axis < 3; ++axis) {
        centre[axis][index] = box.centre[axis];
        half[axis][index] = box.half[axis];
        lower[axis] = std::min(lower[axis], box.centre[axis] - box.half[axis]);
        upper[axis] = std::max(upper[axis], box.centre[axis] + box.half[axis]);
    }
}

void BoxBlock::append(std::uint32_t slot, const FlatBox& box) {
    slots[count] = slot;
    write(count++, box);
}

void BoxBlock::findBounds() {
    for (int axis = 0; axis < 3; ++axis)
        findEnds(*this, axis, lower[axis], upper[axis]);
}

BoxBlock::Cut BoxBlock::cutBy(const ScanPlanes& planes) const {
    Cut cut;
    if (count == 0) cut.side = Side::Outside;
    for (std::size_t i = 0; i < planes.count && cut.side != Side::Outside; ++i) {
        const ScanPlanes::Plane& plane = planes.list[i];
        float middle = plane.offset;
        float reach = 0.0F;
        float terms = std::abs(plane.offset);
        for (int axis = 0; axis < 3; ++axis) {
            middle += plane.normal[axis] * ((lower[axis] + upper[axis]) / 2.0F);
            reach += plane.size[axis] * ((upper[axis] - lower[axis]) / 2.0F);
            terms += std::max(std::abs(lower[axis]), std::abs(upper[axis]));
        }
        const float doubt = Rounding * terms;
        if (middle + reach < -doubt) {
            cut.side = Side::Outside;
        } else if (!(middle - reach > doubt)) {
            cut.side = Side::Cut;
            cut.planes[cut.count++] = i;
            cut.doubt = std::max(cut.doubt, doubt);
        }
    }
    return cut;
}

void BoxBlock::reachInto(const ScanPlanes& planes, const Cut& cut, Reach& least) const {
    std::fill_n(least, Capacity, std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < cut.count; ++i)
        reachIntoPlane(*this, planes.list[cut.planes[i]], least);
}

} // namespace Lixel
