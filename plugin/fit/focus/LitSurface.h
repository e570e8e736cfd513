#pragma once

#include "fit/focus/LightImage.h"
#include "fit/geometry/BodyHull.h"
#include "fit/geometry/BoxSet.h"

#include <array>

namespace Lixel {

/** Those parts of a body's surface that may face the light, as boxes in the problem's space.

    What faces away from the light (n . l <= 0) is dark anyway: it needs no shadow, as long as the
    body says that it is shaded so (BodyShapes::isSelfShadowFree). On a block of ground, the
    underside and the walls on the far sides face away. A map for the whole block would also hold
    the light rays through the air over its valleys and through the soil below.
*/
struct LitSurface {
    /// Around all that may face the light.
    BoxSet boxes;

    /// A side that has just turned away. It is better left out little by little.
    struct Leaving {
        Aabb side;
        /// How much of it is left, between 0 and 1.
        double left = 0.0;
    };
    std::array<Leaving, 6> leaving;
    std::size_t leavingCount = 0;

    /** Finds that of a box or a relief with cells.
        @return false of other bodies: no more is known than what they say of their hulls */
    bool find(const SelfShadowFree& body, const LightImage& image);
};

} // namespace Lixel
