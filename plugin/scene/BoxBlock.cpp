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
    float* into = least;
    for (const BoxBlock::Eight& eight : block.boxes) {
        for (std::size_t lane = 0; lane < BoxBlock::Lanes; ++lane) {
            float reach = plane.offset;
            for (int axis = 0; axis < 3; ++axis)
                reach += plane.normal[axis] * eight.centre[axis][lane] +
                         plane.size[axis] * eight.half[axis][lane];
            into[lane] = into[lane] < reach ? into[lane] : reach;
        }
        into += BoxBlock::Lanes;
    }
}

/// Lowest and highest coordinates of the block's boxes along one axis.
LIXEL_MULTIVERSION void findEnds(const BoxBlock& block, int axis, float& lowest, float& highest) {
    float lower[BoxBlock::Lanes];
    float upper[BoxBlock::Lanes];
    std::fill_n(lower, BoxBlock::Lanes, std::numeric_limits<float>::infinity());
    std::fill_n(upper, BoxBlock::Lanes, -std::numeric_limits<float>::infinity());
    const auto widen = [&](const BoxBlock::Eight& eight, std::size_t lane) {
        const float low = eight.centre[axis][lane] - eight.half[axis][lane];
        const float high = eight.centre[axis][lane] + eight.half[axis][lane];
        lower[lane] = low < lower[lane] ? low : lower[lane];
        upper[lane] = high > upper[lane] ? high : upper[lane];
    };
    const std::size_t whole = block.count / BoxBlock::Lanes;
    for (std::size_t i = 0; i < whole; ++i)
        for (std::size_t lane = 0; lane < BoxBlock::Lanes; ++lane)
            widen(block.boxes[i], lane);
    for (std::size_t lane = 0; lane < block.count % BoxBlock::Lanes; ++lane)
        widen(block.boxes[whole], lane);
    lowest = *std::min_element(lower, lower + BoxBlock::Lanes);
    highest = *std::max_element(upper, upper + BoxBlock::Lanes);
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
    return (before & ~endsReached(index)) != 0;
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
