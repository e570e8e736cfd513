#pragma once

#include "fit/ShadowProblem.h"

#include <array>
#include <span>

namespace Lixel {

/// The half space normal . x + offset >= 0.
struct Plane {
    Vec3 normal = Vec3::Zero();
    double offset = 0.0;
    double distance(const Vec3& x) const { return normal.dot(x) + offset; }
};

/// An intersection of at most `Capacity` half spaces with unit normals.
class ConvexVolume {
public:
    static constexpr std::size_t Capacity = 24;
    enum class Side { Outside, Straddles, Inside };

    /// Adds the half space n . x + offset >= 0, normalised. A normal of length zero is no plane
    /// (the far plane of an infinite projection) and is left out.
    void add(const Vec3& normal, double offset);

    std::span<const Plane> planes() const { return {mPlanes.data(), mCount}; }

    /// Where the box lies; Straddles also where it only may cut a plane.
    Side classify(const Box& box) const;

private:
    std::array<Plane, Capacity> mPlanes;
    std::size_t mCount = 0;
};

/** What the viewer sees: the planes of its clip volume and of the shadow distance.

    @param clipFromWorld product of the viewer's matrices; planes by Gribb and Hartmann's rows
    (w ± x, w ± y, w ± z). Holds for off-axis and oblique projections, and without a far plane.
*/
ConvexVolume viewVolume(const ShadowViewer& viewer);

/// Scratch memory for clipping boxes, kept between frames so that nothing is allocated.
struct ClipScratch {
    std::vector<std::vector<Vec3>> faces;
    std::vector<Vec3> cap;
    std::vector<Vec3> face;
    std::vector<std::pair<double, Vec3>> sorted;
};

/** Appends the vertices of box ∩ volume to `points`, some of them repeatedly.

    Each face polygon is clipped by each plane, and the cut is closed by a new face, so that edges
    of the volume inside the box and its corners are found too.
*/
void clipBox(const Box& box, const ConvexVolume& volume, ClipScratch& scratch,
             std::vector<Vec3>& points);

/// The eight corners of a box.
std::array<Vec3, 8> corners(const Box& box);

} // namespace Lixel
