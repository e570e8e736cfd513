#pragma once

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

/// Symbols that libLixel exports.
#define LIXEL_API __attribute__((visibility("default")))

namespace Lixel {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;

/// An axis-aligned box as its centre and half extents; all half extents are >= 0.
struct Box {
    Vec3 centre = Vec3::Zero();
    Vec3 halfExtents = Vec3::Zero();
};

/** The boxes of one frame's casters or receivers, in world axes.

    Bad input is counted instead of stored, so that whoever reads the set can say why there is
    no map: a box with a NaN is `invalid`, one with an infinite extent, or one beyond
    1e18, is `unbounded`.
*/
class BoxSet {
public:
    void clear() {
        mBoxes.clear();
        mUnbounded = 0;
        mInvalid = 0;
    }
    void add(const Box& box) {
        if (box.centre.hasNaN() || box.halfExtents.hasNaN() || box.halfExtents.minCoeff() < 0.0)
            ++mInvalid;
        else if (!(box.centre.cwiseAbs() + box.halfExtents).allFinite() ||
                 (box.centre.cwiseAbs() + box.halfExtents).maxCoeff() > GreatestExtent)
            ++mUnbounded;
        else
            mBoxes.push_back(box);
    }
    /// Counts a body that has no bounds: it may be anywhere.
    void addUnbounded() { ++mUnbounded; }

    const std::vector<Box>& boxes() const { return mBoxes; }
    std::size_t unbounded() const { return mUnbounded; }
    std::size_t invalid() const { return mInvalid; }
    bool empty() const { return mBoxes.empty() && mUnbounded == 0; }

private:
    /// Beyond it a float's square overflows, and matrices with it: such a box has no bounds.
    static constexpr double GreatestExtent = 1e18;

    std::vector<Box> mBoxes;
    std::size_t mUnbounded = 0;
    std::size_t mInvalid = 0;
};

} // namespace Lixel
