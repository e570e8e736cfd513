#include "fit/focus/LightVolume.h"

#include <cmath>
#include <numbers>

namespace Lixel {
namespace {

/// Number of planes around a spot's cone. Eight overestimate its radius by 1/cos(π/8) = 8 %.
constexpr int ConeSides = 8;

} // namespace

ConvexVolume lightVolume(const ShadowLight& light, const LightImage& image) {
    ConvexVolume volume;
    if (image.directional()) return volume;
    const Vec3 axis = -image.lsFromWs().row(2).transpose();
    const Vec3& eye = image.wsEye();
    const auto add = [&](const Vec3& normal, double distance) {
        volume.add(normal, -normal.dot(eye) - distance);
    };
    if (std::isfinite(light.range)) add(-axis, -light.range);
    for (int i = 0; i < ConeSides; ++i) {
        // In turns of 3/8, so that the first sides are apart: most bodies are beyond one of them.
        const double turn = 2.0 * std::numbers::pi * (3 * i) / ConeSides;
        const Vec3 side = image.lsFromWs().transpose() * Vec3(std::cos(turn), std::sin(turn), 0.0);
        // The plane through the apex that touches the cone along `side`.
        add(std::sin(light.outerHalfAngle) * axis - std::cos(light.outerHalfAngle) * side, 0.0);
    }
    add(axis, light.nearDistance);
    return volume;
}

void addRange(const ShadowLight& light, ConvexVolume& volume) {
    if (!std::isfinite(light.range)) return;
    for (const int axis : {0, 1, 2})
        for (const double sign : {1.0, -1.0})
            volume.add(-sign * Vec3::Unit(axis), sign * light.wsPosition[axis] + light.range);
}

} // namespace Lixel
