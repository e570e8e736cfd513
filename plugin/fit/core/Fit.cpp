#include "fit/core/Fit.h"

#include "fit/core/FixedMap.h"
#include "fit/core/MapPlacement.h"
#include "fit/core/Warp.h"
#include "fit/problem/ShadowPart.h"

#include <Eigen/LU>

#include <algorithm>
#include <numbers>

namespace Lixel {
namespace {

/// Depth from which on a local light's receivers keep their margin against rounding, relative to
/// the farthest's.
constexpr double NearestExactDepth = 1.0 / 64.0;

/// Halvings of the interval that holds the part of a warp which rounding leaves: what is left of it
/// changes the least of denominators, which is at least 2^-13, by less than a thousandth.
constexpr int PullSteps = 24;

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

InvalidInput invalidInputOf(const ShadowProblem& problem) {
    const ShadowLight& light = problem.light;
    const ShadowViewer& viewer = problem.viewer;
    if (problem.casters == nullptr || problem.receivers == nullptr) return InvalidInput::Bodies;
    if (problem.mapWidth < 1 || problem.mapHeight < 1 || !(problem.filterRadius >= 0.0))
        return InvalidInput::Map;
    if (2.0 * (leastBorder(problem.filterRadius) + GreatestBorderRounding) >=
        std::min(problem.mapWidth, problem.mapHeight))
        return InvalidInput::Map;
    if (!(viewer.shadowDistance >= 0.0)) return InvalidInput::ShadowDistance;
    if (!light.wsDirection.allFinite() || light.wsDirection.isZero(0.0))
        return InvalidInput::LightDirection;
    if (light.kind != LightKind::Directional) {
        if (!light.wsPosition.allFinite() ||
            light.wsPosition.cwiseAbs().maxCoeff() > GreatestExtent)
            return InvalidInput::LightPosition;
        if (!(light.nearDistance > 0.0) || !(light.nearDistance <= GreatestExtent))
            return InvalidInput::NearDistance;
        if (!(light.range > light.nearDistance)) return InvalidInput::Range;
        if (!(light.outerHalfAngle > 0.0) || !(light.outerHalfAngle < std::numbers::pi))
            return InvalidInput::Angle;
    }
    if (problem.casters->invalid() != 0) return InvalidInput::CasterBox;
    if (problem.receivers->invalid() != 0) return InvalidInput::ReceiverBox;
    if (!finite(viewer.viewFromWorld) || !finite(viewer.clipFromView)) return InvalidInput::View;
    if (!isRigid(viewer.viewFromWorld) || !invertible(viewer.clipFromView))
        return InvalidInput::View;
    return InvalidInput::None;
}

ShadowFit fitWithRule(const ShadowProblem& problem, FitState& state,
                      const WarpRule& rule) noexcept {
    ShadowFit fit;
    const auto stop = [&](FitReason reason) {
        fit.reason = reason;
        return fit;
    };
    if (!isValid(problem)) return stop(FitReason::InvalidInput);
    if (needsParts(problem.light)) return stop(FitReason::TooFewMaps);

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
    double leastDenominator = 1.0;
    const auto placeWarped = [&](const Vec2& warp) {
        leastDenominator = warpPolygon(region.liHull, region.liCentre, warp, state.warped);
        if (!given) affine = placeRegion(problem, image, state.warped, warp, liReach, state);
        return affine.rounding <= GreatestRounding;
    };
    if (!placeWarped(choice.liWarp)) {
        const Vec2 whole = choice.liWarp;
        double kept = 0.0;
        double lost = 1.0;
        for (int i = 0; i < PullSteps; ++i) {
            const double middle = (kept + lost) / 2.0;
            (placeWarped(middle * whole) ? kept : lost) = middle;
        }
        choice = {kept * whole, FitReason::WarpClamped};
        placeWarped(choice.liWarp);
    }
    if (!given) {
        state.wsMapAxis = affine.wsMapAxis;
        if (affine.turned) ++state.orientationJumps;
    }
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
