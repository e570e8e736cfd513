#pragma once

#include "fit/geometry/Types.h"

#include <array>
#include <cstdint>
#include <span>

namespace Lixel {

/** Whether triangles are the closed surface of a convex body, each once and with its front,
    counter-clockwise, outward.

    They are if no vertex is before any triangle's plane, and if beside each edge of one triangle
    there is the same edge of one other, the other way. Vertices at one place are one, and triangles
    between fewer than three places are none. A surface that is split otherwise along an edge than
    beside it is not recognised as closed, and a flat one is no body.

    Takes the product of the numbers of positions and of triangles, or the square of the former where
    that is more.
    @param triangles as indices into the positions; false where one is beyond them
*/
bool isConvexSurface(std::span<const Vec3> positions,
                     std::span<const std::array<std::uint32_t, 3>> triangles);

} // namespace Lixel
