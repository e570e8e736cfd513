#pragma once

#include "fit/geometry/Types.h"

#include <limits>
#include <span>

/** Convex polygons in the plane: what the light image of a body is.

    Polygons are vertex lists in counter-clockwise order without a closing vertex. One vertex (a
    point) and two (a segment) are legal polygons without area; none is the empty set.
*/
namespace Lixel {

using Polygon2 = std::vector<Vec2>;

/// z component of the cross product: twice the signed area spanned by a and b.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Convex hull of the points (Andrew's monotone chain, O(n log n)). The points are reordered.
void convexHull(std::vector<Vec2>& points, Polygon2& hull);

/// Intersection of two convex polygons (Sutherland-Hodgman on `a` by every edge of `b`), widened
/// by a relative rounding slack so that touching polygons keep what they touch in.
void intersect(const Polygon2& a, const Polygon2& b, Polygon2& result, Polygon2& scratch);

/// max |x|, |y| over the vertices: what their rounding is relative to; 0 of none.
double largestCoordinate(std::span<const Vec2> polygon);

/// Distance within which rounding may move a vertex of polygons with that largest coordinate, when
/// one is clipped by the other.
constexpr double clipSlack(double coordinate) {
    return 16.0 * std::numeric_limits<double>::epsilon() * coordinate;
}

/** The part of a convex polygon where an affine function is not negative (Sutherland and Hodgman
    1974).
    @param side the function, of a point
    @return whether anything was cut off */
template <typename Side>
bool clipBy(std::span<const Vec2> polygon, const Side& side, Polygon2& result) {
    result.clear();
    if (polygon.empty()) return false;
    bool isCut = false;
    const double first = side(polygon[0]);
    double sa = first;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const bool last = i + 1 == polygon.size();
        const Vec2& a = polygon[i];
        const Vec2& b = polygon[last ? 0 : i + 1];
        const double sb = last ? first : side(b);
        if (sa >= 0.0) result.push_back(a);
        if ((sa > 0.0 && sb < 0.0) || (sa < 0.0 && sb > 0.0))
            result.push_back(a + (b - a) * (sa / (sa - sb)));
        isCut = isCut || sa < 0.0;
        sa = sb;
    }
    return isCut;
}

/// Keeps of the polygon what lies to the left of the line from `from` to `to`, or within `slack` of
/// it; all of it where the two are one.
void clipLeftOf(std::span<const Vec2> polygon, const Vec2& from, const Vec2& to, double slack,
                Polygon2& result);

/// The Minkowski sum with the rectangle of those half sides along `axis`, a unit vector, and its
/// left-hand normal: what lies within the half sides of the polygon. Empty for an empty polygon.
/// If several edges in a row lie along one side of the rectangle, rounding may make the sum run
/// back and forth there. Then only the hull of its vertices is convex.
void sumWithRectangle(std::span<const Vec2> polygon, const Vec2& axis, const Vec2& halfSides,
                      Polygon2& sum);

/// Steiner point: the mean of the vertices weighted by exterior angle. It is interior, and moves
/// continuously with the polygon, which the centroid does not when the area vanishes.
Vec2 steinerPoint(std::span<const Vec2> polygon);

/// max of d . q over the polygon's vertices.
double support(std::span<const Vec2> polygon, const Vec2& d);

/// A polygon of at most `maxVertices` (>= 4) that contains the given one; edges whose removal adds
/// the least area go first.
void simplifyOutward(Polygon2& polygon, std::size_t maxVertices);

/// Bounds of a polygon along an axis pair.
struct OrientedRectangle {
    /// Direction of the rectangle's first side in radians, in [0, π/2).
    double angle = 0.0;
    /// Bounds along (cos, sin) of the angle and its left-hand normal.
    Vec2 min = Vec2::Zero();
    Vec2 max = Vec2::Zero();
    double area() const { return (max - min).prod(); }
};

/// The polygon's bounds along the axes at `angle`.
OrientedRectangle boundsAt(std::span<const Vec2> polygon, double angle);

/// The rectangle of smallest area around the polygon: one of its sides lies on an edge.
OrientedRectangle smallestRectangle(std::span<const Vec2> polygon);

} // namespace Lixel
