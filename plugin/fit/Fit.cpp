#include "fit/Fit.h"

#include "fit/GivenMap.h"
#include "fit/Warp.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <numbers>

namespace Lixel {
namespace {

/// Widest cone of a single map, as half angle: tan(89.5°) = 115 spreads the map, but no plane
/// holds the rays of 90°.
constexpr double WidestHalfAngle = 89.5 * std::numbers::pi / 180.0;

/// A new orientation must save this much of the map's area before the old one is given up:
/// shimmering from a turned texel grid is worse than a tenth of its texels.
constexpr double OrientationGain = 0.10;

/// Beyond filter radius and the guard texel, for rounding of a map coordinate to float: half a unit
/// in the last place of 4096 texels is 2^-12; this is 64 times as much.
constexpr double RoundingTexels = 1.0 / 64.0;

/// Rounding of positions and of the matrix to float, relative to the distance over which positions
/// are measured: four terms, each of half a unit in the last place, 2^-24.
constexpr double PositionRounding = 4.0 * 0x1p-24;

/// Least size of a texel at the region's centre, relative to the distance over which positions are
/// measured: PositionRounding is an eighth of it.
constexpr double LeastTexel = 0x1p-19;

/// Most that a warp is counted with to magnify such rounding where its denominator is least. There
/// a texel may be smaller than LeastTexel by more; rounding then shows, and no border makes up for
/// it.
constexpr double GreatestMagnification = 8.0;

/// Relative difference of areas that is only rounding.
constexpr double SameArea = 1e-12;

/// Depth from which on a local light's receivers keep their margin against rounding, relative to
/// the farthest's.
constexpr double NearestExactDepth = 1.0 / 64.0;

/// A focus region narrower than this fraction of its length is widened to it, one texel of a map
/// of 4096: thinner regions are rounding (a caster seen edge-on, a flat receiver).
constexpr double LeastAspect = 1.0 / 4096.0;

/// Least depth range, as a fraction of the focus region's size: the light along a flat receiver.
constexpr double LeastDepthRange = 1e-3;

bool finite(const Mat4& m) {
    return m.allFinite();
}

/// Whether the matrix has an inverse, whatever unit its columns are in.
bool invertible(const Mat4& m) {
    const Eigen::RowVector4d norms = m.colwise().norm();
    if (!(norms.minCoeff() > 0.0)) return false;
    constexpr double Singular = 1e-12; // some thousand roundings of a determinant of unit columns
    return std::abs((m.array().rowwise() / norms.array()).matrix().determinant()) > Singular;
}

/// Whether the view matrix is a rigid motion, or one with a mirror: depths are measured with it.
bool isRigid(const Mat4& viewFromWorld) {
    // Far beyond what a float's quaternion drifts by until its owner normalises it.
    constexpr double Distortion = 0.01;
    const Mat3 rotation = viewFromWorld.topLeftCorner<3, 3>();
    const Mat3 product = rotation * rotation.transpose();
    return (product - Mat3::Identity()).cwiseAbs().maxCoeff() <= Distortion &&
           viewFromWorld.row(3) == Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0);
}

/// Whether every number that a fit depends on is usable.
bool valid(const ShadowProblem& problem) {
    const ShadowLight& light = problem.light;
    const ShadowViewer& viewer = problem.viewer;
    if (problem.casters == nullptr || problem.receivers == nullptr) return false;
    if (problem.mapWidth < 1 || problem.mapHeight < 1) return false;
    if (!(problem.filterRadius >= 0.0)) return false;
    if (2.0 * (problem.filterRadius + 1.0 + RoundingTexels +
               GreatestMagnification * PositionRounding / LeastTexel) >=
        std::min(problem.mapWidth, problem.mapHeight))
        return false;
    if (!finite(viewer.viewFromWorld) || !finite(viewer.clipFromView)) return false;
    if (!(viewer.shadowDistance >= 0.0)) return false;
    if (!isRigid(viewer.viewFromWorld) || !invertible(viewer.clipFromView)) return false;
    if (!light.wsDirection.allFinite() || light.wsDirection.isZero(0.0)) return false;
    if (light.kind != LightKind::Directional) {
        if (!light.wsPosition.allFinite()) return false;
        if (light.wsPosition.cwiseAbs().maxCoeff() > GreatestExtent) return false;
        if (!(light.nearDistance > 0.0) || !(light.nearDistance <= GreatestExtent)) return false;
        if (!(light.range > light.nearDistance)) return false;
        if (!(light.outerHalfAngle > 0.0) || !(light.outerHalfAngle < std::numbers::pi))
            return false;
    }
    return problem.casters->invalid() == 0 && problem.receivers->invalid() == 0;
}

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
        result.border[axis] = problem.filterRadius + 1.0 + RoundingTexels +
                              magnification * PositionRounding * liReach / texel;
    }
    return result;
}

