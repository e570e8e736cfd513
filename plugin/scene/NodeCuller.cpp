#include "scene/NodeCuller.h"

namespace Lixel {
namespace {

/// Widening relative to a plane's offset and the origin's distance from the world's: far above the
/// rounding of doubles (2⁻⁵³), far below that of OGRE's boxes (2⁻²⁴).
constexpr double PlaneSlack = 0x1p-40;

} // namespace

NodeCuller::NodeCuller(const ConvexVolume& volume, const Vec3& wsOrigin) {
    for (const HalfSpace& plane : volume.planes())
        add(plane.normal, plane.offset, wsOrigin);
}

void NodeCuller::add(const Vec3& normal, double offset, const Vec3& wsOrigin) {
    if (mCount == mPlanes.size()) return;
    CullPlane& plane = mPlanes[mCount++];
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        plane.normal[axis] = normal[axis];
        plane.end[axis] = normal[axis] > 0.0 ? 1 : 0;
    }
    const double slack =
        PlaneSlack * (std::abs(offset) + normal.cwiseAbs().dot(wsOrigin.cwiseAbs()));
    plane.offset = offset - normal.dot(wsOrigin) + slack;
}

} // namespace Lixel
