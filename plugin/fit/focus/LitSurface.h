#pragma once

#include "fit/focus/LightImage.h"
#include "fit/geometry/BodyHull.h"

namespace Lixel {

/** Boxes around those parts of a body's surface that may face the light, where they are known.

    What faces away from it (n . l <= 0) is dark without a map, whoever casts a shadow there, as
    long as the body says that it is shaded so (BodyShapes::isSelfShadowFree). Of a block of ground
    that is its underside, and the walls on its far sides: a map for the whole block would hold all
    light rays that go through the air over its valleys, or through the soil below.

    A side that turns away from the light does not go at once: what is left of it shrinks towards
    the edges that it shares with sides that face the light.
    @param[out] boxes is emptied first; in the problem's space
    @return false where no more is known than what the body says of its hull
*/
bool findLitSurface(const SelfShadowFree& body, const LightImage& image, BoxSet& boxes);

} // namespace Lixel
