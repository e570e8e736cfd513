#pragma once

#include "fit/geometry/BoxSet.h"
#include "fit/geometry/ConvexVolume.h"

/** Questions to many boxes at once, answered in vector registers.

    Most bodies change nothing about a map: they are out of view, or lie within what larger ones
    cover. To find that out must cost a few nanoseconds each, or a scene of ten thousand is slow.
*/
namespace Lixel {

/// Relative rounding within which two bodies count as touching.
inline constexpr double TouchingSlack = 1e-12;

/// Copies the boxes that may reach the inner side of every plane, and keeps their order. A box that
/// touches a plane from outside, within TouchingSlack of the set's extent, counts as reaching it.
/// @param scratch holds what the first planes leave
/// @param[out] kept is emptied first
void keepReaching(const BoxSet& boxes, std::span<const HalfSpace> planes, BoxSet& scratch,
                  BoxSet& kept);

/// The lanes of a block, as bits, whose boxes lie wholly on the inner side of each plane.
unsigned lanesInside(const BoxSet::Block& block, std::span<const HalfSpace> planes);

/** For each direction, a box whose middle lies far along it: the farthest of all, or of many
    boxes the farthest of as many as a few blocks hold, spread over all.
    @param[out] farthest an index for each direction; 0 of an empty set */
void farBoxes(const BoxSet& boxes, std::span<const Vec3> directions,
              std::span<std::size_t> farthest);

/// The box with the greatest sum of half extents; 0 of an empty set.
std::size_t largestBox(const BoxSet& boxes);

/// The boxes with the greatest sums of half extents, the largest first; of equal ones those that
/// come first.
/// @param[out] largest indices of as many as there is room for
/// @return how many there are
std::size_t largestBoxes(const BoxSet& boxes, std::span<std::size_t> largest);

} // namespace Lixel
