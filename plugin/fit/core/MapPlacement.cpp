#include "fit/core/MapPlacement.h"

#include "fit/core/Warp.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <numbers>

namespace Lixel {
namespace {

/// A new orientation must save this much of the map's area before the old one is given up:
/// shimmering from a turned texel grid is worse than a tenth of its texels.
constexpr double OrientationGain = 0.10;

/// Beyond filter radius and the guard texel, for rounding of a map coordinate to float: half a unit
/// in the last place of 4096 texels is 2^-12; this is 64 times as much.
constexpr double RoundingTexels = 1.0 / 64.0;

/// Relative difference of areas that is only rounding.
constexpr double SameArea = 1e-12;

/// A focus region narrower than this fraction of its length is widened to it, one texel of a map
/// of 4096: thinner regions are rounding (a caster seen edge-on, a flat receiver).
constexpr double LeastAspect = 1.0 / 4096.0;

/// The rectangle along the last frame's axis, if there was one.
std::optional<OrientedRectangle> lastRectangle(const Polygon2& warped, const LightImage& image,
                                               const std::optional<WorldAxes>& wsLast) {
    if (!wsLast) return std::nullopt;
    const Vec3 axis = image.lsFromDirection(wsLast->front());
    return boundsAt(warped, std::fmod(std::atan2(axis.y(), axis.x()) + 2.0 * std::numbers::pi,
                                      std::numbers::pi / 2.0));
}

/// Bounds of a region along a map's axes.
struct AxisBounds {
    std::array<Vec2, 2> axes;
    Vec2 min;
    Vec2 max;
};

AxisBounds boundsOf(const OrientedRectangle& rectangle) {
    const Vec2 x(std::cos(rectangle.angle), std::sin(rectangle.angle));
    return {{x, Vec2(-x.y(), x.x())}, rectangle.min, rectangle.max};
}

/// Widens bounds about their middle where they are too narrow to be more than rounding.
void widen(AxisBounds& bounds, const Vec2& size, double liReach) {
    const double longest = (bounds.max - bounds.min).maxCoeff();
    for (int axis = 0; axis < 2; ++axis) {
        double& lower = bounds.min[axis];
        double& upper = bounds.max[axis];
        const double least = std::max(longest * LeastAspect, size[axis] * LeastTexel * liReach);
        if (upper - lower < least) {
            const double middle = (lower + upper) / 2.0;
            lower = middle - least / 2.0;
            upper = middle + least / 2.0;
        }
    }
}

/// How much a warp enlarges a short way in the light image, as seen along an axis of the map, where
/// it does most: the norm of that row of (I - p w^T) / D, which is the derivative of p = q / D with
/// D = 1 + w . q = 1 / (1 - w . p).
double magnification(const Polygon2& warped, const Vec2& warp, const Vec2& axis) {
    double greatest = 0.0;
    for (const Vec2& p : warped)
        greatest = std::max(greatest, (1.0 - warp.dot(p)) * (axis - axis.dot(p) * warp).norm());
    return greatest;
}

/// Texels that rounding of positions moves addresses by at most, along each axis of the map.
Vec2 roundingTexels(const Polygon2& warped, const Vec2& warp, double liReach,
                    const AxisBounds& bounds, const Vec2& size) {
    Vec2 result;
    for (int i = 0; i < 2; ++i) {
        const double texel = (bounds.max[i] - bounds.min[i]) / size[i];
        result[i] = magnification(warped, warp, bounds.axes[static_cast<std::size_t>(i)]) *
                    PositionRounding * liReach / texel;
    }
    return result;
}

/// Sets the map: the bounds, without the border, become -1 and 1.
void setMap(const AxisBounds& bounds, const Vec2& rounding, const ShadowProblem& problem,
            Affine& affine) {
    const Vec2 size(problem.mapWidth, problem.mapHeight);
    affine.border = rounding.array() + leastBorder(problem.filterRadius);
    const auto& [x, y] = bounds.axes;
    affine.mapAngle = std::atan2(x.y(), x.x());
    if (affine.mapAngle < 0.0) affine.mapAngle += std::numbers::pi;
    if (affine.mapAngle >= std::numbers::pi) affine.mapAngle = 0.0;
    affine.mapSkew = std::atan2(-x.dot(y), cross(x, y));
    affine.mapFromWarped.setIdentity();
    for (int i = 0; i < 2; ++i) {
        const Vec2& axis = bounds.axes[static_cast<std::size_t>(i)];
        const double scale =
            2.0 * (size[i] - 2.0 * affine.border[i]) / size[i] / (bounds.max[i] - bounds.min[i]);
        affine.mapFromWarped.row(i) << scale * axis.x(), scale * axis.y(),
            -scale * (bounds.min[i] + bounds.max[i]) / 2.0;
    }
}

} // namespace

MapAxes axesFromWorld(const WorldAxes& wsAxes, const LightImage& image) {
    MapAxes axes{};
    for (const std::size_t i : {0, 1})
        axes.normals[i] = image.lsFromDirection(wsAxes[i]).head<2>().stableNormalized();
    return axes;
}

WorldAxes axesInWorld(const MapAxes& axes, const LightImage& image) {
    WorldAxes wsAxes;
    for (const std::size_t i : {0, 1})
        wsAxes[i] =
            image.lsFromWs().transpose() * Vec3(axes.normals[i].x(), axes.normals[i].y(), 0.0);
    return wsAxes;
}

double leastBorder(double filterRadius) {
    return filterRadius + 1.0 + RoundingTexels;
}

Mat3 warpMatrix(const Vec2& warp, const Vec2& centre) {
    Mat3 warped = Mat3::Identity();
    warped.topRightCorner<2, 1>() = -centre;
    warped.row(2) << warp.x(), warp.y(), 1.0 - warp.dot(centre);
    return warped;
}

Affine placeRegion(const ShadowProblem& problem, const LightImage& image, const Polygon2& warped,
                   const Vec2& warp, double liReach, const std::optional<WorldAxes>& wsLast) {
    Affine result{};
    const Vec2 size(problem.mapWidth, problem.mapHeight);
    const OrientedRectangle rectangle = smallestRectangle(warped);
    std::optional<OrientedRectangle> last = lastRectangle(warped, image, wsLast);
    // Where the two are the same up to rounding, the one that a fresh state finds is taken. A kept
    // axis stays as it is: nothing may creep while nothing moves.
    if (last && !(last->area() > rectangle.area() * (1.0 + SameArea))) last.reset();
    const bool small = last && last->area() * (1.0 - OrientationGain) <= rectangle.area();

    const auto place = [&](AxisBounds& placed) {
        widen(placed, size, liReach);
        return roundingTexels(warped, warp, liReach, placed, size);
    };
    AxisBounds bounds = boundsOf(rectangle);
    Vec2 rounding = place(bounds);
    result.rounding = rounding.maxCoeff();
    result.wsMapAxes = axesInWorld({bounds.axes}, image);
    if (last) {
        AxisBounds lastBounds = boundsOf(*last);
        const Vec2 lastRounding = place(lastBounds);
        // Along other axes a narrow side may have finer texels than the border makes up for.
        result.turned = !small || lastRounding.maxCoeff() > GreatestBorderRounding;
        if (!result.turned) {
            bounds = lastBounds;
            rounding = lastRounding;
            result.wsMapAxes = wsLast;
        }
    }
    setMap(bounds, rounding, problem, result);
    return result;
}

Affine placeAlong(const ShadowProblem& problem, const LightImage& image, const Polygon2& warped,
                  const Vec2& warp, double liReach, const MapAxes& axes,
                  const std::optional<WorldAxes>& wsLast, const Affine& smallest) {
    const Vec2 size(problem.mapWidth, problem.mapHeight);
    AxisBounds bounds{axes.normals, Vec2::Zero(), Vec2::Zero()};
    for (int i = 0; i < 2; ++i) {
        const Vec2& axis = axes.normals[static_cast<std::size_t>(i)];
        bounds.max[i] = support(warped, axis);
        bounds.min[i] = -support(warped, -axis);
    }
    widen(bounds, size, liReach);
    const Vec2 rounding = roundingTexels(warped, warp, liReach, bounds, size);
    if (!(rounding.maxCoeff() <= GreatestBorderRounding)) return smallest;
    Affine result{};
    // The warp does not depend on the axes.
    result.rounding = smallest.rounding;
    result.wsMapAxes = axes.kept ? wsLast : axesInWorld(axes, image);
    result.turned = wsLast && !axes.kept;
    setMap(bounds, rounding, problem, result);
    return result;
}

Affine affineOf(const Mat3& homography, const Vec2& centre, double filterRadius, Vec2& warp) {
    const Mat3 h = homography / homography.row(2).dot(centre.homogeneous());
    warp = h.row(2).head<2>();
    Affine result{};
    result.mapFromWarped = h * warpMatrix(warp, centre).inverse();
    result.border.setConstant(leastBorder(filterRadius));
    return result;
}

std::optional<Mat3> movedByTexels(const Mat3& homography, const ShadowProblem& problem,
                                  const FocusRegion& region, double thickness, double liReach,
                                  PlacementScratch& scratch) {
    if (!homography.allFinite() || !(homography.determinant() > 0.0) ||
        !(homography.row(2).dot(region.liCentre.homogeneous()) > 0.0))
        return std::nullopt;
    Vec2 warp;
    const Mat3 mapFromWarped =
        affineOf(homography, region.liCentre, problem.filterRadius, warp).mapFromWarped;
    Vec2 safe = warp;
    if (pullIntoSafeSet(region.liHull, region.liCentre, thickness, safe) < 1.0) return std::nullopt;
    warpPolygon(region.liHull, region.liCentre, warp, scratch.warped);
    Mat3 moved = homography;
    for (const int axis : {0, 1}) {
        // In texels from the map's middle.
        const double size = axis == 0 ? problem.mapWidth : problem.mapHeight;
        const Vec2 texels = 0.5 * size * mapFromWarped.row(axis).head<2>().transpose();
        const double rounding =
            magnification(scratch.warped, warp, texels) * PositionRounding * liReach;
        if (!(rounding <= GreatestBorderRounding)) return std::nullopt;
        const double offset = 0.5 * size * mapFromWarped(axis, 2);
        const double upper = support(scratch.warped, texels) + offset;
        const double lower = offset - support(scratch.warped, -texels);
        const double room = 0.5 * size - rounding - leastBorder(problem.filterRadius);
        const double least = std::ceil(-room - lower);
        const double greatest = std::floor(room - upper);
        if (!(least <= greatest)) return std::nullopt;
        const double shift = std::clamp(std::round(-(lower + upper) / 2.0), least, greatest);
        moved.row(axis) += 2.0 * shift / size * homography.row(2);
    }
    return moved;
}

void growByBorder(const Affine& affine, const Vec2& size, const Vec2& warp,
                  const FocusRegion& region, PlacementScratch& scratch, Polygon2& grown) {
    // In the map, whose sides are 2, and back.
    const Mat3& map = affine.mapFromWarped;
    const Mat3 back = map.inverse();
    std::vector<Vec2>& points = scratch.points;
    points.clear();
    for (const Vec2& p : scratch.warped)
        points.push_back(map.topLeftCorner<2, 2>() * p + map.topRightCorner<2, 1>());
    sumWithRectangle(points, Vec2::UnitX(), 2.0 * affine.border.cwiseQuotient(size), grown);
    // In the map, where a texel is a texel: the near end of a warp has many in a small area.
    simplifyOutward(grown, FocusPolygon::Capacity);
    // 1 - w . p is one over the denominator. Where that stays well above 0, what is convex stays
    // so.
    double horizon = 1.0;
    for (const Vec2& p : scratch.warped)
        horizon = std::min(horizon, 1.0 - warp.dot(p));
    const double least = 0.5 * horizon;
    bool beyondHorizon = false;
    for (Vec2& p : grown) {
        p = back.topLeftCorner<2, 2>() * p + back.topRightCorner<2, 1>();
        const double unwarped = 1.0 - warp.dot(p);
        beyondHorizon = beyondHorizon || unwarped < least;
        p = region.liCentre + p / std::max(unwarped, least);
    }
    // A few texels beyond the far end, the grown polygon may reach the horizon. Half of the hull's
    // own least value, as a bound, keeps it finite. A corner held back is no longer on its own ray,
    // so the hull itself is added to the result.
    points.assign(grown.begin(), grown.end());
    if (beyondHorizon) points.insert(points.end(), region.liHull.begin(), region.liHull.end());
    convexHull(points, grown);
}

} // namespace Lixel
