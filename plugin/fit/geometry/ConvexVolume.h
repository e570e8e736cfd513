#pragma once

#include "fit/geometry/HalfSpace.h"

#include <array>
#include <cstdint>
#include <span>

namespace Lixel {

/// An intersection of at most `Capacity` half spaces with unit normals.
class ConvexVolume {
public:
    static constexpr std::size_t Capacity = 24;
    enum class Side { Outside, Straddles, Inside };

    /// Adds the half space n . x + offset >= 0, normalised. A normal of length zero is no plane
    /// (the far plane of an infinite projection) and is left out.
    void add(const Vec3& normal, double offset);
    void add(std::span<const HalfSpace> planes) {
        for (const HalfSpace& plane : planes)
            add(plane.normal, plane.offset);
    }

    std::span<const HalfSpace> planes() const { return {mPlanes.data(), mCount}; }

    /// Where the box lies; Straddles also where it only may cut a plane.
    Side classify(const Aabb& box) const;

private:
    std::array<HalfSpace, Capacity> mPlanes;
    std::size_t mCount = 0;
};

/// Scratch memory for clipping boxes, kept between frames so that nothing is allocated.
struct ClipScratch {
    /// An edge between two vertices, and between two faces.
    struct Edge {
        std::array<std::uint32_t, 2> vertices;
        std::array<std::uint32_t, 2> faces;
    };
    /// Where a plane cuts an edge, once for each of the edge's faces.
    struct Cut {
        std::uint32_t face;
        std::uint32_t vertex;
        /// The cut of the same face before it.
        std::uint32_t previous;
    };
    static constexpr std::uint32_t NoCut = 0xffffffff;
    std::vector<Vec3> vertices;
    std::vector<double> distances;
    std::vector<Edge> edges;
    std::vector<Cut> cuts;
    /// For each face its last cut.
    std::vector<std::uint32_t> lastCut;
    /// Whether a vertex was appended, as numbers: bits are slower.
    std::vector<std::uint8_t> used;
};

/** Appends the vertices of box ∩ volume to `points`.

    The edges of the box are clipped by each plane; the points in which it cuts the edges of one
    face are joined by a new edge, so that edges of the volume inside the box and its corners are
    found too.
*/
void clipBox(const Aabb& box, const ConvexVolume& volume, ClipScratch& scratch,
             std::vector<Vec3>& points);

/** The same of the body whose vertices and edges are in the scratch memory.
    @param faces how many it has; those that its edges are between are less */
void clipEdges(const ConvexVolume& volume, std::uint32_t faces, ClipScratch& scratch,
               std::vector<Vec3>& points);

/// The eight corners of a box.
std::array<Vec3, 8> corners(const Aabb& box);

} // namespace Lixel
