#pragma once

#include "fit/geometry/ConvexVolume.h"
#include "fit/geometry/Relief.h"

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <span>

namespace Lixel {

/** A convex body around a mesh, in the mesh's own space: made once, and moved with it.

    The box of a body that is turned, or that runs aslant, holds much that the body does not; so
    does a map that is fitted to it. This is the polytope of 26 faces, whose normals have the
    components -1, 0 and 1: 6 as a box has, one for each of its edges, and one for each of its
    corners, where they cut something off (Klosowski et al. 1998, "Efficient Collision Detection
    Using Bounding Volume Hierarchies of k-DOPs", §3).
*/
struct BodyHull {
    std::vector<Vec3> vertices;
    /// Between two vertices and two of the faces, which are numbered below `faces`.
    std::vector<ClipScratch::Edge> edges;
    std::uint32_t faces = 0;
    /// In the cube of the mesh's unit.
    double volume = 0.0;
    /// Whether all points lie in one plane, across one of the faces' normals, as exactly as floats
    /// can tell.
    bool flat = false;
    /// Whether there is a point in each corner of their box, as exactly as floats can tell. A
    /// convex body of these points is the box itself.
    bool hasCorners = false;

    bool empty() const { return vertices.empty(); }
};

/// The hull of points; empty where there are none, or one that is not finite.
BodyHull makeBodyHull(std::span<const Vec3> positions);

/// Makes the hull of points that come a few at a time. The same points give the same hull, to the
/// last bit, however they are divided.
class BodyHullBuilder {
public:
    BodyHullBuilder();
    void add(std::span<const Vec3> positions);
    /// @return as makeBodyHull
    BodyHull build() const;

private:
    /// Axes of the faces' normals: 3 of a box, 6 towards its edges, 4 towards its corners.
    static constexpr std::size_t Axes = 13;
    /// How far the points reach along each axis.
    std::array<double, Axes> mLeast;
    std::array<double, Axes> mMost;
    bool mFinite = true;
};

/// Appends the vertices of hull ∩ volume to `points`.
void clipHull(const BodyHull& hull, const Transform3& wsFromBody, const ConvexVolume& volume,
              ClipScratch& scratch, std::vector<Vec3>& points);

/// A box in a body's own space.
struct PlacedBox {
    Aabb box;
    /// To world axes relative to the problem's origin.
    Transform3 wsFromBody = Transform3::Identity();
};

/// The box around a box that is placed in the world.
inline Aabb boundsOf(const PlacedBox& placed) {
    return {placed.wsFromBody * placed.box.centre,
            placed.wsFromBody.linear().cwiseAbs() * placed.box.halfExtents};
}
/// The same of bounds that are kept in single precision.
inline Aabb boundsOf(const Eigen::AlignedBox3f& bounds, const Transform3& wsFromBody) {
    const Eigen::AlignedBox3d box = bounds.cast<double>();
    return boundsOf({{box.center(), box.sizes() / 2.0}, wsFromBody});
}

/// A body that shadows nothing of its own surface that faces the light.
struct SelfShadowFree {
    /// Around the body.
    PlacedBox around;
    /// Whether the body is that box itself.
    bool isBox = false;
    /// Which of its surface does nevertheless, in the body's own space; null where nothing does. It
    /// must outlive the fit.
    const Relief* relief = nullptr;
};

/// What is known of the bodies of a set beyond their boxes. A fit asks for those few that its map
/// would have to be larger for.
class BodyShapes {
public:
    virtual ~BodyShapes() = default;

    /// What tells the body from all others, among casters as among receivers; null where nothing
    /// does.
    virtual const void* identityOf(std::size_t /*index*/) const noexcept { return nullptr; }

    /** Whether the body is known to shadow nothing of itself that faces the light: a flat sheet or
        the closed surface of a convex body. A relief is one too, and may shadow itself behind
        slopes that face away. All are drawn from outside alone.

        No light ray meets such a body twice on sides that face the light. So whatever it shadows of
        itself faces away from the light (n . l <= 0). That is dark anyway and needs no shadow,
        from other bodies either: where it is known which sides these are, maps leave them out.
        Materials must shade it so, by the normals of its surface. A sheet that is lit on the side
        that the viewer does not see is dark in the same way, whether or not both its sides are
        drawn.
        @param[out] body where the answer is true: a box around it, whether it is that box, and its
        relief */
    virtual bool isSelfShadowFree(std::size_t /*index*/, SelfShadowFree& /*body*/) const noexcept {
        return false;
    }

    /** @param index of the body's box in its set
        @param wsFromBody is set to world axes relative to the problem's origin, from the hull's
               space
        @return null where the box is all that is known, or hardly larger */
    virtual const BodyHull* hullOf(std::size_t index, Transform3& wsFromBody) const noexcept = 0;
};

} // namespace Lixel
