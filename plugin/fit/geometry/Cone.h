#pragma once

#include "fit/geometry/Types.h"

#include <span>

namespace Lixel {

/** The axis of the smallest circular cone, with its apex at the origin, around unit directions.

    The directions are reordered. Found incrementally as smallest balls are (Welzl 1991, Gärtner
    1999, whom Kozlov names): a direction outside of the cone so far lies on the rim of the next
    one, and at most three lie on the rim. In a random order this takes linear time on average.

    @param widest half angle in radians, below 90°: a search that is sure to end beyond it is given
    up, in linear time too
    @return a unit vector; the one direction, where they are all alike; zero where there is none,
    and where they have no cone of that half angle in common
*/
Vec3 smallestConeAxis(std::span<Vec3> directions, double widest = 1.5707);

} // namespace Lixel
