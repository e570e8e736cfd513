#pragma once

#include "fit/problem/SeenPicture.h"

#include <array>
#include <span>

namespace Lixel {

/** A few pixels' depths, out of a depth buffer, in a grid over the viewer's picture; and those of
    their neighbours. */
struct DepthGrid {
    enum Side : std::size_t { Here, Before, Behind, Under, Over, Sides };

    std::size_t columns = 0;
    std::size_t rows = 0;
    /// Depths from 0 to 1, by rows: of the grid's pixels, and of those beside them by ndcBeside, to
    /// the side of lesser and of greater x and y.
    std::array<std::span<const float>, Sides> depths;
    /// Where the grid's first pixel's centre is in the picture, in device coordinates, and from
    /// there to the next column's and the next row's.
    Vec2 ndcFirst = Vec2::Zero();
    Vec2 ndcStep = Vec2::Zero();
    Vec2 ndcBeside = Vec2::Zero();
    /// Near is 1 and far is 0.
    bool isReversed = false;
    /// How many bits hold a depth's fraction: as a whole number of 2^-bits, or as a float's.
    int bits = 24;
    bool isFloat = false;

    /// By how much a depth may be wrong that a renderer has computed and stored.
    double resolution(double depth) const;
    /// A depth in device coordinates, -1 near and 1 far, and that of nothing.
    double ndcZ(double depth) const { return isReversed ? 1.0 - 2.0 * depth : 2.0 * depth - 1.0; }
    double nothing() const { return isReversed ? 0.0 : 1.0; }
};

/** Finds the surfaces that a depth buffer shows.

    In device coordinates a plane's depth is affine, so differences of depths are its slope, and the
    plane in the world is that row times the view's matrix. The slope along a row or column is the
    mean of both sides' where these agree; where they do not, as at an edge, it is that of the side
    where depth changes less. Left out are pixels whose normal is not certain: where the depths'
    resolution may turn it by more than about 15 degrees, or where it is only known from one side
    and looks away from the viewer by more than 84 degrees, as what is thinner than the distance of
    neighbours does.

    @param clipFromWorld of the picture, OpenGL's, with an inverse
    @param[out] seen cleared first; relative to the origin of clipFromWorld
*/
void surfacesOf(const DepthGrid& grid, const Mat4& clipFromWorld, SeenSurfaces& seen) noexcept;

} // namespace Lixel
