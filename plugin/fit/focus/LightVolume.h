#pragma once

#include "fit/focus/LightImage.h"
#include "fit/geometry/ConvexVolume.h"

namespace Lixel {

/// The space a local light shines into, in world axes: in front of its near distance, within its
/// range, inside a pyramid around its cone. Everything for a directional light.
ConvexVolume lightVolume(const ShadowLight& light, const LightImage& image);

/// Adds a box around what a local light reaches: nothing where it reaches everything.
void addRange(const ShadowLight& light, ConvexVolume& volume);

/// An affine function of world points, and its range over a box.
struct Gauge {
    Vec3 normal;
    Vec3 absolute;
    double offset;

    Gauge(const Vec3& n, double d) : normal(n), absolute(n.cwiseAbs()), offset(d) {}
    double at(const Vec3& ws) const { return normal.dot(ws) + offset; }
    Vec2 over(const Aabb& box) const {
        const double middle = at(box.centre);
        const double reach = absolute.dot(box.halfExtents);
        return {middle - reach, middle + reach};
    }
    /// The half spaces of values from `least` on, and up to `greatest`.
    HalfSpace from(double least) const { return {normal, offset - least}; }
    HalfSpace to(double greatest) const { return {-normal, greatest - offset}; }
};

/// Distance from the light along its axis.
inline Gauge lsDepthOf(const LightImage& image) {
    return {-image.lsFromWs().row(2).transpose(), image.lsFromWs().row(2).dot(image.wsEye())};
}

} // namespace Lixel
