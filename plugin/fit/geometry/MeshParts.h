#pragma once

#include "fit/geometry/Types.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace Lixel {

/** Divides the triangles of a mesh into parts by where they are, and keeps the bounds of each.

    Triangles come one at a time, and are not kept: each goes to the cell of a grid that its middle
    is in. Where there are more cells than parts are wanted, cells become twice as wide. So there
    are at most as many parts as wanted, and of a surface a quarter of that or more, however many
    triangles there are.
*/
class MeshPartsBuilder {
public:
    /// @param most parts, at least 8
    explicit MeshPartsBuilder(std::size_t most) : mMost(most) {}

    /// Starts anew. @param bounds of all triangles, which the grid divides
    void reset(const Eigen::AlignedBox3d& bounds);
    /// What is not finite is left out.
    void add(const Vec3& a, const Vec3& b, const Vec3& c);

    /// Bounds of the parts so far, in the mesh's space, by rows of cells. They overlap: a triangle
    /// is in one part as a whole.
    std::vector<Eigen::AlignedBox3f> parts() const;

private:
    using Cell = std::uint64_t;
    /// Cells to a side, as a power of two, at first.
    static constexpr int FirstLevel = 12;
    /// A cell's three coordinates are beside each other in one number.
    static constexpr int CoordinateBits = 20;

    void coarsen();

    std::size_t mMost;
    Vec3 mLeast = Vec3::Zero();
    /// Cells per unit.
    double mScale = 0.0;
    std::unordered_map<Cell, Eigen::AlignedBox3f> mParts;
    /// What the last triangle was added to; null where that is no more.
    Eigen::AlignedBox3f* mLast = nullptr;
    Cell mLastCell = 0;
};

} // namespace Lixel
