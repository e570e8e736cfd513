#pragma once

#include "fit/Types.h"

#include <span>

namespace Lixel {

/** The axis of the smallest circular cone, with its apex at the origin, around unit directions.

    The directions are reordered. Found incrementally as smallest balls are (Welzl 1991, Gärtner
    1999, whom Kozlov names): a direction outside of the cone so far lies on the rim of the next
   one, and at most three lie on the rim. In a random order this takes linear time on average.

    Directions must have an open half space in common; then the cone's half angle is below 90°.

    @return a unit vector; the one direction, where they are all alike; zero where there is none
*/
Vec3 smallestConeAxis(std::span<Vec3> directions);

} // namespace Lixel
