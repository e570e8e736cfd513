#include "fit/focus/LitSurface.h"

#include <algorithm>

namespace Lixel {
namespace {

/// Sine of the angle by which a side has turned away from the light when nothing is left of it: 6
/// degrees. Turned by 1e-4 rad, it loses a thousandth of itself.
constexpr double GoneSine = 0.1;

/// How much is left of a side of a body's box.
/// @param outward its normal, along an axis
/// @param light in the body's space, homogeneous
double leftOf(const Aabb& box, const Vec3& outward, const Vec4& light) {
    const Vec3 towards = light.head<3>() - light.w() * box.centre;
    const double height =
        outward.dot(towards) - light.w() * outward.cwiseAbs().dot(box.halfExtents);
    return 1.0 + std::min(height / (GoneSine * towards.norm()), 0.0);
}

} // namespace

bool LitSurface::find(const SelfShadowFree& body, const LightImage& image) {
    boxes.clear();
    leavingCount = 0;
    const auto& [box, wsFromBody] = body.around;
    const bool isRelief = body.relief != nullptr && !body.relief->cells.empty();
    if (!(isRelief || body.isBox) || !(box.halfExtents.minCoeff() > 0.0)) return false;
    if (!wsFromBody.matrix().allFinite()) return false;
    const Vec4 light = wsFromBody.inverse(Eigen::Affine) * image.wsLight();
    if (!light.allFinite()) return false;
    if (isRelief)
        for (const ReliefCell& cell : body.relief->cells)
            boxes.add(boundsOf(cell.bounds, wsFromBody));
    for (int i = 0; i < 6; ++i) {
        const Vec3 outward = (i % 2 != 0 ? 1.0 : -1.0) * Vec3::Unit(i / 2);
        // The cells are its top.
        if (isRelief && outward.dot(body.relief->axis) > 0.0) continue;
        const double left = leftOf(box, outward, light);
        if (left <= 0.0) continue;
        Aabb side = box;
        side.centre += outward.cwiseProduct(box.halfExtents);
        side.halfExtents[i / 2] = 0.0;
        const Aabb placed = boundsOf({side, wsFromBody});
        // A NaN keeps all of it.
        if (left < 1.0)
            leaving[leavingCount++] = {placed, left};
        else
            boxes.add(placed);
    }
    return boxes.invalid() == 0 && boxes.unbounded() == 0;
}

} // namespace Lixel
