#include "fit/core/FixedMap.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>

namespace Lixel {
namespace {

/// Rounding of a covector's value, relative to the greatest on the polygon.
constexpr double OnTheEdge = 1e-12;

/// Least size of one row of a map beside the others: a float's exponents end at 2^-126, 1e-38.
constexpr double LeastRow = 1e-30;

/// Cuts a convex polygon to covector . (q, 1) >= 0. @return whether anything was cut off
bool cut(const Polygon2& polygon, const Vec3& covector, Polygon2& result) {
    const auto at = [&](const Vec2& q) { return covector.dot(q.homogeneous()); };
    double greatest = 0.0;
    for (const Vec2& q : polygon)
        greatest = std::max(greatest, std::abs(at(q)));
    const double slack = OnTheEdge * greatest;
    return clipBy(
        polygon, [&](const Vec2& q) { return at(q) + slack; }, result);
}

/// Whether it is a map, and still one in float.
bool isMap(const Mat3& homography) {
    const Vec3 rows = homography.rowwise().norm();
    return homography.allFinite() && homography.determinant() > 0.0 &&
           rows.minCoeff() > LeastRow * rows.maxCoeff();
}

} // namespace

Served cutToMap(const Mat3& homography, FocusRegion& region, PlacementScratch& scratch) {
    if (!isMap(homography)) return Served::Nothing;
    Polygon2& before = scratch.grown;
    Polygon2& after = scratch.warped;
    before = region.liHull;
    bool isCut = false;
    for (const int row : {0, 1})
        for (const double sign : {1.0, -1.0}) {
            const Vec3 covector = homography.row(2) + sign * homography.row(row);
            isCut = cut(before, covector, after) || isCut;
            std::swap(before, after);
            if (before.empty()) return Served::Nothing;
        }
    const Vec2 centre = steinerPoint(before);
    if (!(homography.row(2).dot(centre.homogeneous()) > 0.0)) return Served::Nothing;
    region.liHull = before;
    region.liCentre = centre;
    return isCut ? Served::Part : Served::Everything;
}

} // namespace Lixel
