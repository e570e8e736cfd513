#pragma once

#include "fit/geometry/ConvexVolume.h"

#include <OgreAxisAlignedBox.h>

namespace Lixel {

/** A convex volume in the world that sorts OGRE's boxes out.

    It is asked about every node of a scene, so a box is compared with a plane by one corner alone:
    the one that reaches farthest along the plane's normal. Most boxes fail at one and the same
    plane, which is why the walker passes a guess of it along.
*/
class NodeCuller {
public:
    static constexpr std::size_t Capacity = ConvexVolume::Capacity;
    /// normal . x + offset >= 0 in the world.
    struct CullPlane {
        double normal[3];
        double offset;
        /// Which end of a box is the farther one along the normal: 0 its minimum, 1 its maximum.
        std::size_t end[3];
    };

    /// Everything, to begin with.
    NodeCuller() = default;
    /// The planes are relative to `wsOrigin`, and widened for rounding at its scale.
    NodeCuller(const ConvexVolume& volume, const Vec3& wsOrigin);

    /// Adds normal . x + offset >= 0, x relative to `wsOrigin`. Beyond the capacity a plane is left
    /// out, and the volume is larger than it need be.
    void add(const Vec3& normal, double offset, const Vec3& wsOrigin);

    /// Whether the box is outside for certain. A box with a NaN never is: somebody has to notice.
    /// @param guess the plane to try first, and then the one that the box is outside of
    bool excludes(const Ogre::AxisAlignedBox& box, std::size_t& guess) const {
        if (!box.isFinite()) return box.isNull();
        const float* const ends[2] = {box.getMinimum().ptr(), box.getMaximum().ptr()};
        if (guess < mCount && isBeyond(mPlanes[guess], ends)) return true;
        for (std::size_t i = 0; i < mCount; ++i) {
            if (isBeyond(mPlanes[i], ends)) {
                guess = i;
                return true;
            }
        }
        return false;
    }

    std::size_t size() const { return mCount; }
    const CullPlane& operator[](std::size_t plane) const { return mPlanes[plane]; }

private:
    static bool isBeyond(const CullPlane& plane, const float* const (&ends)[2]) {
        const auto along = [&](std::size_t axis) {
            return plane.normal[axis] * static_cast<double>(ends[plane.end[axis]][axis]);
        };
        return along(0) + along(1) + along(2) + plane.offset < 0.0;
    }

    std::array<CullPlane, Capacity> mPlanes;
    std::size_t mCount = 0;
};

} // namespace Lixel