/// (q - c) / (1 + w . (q - c)), as a homography of ℓ = (q, 1).
Mat3 warpMatrix(const Vec2& warp, const Vec2& centre) {
    Mat3 warped = Mat3::Identity();
    warped.topRightCorner<2, 1>() = -centre;
    warped.row(2) << warp.x(), warp.y(), 1.0 - warp.dot(centre);
    return warped;
}

/// What makes a map of the warped light image, and the texels that it keeps free on each side.
struct Affine {
    Mat3 mapFromWarped;
    Vec2 border;
    double mapAngle;
};

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

/// A map that is given whole, as the warp that its row w is and what is affine in it.
Affine affineOf(const Mat3& homography, const Vec2& centre, double filterRadius, Vec2& warp) {
    const Mat3 h = homography / homography.row(2).dot(centre.homogeneous());
    warp = h.row(2).head<2>();
    return {h * warpMatrix(warp, centre).inverse(),
            Vec2::Constant(filterRadius + 1.0 + RoundingTexels), 0.0};
}

/// The focus region and what a receiver's filter reaches beyond it, in the light image: the warped
/// hull's sum with a rectangle of the map's border, unwarped.
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
    // so, and its vertices remain its vertices.
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
    if (!beyondHorizon) return;
    // A few texels beyond the far end it may reach the horizon; half the hull's own least value
    // keeps the polygon finite. A corner held back is not on its own ray any more, so that the hull
    // itself belongs to the result as it is.
    points.assign(grown.begin(), grown.end());
    points.insert(points.end(), state.region.liHull.begin(), state.region.liHull.end());
    convexHull(points, grown);
}

/// Row z of clip space, as (coefficient of depth, constant), for depths along the light's axis, so
/// that z / w stays within -1 and 1 wherever w / (depth or 1) >= leastDenominator.
Vec2 depthRow(bool directional, double lsNear, double lsFar, double leastDenominator) {
    const double range = lsFar - lsNear;
    // Directional: linear. Local: the perspective one, affine in 1 / depth after the division.
    const Vec2 row = directional ? Vec2(2.0, -(lsFar + lsNear)) / range
                                 : Vec2(lsFar + lsNear, -2.0 * lsFar * lsNear) / range;
    return row * leastDenominator;
}

} // namespace

