#include "fit/geometry/MeshParts.h"

#include <algorithm>
#include <cmath>

namespace Lixel {

void MeshPartsBuilder::reset(const Eigen::AlignedBox3d& bounds) {
    mParts.clear();
    mLast = nullptr;
    mLeast = bounds.min();
    const double longest = bounds.isEmpty() ? 0.0 : bounds.sizes().maxCoeff();
    mScale = longest > 0.0 ? std::ldexp(1.0 / longest, FirstLevel) : 0.0;
}

void MeshPartsBuilder::add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 inCells = ((a + b + c) / 3.0 - mLeast) * mScale;
    if (!inCells.allFinite()) return;
    Cell cell = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double most = std::ldexp(1.0, FirstLevel);
        cell = cell << CoordinateBits | static_cast<Cell>(std::clamp(inCells[axis], 0.0, most));
    }
    // Triangles beside each other follow each other.
    if (mLast == nullptr || cell != mLastCell) {
        mLast = &mParts[cell];
        mLastCell = cell;
    }
    for (const Vec3& corner : {a, b, c})
        mLast->extend(corner.cast<float>());
    while (mParts.size() > mMost)
        coarsen();
}

void MeshPartsBuilder::coarsen() {
    std::unordered_map<Cell, Eigen::AlignedBox3f> merged;
    constexpr Cell One = (Cell{1} << CoordinateBits) - 2;
    constexpr Cell Mask = One << 2 * CoordinateBits | One << CoordinateBits | One;
    for (const auto& [cell, part] : mParts)
        merged[(cell & Mask) >> 1].extend(part);
    mParts = std::move(merged);
    mScale /= 2.0;
    mLast = nullptr;
}

std::vector<Eigen::AlignedBox3f> MeshPartsBuilder::parts() const {
    std::vector<std::pair<Cell, Eigen::AlignedBox3f>> sorted(mParts.begin(), mParts.end());
    std::ranges::sort(sorted, {}, [](const auto& part) { return part.first; });
    std::vector<Eigen::AlignedBox3f> result;
    result.reserve(sorted.size());
    for (const auto& [cell, part] : sorted)
        result.push_back(part);
    return result;
}

} // namespace Lixel
