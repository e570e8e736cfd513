#pragma once

#include "fit/focus/LightImage.h"
#include "fit/geometry/ConvexVolume.h"
#include "fit/geometry/Polygon2.h"

namespace Lixel {

/** The convex hull of bodies in the light image, which grows point by point.

    Most bodies lie within the image of the few at its rim. So the hull's edges are also kept as
    planes in the world, through the light: a box is compared with them as it is, without being
    projected, nor divided by its depth. Built anew with each point that grows it, instead of being
    changed, the hull would make fits take 1.15 times as long, up to 1.38.
*/
class ImageHull {
public:
    /// Starts an empty hull in that image.
    void reset(const LightImage& image);
    void add(std::span<const Vec2> points);

    /// Whether none of the points would make the hull larger, except by rounding.
    bool holds(std::span<const Vec2> points) const;

    /// The hull of all points added so far.
    const Polygon2& hull() const { return mHull; }
    /// For each edge, from its vertex on, the half space of rays on its inner side; none where the
    /// hull has no area. A local light's box that lies in all of them lies in front of the light.
    std::span<const HalfSpace> edges() const { return mEdges; }
    /// Counts how often the hull has changed.
    std::size_t revision() const { return mRevision; }

private:
    HalfSpace edgePlane(const Vec2& from, const Vec2& to) const;
    void addOne(const Vec2& point);
    /// Finds the hull of its vertices and more points anew.
    void rebuild(std::span<const Vec2> points);
    void findFlatness();
    /// Puts the point in the place of `count` vertices before the vertex `end`, around the polygon.
    /// @return where it is now; the edges to and from there are left to be set
    std::size_t replaceBefore(std::size_t end, std::size_t count, const Vec2& point);

    LightImage mImage;
    Polygon2 mHull;
    std::vector<HalfSpace> mEdges;
    /// The largest coordinate of the hull's vertices.
    double mCoordinate = 0.0;
    double mTwiceArea = 0.0;
    /// Of the longest way from a point of the hull to any that was added since: at least half its
    /// length.
    Vec2 mOrigin = Vec2::Zero();
    double mSquaredLength = 0.0;
    /// So narrow that rounding decides which side of an edge a point is on, or no polygon.
    bool mFlat = true;
    std::size_t mRevision = 0;
    /// What the hull is rebuilt from.
    Polygon2 mPoints;
};

/// The image of a box's eight corners; all of them must be in front of a local light.
std::array<Vec2, 8> boxImage(const LightImage& image, const Aabb& box);

} // namespace Lixel
