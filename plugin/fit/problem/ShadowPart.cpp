#include "fit/problem/ShadowPart.h"

namespace Lixel {

bool needsParts(const ShadowLight& light) {
    return light.kind == LightKind::Point ||
           (light.kind == LightKind::Spot && light.outerHalfAngle > WidestHalfAngle);
}

} // namespace Lixel