ShadowFit fitWithRule(const ShadowProblem& problem, FitState& state,
                      const WarpRule& rule) noexcept {
    ShadowFit fit;
    const auto stop = [&](FitReason reason) {
        fit.reason = reason;
        return fit;
    };
    if (!valid(problem)) return stop(FitReason::InvalidInput);
    if (problem.light.kind == LightKind::Point ||
        (problem.light.kind == LightKind::Spot && problem.light.outerHalfAngle > WidestHalfAngle))
        return stop(FitReason::UnsupportedLight);

    const LightImage image(problem.light);
    FocusRegion& region = state.region;
    findFocusRegion(problem, image, state.scratch, region);
    if (!hasMap(region.reason)) return stop(region.reason);

    // The warp, and its safety.
    const Mat4 worldFromView = problem.viewer.viewFromWorld.inverse();
    const WarpContext context{
        .problem = problem,
        .image = image,
        .region = region,
        .state = state,
        .viewer = image.oriented(image.lsFromPoint(worldFromView.topRightCorner<3, 1>())),
        .viewDirection = image.orientedDirection(
            image.lsFromDirection(-worldFromView.block<3, 1>(0, 2).stableNormalized())),
        .perspective = problem.viewer.clipFromView.row(3).head<3>().norm() >
                       1e-9 * std::abs(problem.viewer.clipFromView(3, 3)),
    };
    WarpChoice choice = rule(context);
    if (!choice.liWarp.allFinite()) choice = {Vec2::Zero(), FitReason::WarpClamped};
    if (choice.homography) {
        const Served served = cutToMap(*choice.homography, region, state.scratch);
        if (served != Served::Everything) choice.reason = FitReason::PlaneCannotServe;
        if (served == Served::Nothing) choice.homography.reset();
    }
    const bool given = choice.homography.has_value();
    Affine affine{};
    if (given)
        affine = affineOf(*choice.homography, region.liCentre, problem.filterRadius, choice.liWarp);
    // How far from the origin, or from a local light, receivers are; anything but 0 where they are
    // a point at the origin.
    const bool directional = image.directional();
    double wsReach = std::max({std::abs(region.lsReceiverNear), std::abs(region.lsReceiverFar),
                               directional ? region.liCentre.norm() : image.wsEye().norm()});
    if (!(wsReach > 0.0)) wsReach = 1.0;
    // Receivers in the first part of a spot's depth are few: rounding there must not cost the map.
    const double nearDepth =
        std::max(region.lsReceiverNear, region.lsReceiverFar * NearestExactDepth);
    const double liReach = directional ? wsReach : wsReach / nearDepth;
    const double size =
        (support(region.liHull, Vec2::UnitX()) + support(region.liHull, -Vec2::UnitX())) +
        (support(region.liHull, Vec2::UnitY()) + support(region.liHull, -Vec2::UnitY()));
    // A texel; or what is one to rounding, where the region is smaller than that.
    const double thickness =
        std::max(size / std::max(problem.mapWidth, problem.mapHeight), LeastTexel * liReach);
    if (!given && pullIntoSafeSet(region.liHull, region.liCentre, thickness, choice.liWarp) < 1.0)
        choice.reason = FitReason::WarpClamped;

    // The affine fit around the warped region.
    const double leastDenominator =
        warpPolygon(region.liHull, region.liCentre, choice.liWarp, state.warped);
    if (!given)
        affine = affineFit(place(problem, chooseRectangle(state.warped, image, state), liReach,
                                 std::min(1.0 / leastDenominator, GreatestMagnification)));
    const Mat3 h = affine.mapFromWarped * warpMatrix(choice.liWarp, region.liCentre);

    // Depth: what receives, and no more, where casters before it are clamped onto its near end.
    double lsNear = region.lsReceiverNear;
    double lsFar = region.lsReceiverFar;
    if (!problem.depthClamp) lsNear = std::min(lsNear, region.lsCasterNear);
    const double reach = image.directional() ? size : size * lsFar;
    const double slack =
        std::max(LeastDepthRange * (reach + (lsFar - lsNear)), LeastTexel * wsReach);
    lsNear -= slack;
    lsFar += slack;
    if (!image.directional()) lsNear = std::max(lsNear, 0.5 * problem.light.nearDistance);
    const Vec2 depth = depthRow(image.directional(), lsNear, lsFar, leastDenominator);

    // ℓ = (x, y, 1) or (x, y, -z), and depth = -z, in light space.
    const int third = image.directional() ? 3 : 2;
    const double toThird = image.directional() ? 1.0 : -1.0;
    Mat4 clip = Mat4::Zero();
    for (int row = 0; row < 3; ++row) {
        const int target = row == 2 ? 3 : row;
        clip(target, 0) = h(row, 0);
        clip(target, 1) = h(row, 1);
        clip(target, third) = toThird * h(row, 2);
    }
    clip(2, 2) = -depth.x();
    clip(2, 3) = depth.y();

    fit.directional = image.directional();
    fit.wsEye = image.wsEye();
    fit.lsFromWs = image.lsFromWs();
    fit.clipFromLight = clip;
    Mat4 lightFromWorld = Mat4::Identity();
    lightFromWorld.topLeftCorner<3, 3>() = fit.lsFromWs;
    lightFromWorld.topRightCorner<3, 1>() = -fit.lsFromWs * fit.wsEye;
    fit.clipFromWorld = clip * lightFromWorld;
    fit.lsNear = lsNear;
    fit.lsFar = lsFar;
    const double zNear = depth.x() * lsNear + depth.y();
    const double zFar = depth.x() * lsFar + depth.y();
    fit.depthScale = 1.0 / (zFar - zNear);
    fit.depthOffset = -zNear * fit.depthScale;
    fit.depthPerWorldUnit = 1.0 / (lsFar - lsNear);
    fit.liCentre = region.liCentre;
    fit.liWarp = choice.liWarp;
    fit.mapAngle = affine.mapAngle;
    Polygon2& focus = state.scratch.polygon;
    growByBorder(affine, Vec2(problem.mapWidth, problem.mapHeight), choice.liWarp, region.liCentre,
                 state, focus);
    simplifyOutward(focus, FocusPolygon::Capacity);
    if (focus.size() > FocusPolygon::Capacity) return stop(FitReason::InvalidInput);
    fit.liFocus.count = focus.size();
    std::copy(focus.begin(), focus.end(), fit.liFocus.vertices.begin());

    if (given)
        // Where -w <= x <= w and -w <= y <= w.
        for (const int row : {0, 1})
            for (const double sign : {1.0, -1.0}) {
                const Vec4 side = fit.clipFromWorld.row(3) + sign * fit.clipFromWorld.row(row);
                fit.wsServed[fit.servedCount++] = side / side.head<3>().norm();
            }

    if (!finite(fit.clipFromWorld) || !std::isfinite(fit.depthScale) ||
        !std::isfinite(fit.depthOffset) || !std::isfinite(fit.depthPerWorldUnit))
        return stop(FitReason::InvalidInput);
    fit.reason = choice.reason != FitReason::None ? choice.reason : region.reason;
    return fit;
}

} // namespace Lixel
