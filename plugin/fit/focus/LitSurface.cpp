#include "fit/focus/LitSurface.h"

#include <algorithm>
#include <cmath>

namespace Lixel {
namespace {

/// Sine of the angle by which a side has turned away from the light when nothing is left of it: 6
/// degrees. Turned by 1e-4 rad, it gains or loses a thousandth of itself.
constexpr double GoneSine = 0.1;

/// Adds what may face the light of the two sides across an axis.
/// @param light in the body's space, homogeneous
/// @param top outward normal of the side that is left out; zero for none
void addSides(const PlacedBox& around, const Vec4& light, Eigen::Index axis, const Vec3& top,
              BoxSet& boxes) {
    const Vec3& centre = around.box.centre;
    const Vec3& half = around.box.halfExtents;
    const Vec3 towards = light.head<3>() - light.w() * centre;
    for (const double side : {-1.0, 1.0}) {
        if (side * top[axis] > 0.0) continue;
        const double height = side * towards[axis] - light.w() * half[axis];
        const double left = std::clamp(1.0 + height / (GoneSine * towards.norm()), 0.0, 1.0);
        if (left == 0.0) continue;
        Vec3 middle = centre;
        middle[axis] += side * half[axis];
        Vec3 reach = half;
        reach[axis] = 0.0;
        // Negated, so that a NaN keeps all of it.
        if (!(left < 1.0)) {
            boxes.add(boundsOf({{middle, reach}, around.wsFromBody}));
            continue;
        }
        // A strip along each edge that it shares with a side that faces the light.
        for (const Eigen::Index across : {(axis + 1) % 3, (axis + 2) % 3}) {
            Vec3 stripMiddle = middle;
            Vec3 stripReach = reach;
            stripReach[across] *= left;
            stripMiddle[across] +=
                std::copysign(half[across] - stripReach[across], towards[across]);
            boxes.add(boundsOf({{stripMiddle, stripReach}, around.wsFromBody}));
        }
    }
}

} // namespace

bool findLitSurface(const SelfShadowFree& body, const LightImage& image, BoxSet& boxes) {
    boxes.clear();
    const PlacedBox& around = body.around;
    const bool isRelief = body.relief != nullptr && !body.relief->cells.empty();
    if (!(isRelief || body.isBox) || !(around.box.halfExtents.minCoeff() > 0.0)) return false;
    if (!around.wsFromBody.matrix().allFinite()) return false;
    const Vec4 light = around.wsFromBody.inverse(Eigen::Affine) * image.wsLight();
    if (!light.allFinite()) return false;
    if (isRelief) {
        for (const ReliefCell& cell : body.relief->cells)
            boxes.add(boundsOf(cell.bounds, around.wsFromBody));
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        addSides(around, light, axis, isRelief ? body.relief->axis : Vec3(Vec3::Zero()), boxes);
    return boxes.invalid() == 0 && boxes.unbounded() == 0;
}

} // namespace Lixel
