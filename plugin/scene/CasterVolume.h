#pragma once

#include "fit/problem/ShadowFit.h"
#include "scene/NodeCuller.h"

#include <OgreFrustum.h>

namespace Lixel {

/** The space from which a caster can shadow the focus region: what culls the caster pass.

    All light rays of the focus region, from the light (or from infinity) to the farthest receiver.
    It has no near end: a caster any distance behind the viewer counts. As a culling frustum of the
    shadow camera it keeps OGRE's own frustum out of it, whose planes are wrong or unbounded for a
    warped projection.

    OGRE's default scene manager asks isVisible(); its octree takes the six planes, so these bound
    the volume too: the region's bounding rectangle, the far end, and one that cuts nothing.
*/
class LIXEL_API CasterVolume : public Ogre::Frustum {
public:
    CasterVolume();

    /// Follows the fit; without a map nothing is visible. @param wsOrigin the fit's origin.
    void set(const ShadowFit& fit, const Vec3& wsOrigin);

    bool isVisible(const Ogre::AxisAlignedBox& bound,
                   Ogre::FrustumPlane* culledBy = nullptr) const override;
    bool isVisible(const Ogre::Sphere& bound,
                   Ogre::FrustumPlane* culledBy = nullptr) const override;
    bool isVisible(const Ogre::Vector3& vertex,
                   Ogre::FrustumPlane* culledBy = nullptr) const override;
    const Ogre::Plane* getFrustumPlanes() const override { return mSixPlanes; }
    const Ogre::Plane& getFrustumPlane(unsigned short plane) const override {
        return mSixPlanes[plane];
    }

    /// Its half spaces, for a scan; isVisible() decides where a box touches the border.
    NodeCuller volume() const;

    /// Whether a sphere about `ws` (world) of `radius` or a box of those half extents touches it.
    bool touches(const Vec3& ws, const Vec3& halfExtents, double radius) const;

private:
    struct HalfSpace {
        Vec3 normal;
        double offset;
    };
    HalfSpace edgeThrough(const ShadowFit& fit, const Vec2& origin, const Vec2& normal) const;

    Vec3 mWsOrigin = Vec3::Zero();
    std::array<HalfSpace, FocusPolygon::Capacity + 1> mHalfSpaces;
    std::size_t mCount = 0;
    bool mEmpty = true;
    Ogre::Plane mSixPlanes[6];
};

} // namespace Lixel
