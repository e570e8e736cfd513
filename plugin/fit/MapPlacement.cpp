#include "fit/MapPlacement.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
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

/// Chooses the map's axes around the warped region: the smallest rectangle, unless the last
/// frame's orientation is nearly as good.
OrientedRectangle chooseRectangle(const Polygon2& warped, const LightImage& image,
                                  FitState& state) {
    const OrientedRectangle best = smallestRectangle(warped);
    if (state.wsMapAxis) {
        const Vec3 axis = image.lsFromDirection(*state.wsMapAxis);
        const double angle = std::fmod(std::atan2(axis.y(), axis.x()) + 2.0 * std::numbers::pi,
                                       std::numbers::pi / 2.0);
        const OrientedRectangle kept = boundsAt(warped, angle);
        // Where the two are one but for rounding, the one that a fresh state finds is taken; and a
        // kept axis stays as it is: nothing may creep while nothing moves.
        if (kept.area() > best.area() * (1.0 + SameArea)) {
            if (kept.area() * (1.0 - OrientationGain) <= best.area()) return kept;
            ++state.orientationJumps;
        }
    }
    state.wsMapAxis =
        image.lsFromWs().transpose() * Vec3(std::cos(best.angle), std::sin(best.angle), 0.0);
    return best;
}

/// Where the region's rectangle lies in the map.
struct Placement {
    /// Wide enough in both directions to be more than rounding.
    OrientedRectangle rectangle;
    /// Texels kept free on each side, along the map's axes.
    Vec2 border;
    /// Size of the map in texels.
    Vec2 size;

    /// The map's coordinates, -1 to 1, from a rectangle's: scale and offset along one axis.
    double scale(int axis) const {
        const double sides = rectangle.max[axis] - rectangle.min[axis];
        return 2.0 * (size[axis] - 2.0 * border[axis]) / size[axis] / sides;
    }
    double offset(int axis) const {
        return -scale(axis) * (rectangle.min[axis] + rectangle.max[axis]) / 2.0;
    }
};

/// Places the rectangle, widened about its middle where it is too narrow.
/// @param liReach the distance over which positions are measured, as a length in the light image
/// @param magnification how much the warp enlarges the rounding of a position, where it does most
Placement place(const ShadowProblem& problem, OrientedRectangle rectangle, double liReach,
                double magnification) {
    Placement result{rectangle, Vec2::Zero(), Vec2(problem.mapWidth, problem.mapHeight)};
    const double longest = (rectangle.max - rectangle.min).maxCoeff();
    for (int axis = 0; axis < 2; ++axis) {
        double& lower = result.rectangle.min[axis];
        double& upper = result.rectangle.max[axis];
        const double least =
            std::max(longest * LeastAspect, result.size[axis] * LeastTexel * liReach);
        if (upper - lower < least) {
            const double middle = (lower + upper) / 2.0;
            lower = middle - least / 2.0;
            upper = middle + least / 2.0;
        }
        const double texel = (upper - lower) / result.size[axis];
        result.border[axis] =
            leastBorder(problem.filterRadius) + magnification * PositionRounding * liReach / texel;
    }
    return result;
}

/// The rectangle's sides, without the border, become -1 and 1.
Affine affineFit(const Placement& placement) {
    const double cosine = std::cos(placement.rectangle.angle);
    const double sine = std::sin(placement.rectangle.angle);
    const double x = placement.scale(0);
    const double y = placement.scale(1);
    Affine result{Mat3::Identity(), placement.border, placement.rectangle.angle};
    result.mapFromWarped << x * cosine, x * sine, placement.offset(0), //
        -y * sine, y * cosine, placement.offset(1),                    //
        0.0, 0.0, 1.0;
    return result;
}

} // namespace

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
                   double liReach, double magnification, FitState& state) {
    return affineFit(place(problem, chooseRectangle(warped, image, state), liReach, magnification));
}

Affine affineOf(const Mat3& homography, const Vec2& centre, double filterRadius, Vec2& warp) {
    const Mat3 h = homography / homography.row(2).dot(centre.homogeneous());
    warp = h.row(2).head<2>();
    return {h * warpMatrix(warp, centre).inverse(), Vec2::Constant(leastBorder(filterRadius)), 0.0};
}

void growByBorder(const Affine& affine, const Vec2& size, const Vec2& warp, const Vec2& centre,
                  FitState& state, Polygon2& grown) {
    // In the map, whose sides are 2, and back.
    const Mat3& map = affine.mapFromWarped;
    const Mat3 back = map.inverse();
    std::vector<Vec2>& points = state.scratch.points;
    points.clear();
    for (const Vec2& p : state.warped)
        points.push_back(map.topLeftCorner<2, 2>() * p + map.topRightCorner<2, 1>());
    sumWithRectangle(points, Vec2::UnitX(), 2.0 * affine.border.cwiseQuotient(size), grown);
    // 1 - w . p is one over the denominator. Where that stays well above 0, what is convex stays
    // so.
    double horizon = 1.0;
    for (const Vec2& p : state.warped)
        horizon = std::min(horizon, 1.0 - warp.dot(p));
    const double least = 0.5 * horizon;
    bool beyondHorizon = false;
    for (Vec2& p : grown) {
        p = back.topLeftCorner<2, 2>() * p + back.topRightCorner<2, 1>();
        const double unwarped = 1.0 - warp.dot(p);
        beyondHorizon = beyondHorizon || unwarped < least;
        p = centre + p / std::max(unwarped, least);
    }
    // A few texels beyond the far end it may reach the horizon; half the hull's own least value
    // keeps the polygon finite. A corner held back is not on its own ray any more, so that the hull
    // itself belongs to the result as it is.
    points.assign(grown.begin(), grown.end());
    if (beyondHorizon)
        points.insert(points.end(), state.region.liHull.begin(), state.region.liHull.end());
    convexHull(points, grown);
}

} // namespace Lixel
