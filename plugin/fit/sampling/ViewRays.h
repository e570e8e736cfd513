#pragma once

#include "fit/problem/PictureCells.h"
#include "fit/problem/ShadowProblem.h"

#include <array>
#include <cmath>
#include <vector>

namespace Lixel {

/** View rays, one through each cell of a grid over the picture, and what they meet first.

    If the rays of one round show too little, those of the next go through other points of the same
    cells. There are enough in all for a focus region that fills only a tenth of the picture.

    Numbers of many rays lie beside each other, and bodies are projected by fours, so that both are
    worked on in vector registers.
*/
class ViewRays {
public:
    static constexpr std::size_t Rounds = 2;
    static constexpr std::size_t Columns = PictureCells::Columns;
    static constexpr std::size_t Rows = PictureCells::Rows;
    static constexpr std::size_t Count = PictureCells::Count;

    /// One number of each ray, by rows of cells from the picture's bottom.
    using Column = std::array<double, Count>;
    using Columns3 = std::array<Column, 3>;
    struct Rays {
        /// Where it goes through the picture in each round, in device coordinates.
        std::array<std::array<Column, 2>, Rounds> places;
        std::size_t round = 0;
        const std::array<Column, 2>& ndc() const { return places[round]; }
        Columns3 origin;
        /// Of any length.
        Columns3 direction;
        Columns3 inverse;
        /// The multiple of the direction at which it meets a body first, else infinite.
        Column nearest;
        /// The axis that is normal to the face of the box met; Disc where it is a disc.
        Column axis;
        /// The normal of the disc met.
        Columns3 normal;
    };
    static constexpr double Disc = 3.0;

    /// Where a ray of any round goes through the picture, in device coordinates, even where it is
    /// not sent.
    static Vec2 placeOf(std::size_t ray, std::size_t round);

    /// Sends one ray through each cell, away from its middle, so that rays do not line up with rows
    /// of objects.
    /// @param clipFromWorld with z growing away from the viewer, @see withDepthAhead
    /// @param round less than Rounds
    void cast(const Mat4& clipFromWorld, std::size_t round);

    /** Shortens rays to the boxes that they meet, except those of known surfaces. A box that a ray
        starts in is met where the ray leaves it.
        @param surfaces by ascending receiver, an index of the boxes */
    void meet(const BoxSet& boxes, std::span<const KnownSurface> surfaces);

    /// Shortens rays to the discs whose front they see.
    void meet(std::span<const Surfel> discs);

    /// Where a ray goes through the picture, in device coordinates.
    Vec2 ndc(std::size_t ray) const { return {mRays[0].ndc()[0][ray], mRays[0].ndc()[1][ray]}; }
    bool hit(std::size_t ray) const { return std::isfinite(mRays[0].nearest[ray]); }
    /// The cosine between a unit vector and the normal of what a ray that hit something met first.
    double facing(std::size_t ray, const Vec3& towards) const {
        const Rays& rays = mRays[0];
        if (rays.axis[ray] == Disc)
            return towards.dot(Vec3(rays.normal[0][ray], rays.normal[1][ray], rays.normal[2][ray]));
        const auto axis = static_cast<std::size_t>(rays.axis[ray]);
        const double along = towards[static_cast<Eigen::Index>(axis)];
        return rays.direction[axis][ray] > 0.0 ? -along : along;
    }
    /// What a ray that hit something met first.
    VisiblePoint point(std::size_t ray) const;

private:
    Mat4 mClipFromWorld = Mat4::Identity();
    /// One, once rays were cast: most states of fits need none.
    std::vector<Rays> mRays;
};

} // namespace Lixel
