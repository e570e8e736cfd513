#include "scene/CasterVolume.h"

#include "fit/geometry/Polygon2.h"
#include "scene/OgreMath.h"

#include <OgreAxisAlignedBox.h>
#include <OgreSphere.h>

namespace Lixel {
namespace {

/// Widening of the volume for the rounding of OGRE's float boxes and planes, relative to a
/// coordinate's size: four units in the last place.
constexpr double FloatSlack = 0x1p-21;

} // namespace

CasterVolume::CasterVolume() {
    set(ShadowFit{}, Vec3::Zero());
}

/// The half space of light rays ℓ with normal . (ℓ - origin) >= 0: a plane through the light.
CasterVolume::HalfSpace CasterVolume::edgeThrough(const ShadowFit& fit, const Vec2& origin,
                                                  const Vec2& normal) const {
    // n . (x, y) - n . o >= 0 directional; n . (x, y) + (n . o) z >= 0 for a local light.
    const double at = normal.dot(origin);
    const Vec3 ls(normal.x(), normal.y(), fit.directional ? 0.0 : at);
    const double length = ls.norm();
    const Vec3 ws = fit.lsFromWs.transpose() * ls / length;
    return {ws, -ws.dot(fit.wsEye) - (fit.directional ? at / length : 0.0)};
}

void CasterVolume::set(const ShadowFit& fit, const Vec3& wsOrigin) {
    mWsOrigin = wsOrigin;
    mCount = 0;
    mEmpty = !fit.hasMap();
    std::array<HalfSpace, 6> six;
    // Nothing satisfies this one; everything satisfies its negative.
    six.fill({Vec3::Zero(), mEmpty ? -1.0 : 1.0});
    if (!mEmpty) {
        const std::span<const Vec2> focus = fit.liFocus.span();
        for (std::size_t i = 0; i < focus.size() && focus.size() > 2; ++i) {
            const Vec2 edge = focus[(i + 1) % focus.size()] - focus[i];
            if (edge.squaredNorm() > 0.0)
                mHalfSpaces[mCount++] =
                    edgeThrough(fit, focus[i], Vec2(-edge.y(), edge.x()).normalized());
        }
        // The bounding rectangle; a region without area has nothing else.
        const OrientedRectangle r =
            focus.size() > 1 ? smallestRectangle(focus) : boundsAt(focus, 0.0);
        const Vec2 u(std::cos(r.angle), std::sin(r.angle));
        const Vec2 v(-u.y(), u.x());
        six[Ogre::FRUSTUM_PLANE_LEFT] = edgeThrough(fit, r.min.x() * u, u);
        six[Ogre::FRUSTUM_PLANE_RIGHT] = edgeThrough(fit, r.max.x() * u, -u);
        six[Ogre::FRUSTUM_PLANE_BOTTOM] = edgeThrough(fit, r.min.y() * v, v);
        six[Ogre::FRUSTUM_PLANE_TOP] = edgeThrough(fit, r.max.y() * v, -v);
        if (mCount == 0)
            for (const int side : {Ogre::FRUSTUM_PLANE_LEFT, Ogre::FRUSTUM_PLANE_RIGHT,
                                   Ogre::FRUSTUM_PLANE_BOTTOM, Ogre::FRUSTUM_PLANE_TOP})
                mHalfSpaces[mCount++] = six[static_cast<std::size_t>(side)];
        // -z <= far, in light space.
        const Vec3 towardsLight = fit.lsFromWs.row(2);
        const HalfSpace farEnd{towardsLight, fit.lsFar - towardsLight.dot(fit.wsEye)};
        mHalfSpaces[mCount++] = farEnd;
        six[Ogre::FRUSTUM_PLANE_FAR] = farEnd;
    }
    for (std::size_t i = 0; i < six.size(); ++i) {
        const double offset = six[i].offset - six[i].normal.dot(wsOrigin);
        const double slack = FloatSlack * (wsOrigin.norm() + std::abs(six[i].offset));
        mSixPlanes[i].normal = toOgre(six[i].normal);
        mSixPlanes[i].d = static_cast<Ogre::Real>(offset + (mEmpty ? 0.0 : slack));
    }
}

NodeCuller CasterVolume::volume() const {
    static_assert(FocusPolygon::Capacity + 1 <= NodeCuller::Capacity);
    NodeCuller volume;
    if (mEmpty) volume.add(Vec3::Zero(), -1.0, Vec3::Zero());
    for (std::size_t i = 0; i < mCount; ++i)
        volume.add(mHalfSpaces[i].normal, mHalfSpaces[i].offset, mWsOrigin);
    return volume;
}

bool CasterVolume::touches(const Vec3& ws, const Vec3& halfExtents, double radius) const {
    if (mEmpty) return false;
    const Vec3 relative = ws - mWsOrigin;
    const double slack = FloatSlack * (ws.cwiseAbs() + halfExtents).sum();
    for (std::size_t i = 0; i < mCount; ++i) {
        const HalfSpace& h = mHalfSpaces[i];
        const double reach = h.normal.cwiseAbs().dot(halfExtents) + radius + slack;
        if (h.normal.dot(relative) + h.offset < -reach) return false;
    }
    return true;
}

bool CasterVolume::isVisible(const Ogre::AxisAlignedBox& bound, Ogre::FrustumPlane*) const {
    if (bound.isNull()) return false;
    if (bound.isInfinite()) return !mEmpty;
    const Vec3 lower = toDouble(bound.getMinimum());
    const Vec3 upper = toDouble(bound.getMaximum());
    return touches((lower + upper) / 2.0, (upper - lower) / 2.0, 0.0);
}

bool CasterVolume::isVisible(const Ogre::Sphere& bound, Ogre::FrustumPlane*) const {
    return touches(toDouble(bound.getCenter()), Vec3::Zero(), bound.getRadius());
}

bool CasterVolume::isVisible(const Ogre::Vector3& vertex, Ogre::FrustumPlane*) const {
    return touches(toDouble(vertex), Vec3::Zero(), 0.0);
}

} // namespace Lixel
