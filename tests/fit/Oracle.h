#pragma once

#include "Problems.h"

#include <optional>

/** Shadows by brute force: boxes as solid bodies, rays one by one.

    Nothing here uses the fit's hulls, volumes or light image, so that the two cannot be wrong in
    the same way.
*/
namespace Lixel::Test {

/// A point of a receiver that the viewer sees and a caster shadows.
struct ShadowedPoint {
    Vec3 wsReceiver;
    /// Where the ray from the light to the receiver first meets a caster.
    Vec3 wsOccluder;
};

/// The part of a ray, as parameters of origin + t direction, inside a solid box.
struct Interval {
    double begin;
    double end;
};
std::optional<Interval> rayInBox(const Aabb& box, const Vec3& origin, const Vec3& direction);

/// Whether the viewer's clip volume and shadow distance hold the point; bodies do not hide it.
bool sees(const ShadowViewer& viewer, const Vec3& ws);

/// Whether an unshadowed point is lit: always for a directional light.
bool shinesOn(const ShadowLight& light, const Vec3& ws);

/// Towards the light, unit length.
Vec3 towardsLight(const ShadowLight& light, const Vec3& ws);

/// The occluder nearest to the light on the ray to a point of a receiver, if there is one; a convex
/// body occludes nothing of itself, a relief what is behind its slopes that face away. None for
/// what is dark anyway: sides of boxes that face away from the light.
std::optional<Vec3> occluder(const Scene& scene, std::size_t receiver, const Vec3& ws);

/// Points on the surfaces of receivers that the viewer sees.
std::vector<Vec3> visiblePoints(const Scene& scene, Dice& dice, std::size_t rays);

/// Points seen and shadowed: those of visiblePoints, and where rays through casters end.
std::vector<ShadowedPoint> shadowedPoints(const Scene& scene, Dice& dice, std::size_t rays);

} // namespace Lixel::Test
