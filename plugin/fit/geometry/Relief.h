#pragma once

#include "fit/geometry/Types.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace Lixel {

/// A piece of a relief: those triangles whose middles lie in a square of a grid, seen from above.
struct ReliefCell {
    /// Directions across the axis, at equal angles.
    static constexpr std::size_t Directions = 8;

    /// Around the triangles.
    Eigen::AlignedBox3f bounds;
    /// How much the steepest triangle rises along each direction, per length across the axis.
    Eigen::Array<float, Directions, 1> rise;
};

/** The surface of a ground: a graph over a rectangle of its body's space, as a sheet, or as a block
    with straight walls and a flat underside.

    A ray from the surface to the light that meets it again comes from above: so what it meets is a
    slope that faces away from the light. (Walls and underside, where there are any, are sides of
    the box around it, and what they face is outside of that box.) Of itself it shadows no more than
    slopes shadow that face away, and nothing where all face the light.
*/
struct Relief {
    /// Unit vector, along one of the space's axes.
    Vec3 axis = Vec3::UnitY();
    /// Sine of the steepest slope.
    double steepness = 0.0;
    /// All triangles are in one of them. None where nothing is known but the steepest slope.
    std::vector<ReliefCell> cells = {};

    /// Whether a direction towards a light, of any length, is higher than all slopes. False of a
    /// NaN.
    bool isBelow(const Vec3& direction) const {
        return direction.dot(axis) > (steepness + Slack) * direction.norm();
    }
    /** Whether all triangles of a cell face a light.
        @param light in the body's space, homogeneous: a direction to it where w is 0, else w is 1
        @return false of a NaN */
    bool isLit(const ReliefCell& cell, const Vec4& light) const;

private:
    /// Sine of the least angle between light and slope: what rounding of positions to float does to
    /// a triangle of 2⁻¹⁴ of the body's size.
    static constexpr double Slack = 1e-3;
};

/** Finds out whether triangles are a relief.

    Triangles come one at a time, and are not kept. They are one if

    - those that do not lie in a side of their box or in its bottom, turned outward, face up, and
      none is steeper than MostSteep;
    - together these are as large as the box, seen from above;
    - beside each edge there is the same edge of another, the other way around. A sheet, which has
      no triangles in sides or bottom, may have a border in the sides.

    So a surface that has no border within its box lies over each point equally often, which is
    once, and walls, which all face outward, end where it does. Sums of random numbers, one for each
    edge and its opposite the other way around, tell of borders: that they are 0 although there is
    one has a chance of 2⁻⁶⁴.
*/
class ReliefBuilder {
public:
    /// Sine of 75°: a steeper ground hardly has a light above it that is higher.
    static constexpr double MostSteep = 0.9659258262890683;
    /// Cells to a side of the grid: as few as are looked at for each map.
    static constexpr std::size_t Side = 8;

    /// Starts anew. @param bounds of all triangles, exactly
    void reset(const Eigen::AlignedBox3d& bounds);
    /// Adds a triangle, counter-clockwise seen from its front.
    void add(const Vec3& a, const Vec3& b, const Vec3& c);
    /// Whether they may be one still: where not, another triangle takes no time.
    bool mayBe() const { return mAnyAlive; }

    /// What they are, all triangles having been added; none where they are no relief.
    std::optional<Relief> relief() const;

private:
    /// What is known of the relief along one direction of an axis.
    struct Candidate {
        bool isAlive = false;
        /// Of the steepest slope.
        double squaredCosine = 1.0;
        /// Of the triangles that face up, seen from above.
        double area = 0.0;
        /// Whether there are triangles in the sides or in the bottom.
        bool hasWalls = false;
        /// Of the edges within, the one way less the other.
        std::uint64_t edgesWithin = 0;
        /// By rows, empty before the first triangle.
        std::vector<ReliefCell> cells = {};
    };
    void addToCell(Candidate& candidate, std::size_t axis, const std::array<Vec3, 3>& corners,
                   const Vec3& upNormal);
    /// Bits of the box's sides that a point lies in: the lower one of each axis, then the upper
    /// one.
    unsigned sidesOf(const Vec3& point) const;

    Eigen::AlignedBox3d mBounds;
    /// Up along each axis, and down.
    std::array<Candidate, 6> mCandidates;
    /// Of all edges.
    std::uint64_t mEdges = 0;
    bool mAnyAlive = false;
};

} // namespace Lixel
