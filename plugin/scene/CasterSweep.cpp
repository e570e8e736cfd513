#include "scene/CasterSweep.h"

#include "fit/focus/LightVolume.h"
#include "fit/focus/ViewVolume.h"
#include "fit/parts/LightPartition.h"

#include <cmath>
#include <limits>

namespace Lixel {
namespace {

/// Widening of the receivers' bounds, relative to how far they are from the viewer: it gives flat
/// ones a volume, and keeps what merely touches the view.
constexpr double BoundsSlack = 0x1p-30;

Aabb widened(const Aabb& receivers) {
    Aabb bounds = receivers;
    bounds.halfExtents.array() +=
        BoundsSlack * (bounds.centre.cwiseAbs() + bounds.halfExtents).maxCoeff();
    return bounds;
}

} // namespace

bool CasterSweep::isUsable(const ShadowLight& light) {
    if (!light.wsDirection.allFinite() || light.wsDirection.isZero(0.0)) return false;
    if (light.kind == LightKind::Directional) return true;
    return light.wsPosition.allFinite() && light.nearDistance > 0.0 &&
           std::isfinite(light.nearDistance) && light.range > light.nearDistance &&
           (light.kind == LightKind::Point || light.outerHalfAngle > 0.0);
}

bool CasterSweep::setBox(const ConvexVolume& seen, const Aabb& bounds, const ShadowLight& light,
                         const Vec3& wsOrigin) {
    mVolume = NodeCuller();
    ConvexVolume lit = seen;
    addRange(light, lit);
    mWsPoints.clear();
    clipBox(bounds, lit, mClip, mWsPoints);
    if (mWsPoints.empty()) return false;
    mWsPoints.push_back(light.wsPosition);
    for (const int axis : {0, 1, 2})
        for (const double sign : {1.0, -1.0}) {
            double farthest = -std::numeric_limits<double>::infinity();
            for (const Vec3& ws : mWsPoints)
                farthest = std::max(farthest, sign * ws[axis]);
            mVolume.add(-sign * Vec3::Unit(axis), farthest, wsOrigin);
        }
    return true;
}

bool CasterSweep::set(const ShadowViewer& viewer, const ShadowLight& light, const Aabb& receivers,
                      const Vec3& wsOrigin) {
    ConvexVolume lit = viewVolume(viewer);
    if (needsParts(light)) return setBox(lit, widened(receivers), light, wsOrigin);
    const LightImage image(light);
    const bool directional = image.directional();
    const ConvexVolume shone = lightVolume(light, image);
    lit.add(shone.planes());
    mWsPoints.clear();
    clipBox(widened(receivers), lit, mClip, mWsPoints);
    mPoints.clear();
    double lsFar = -std::numeric_limits<double>::infinity();
    for (const Vec3& ws : mWsPoints) {
        const Vec3 ls = image.lsFromPoint(ws);
        // A clipped vertex lies on the near plane, up to rounding; nothing is divided by less.
        if (!directional && -ls.z() < 0.5 * light.nearDistance) continue;
        lsFar = std::max(lsFar, -ls.z());
        mPoints.push_back(image.project(ls));
    }
    if (mPoints.empty()) return false;
    convexHull(mPoints, mHull);

    mVolume = NodeCuller();
    const auto add = [&](const Vec3& ls, double offset) {
        const Vec3 ws = image.lsFromWs().transpose() * ls;
        mVolume.add(ws, offset - ws.dot(image.wsEye()), wsOrigin);
    };
    add(Vec3::UnitZ(), lsFar);
    if (!directional) add(-Vec3::UnitZ(), -0.5 * light.nearDistance);
    for (std::size_t i = 0; i < mHull.size() && mHull.size() > 2; ++i) {
        const Vec2& a = mHull[i];
        const Vec2 edge = mHull[(i + 1) % mHull.size()] - a;
        const double length = edge.norm();
        if (!(length > 0.0)) continue;
        // n . (q - a) >= 0 for q = (x, y), or for q = (x, y) / -z with -z multiplied out.
        const Vec2 normal = Vec2(-edge.y(), edge.x()) / length;
        const double at = normal.dot(a);
        if (directional) {
            add(Vec3(normal.x(), normal.y(), 0.0), -at);
        } else {
            const Vec3 ls(normal.x(), normal.y(), at);
            add(ls.normalized(), 0.0);
        }
    }
    return true;
}

} // namespace Lixel
