#include "scene/CasterReach.h"

#include "fit/LightVolume.h"

#include <cmath>
#include <limits>

namespace Lixel {
namespace {

/// Widening of the receivers' bounds, relative to how far they are from the viewer: it gives flat
/// ones a volume, and keeps what merely touches the view.
constexpr double BoundsSlack = 0x1p-30;

} // namespace

bool CasterReach::isUsable(const ShadowLight& light) {
    if (!light.wsDirection.allFinite() || light.wsDirection.isZero(0.0)) return false;
    if (light.kind == LightKind::Directional) return true;
    return light.kind == LightKind::Spot && light.wsPosition.allFinite() &&
           light.nearDistance > 0.0 && std::isfinite(light.nearDistance) &&
           light.range > light.nearDistance && light.outerHalfAngle > 0.0;
}

bool CasterReach::set(const ShadowViewer& viewer, const ShadowLight& light, const Box& receivers,
                      const Vec3& wsOrigin) {
    const LightImage image(light);
    const bool directional = image.directional();
    ConvexVolume lit = viewVolume(viewer);
    const ConvexVolume shone = lightVolume(light, image);
    for (const Plane& plane : shone.planes())
        lit.add(plane.normal, plane.offset);
    Box bounds = receivers;
    bounds.halfExtents.array() +=
        BoundsSlack * (bounds.centre.cwiseAbs() + bounds.halfExtents).maxCoeff();

    mWsPoints.clear();
    clipBox(bounds, lit, mClip, mWsPoints);
    mPoints.clear();
    double lsFar = -std::numeric_limits<double>::infinity();
    for (const Vec3& ws : mWsPoints) {
        const Vec3 ls = image.lsFromPoint(ws);
        // A clipped vertex lies on the near plane but for rounding; nothing is divided by less.
        if (!directional && -ls.z() < 0.5 * light.nearDistance) continue;
        lsFar = std::max(lsFar, -ls.z());
        mPoints.push_back(image.project(ls));
    }
    if (mPoints.empty()) return false;
    convexHull(mPoints, mHull);

    mVolume = CullVolume();
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
