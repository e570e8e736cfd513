#pragma once

#include "fit/problem/ShadowFit.h"
#include "fit/problem/ShadowPart.h"
#include "scene/Fingerprint.h"

namespace Lixel {

/// A map as receivers read it.
struct ShownMap {
    ShadowFit fit;
    /// What it serves, relative to its origin.
    ShadowPart part;
    Vec3 wsOrigin = Vec3::Zero();
};

/// What was drawn into a texture, where a budget may have it kept.
struct DrawnMap {
    ShownMap shown;
    Fingerprint matrices;
    /// Of the light.
    Fingerprint light;
    /// The number of the frame.
    unsigned long frame = 0;
};

/** How wrong a drawn map is now: 1 where its light or casters are others, or it does not show all
    that is seen; less where its texels are merely too coarse.
    @param wanted what would be drawn now
*/
double wrongnessOf(const DrawnMap& drawn, const ShownMap& wanted, const Fingerprint& light,
                   bool castersChanged);

} // namespace Lixel
