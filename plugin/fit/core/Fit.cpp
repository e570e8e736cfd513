#include "fit/core/Fit.h"

#include "fit/core/FixedMap.h"
#include "fit/core/MapPlacement.h"
#include "fit/core/Validity.h"
#include "fit/core/Warp.h"
#include "fit/problem/ShadowPart.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <limits>

namespace Lixel {
namespace {

/// Halvings in the search for the part of a warp that rounding allows. The last interval changes
/// the least denominator, which is at least 2^-13, by less than a thousandth.
constexpr int PullSteps = 24;

/// Least depth range, as a fraction of the focus region's size, for a flat receiver across the
/// light.
constexpr double LeastDepthRange = 1e-3;

/// Beyond the sides of a map's window, in half sides: what rounding needs, and less than a texel.
constexpr double WindowSlack = 1e-3;

/// A warp and the map that is made of it.
struct Placement {
    Vec2 liWarp;
    Affine affine;
    /// The warp's least denominator on the focus region.
    double leastDenominator = 1.0;
    FitReason reason = FitReason::None;
    /// Whether the rule gave the map whole.
    bool given = false;
};

/// Distances along the light's axis, and the row z that maps them to -1 and 1.
struct DepthRow {
    double lsNear;
    double lsFar;
    /// (coefficient of depth, constant).
    Vec2 row;
};

ShadowFit withoutMap(FitReason reason) {
    ShadowFit fit;
    fit.reason = reason;
    return fit;
}

/// The rule's choice. Where it is a whole map, the region is cut to what that serves.
WarpChoice choose(const WarpContext& context, const WarpRule& rule, FitState& state) {
    WarpChoice choice = rule(context, {state.memory, state.rule});
    if (!choice.liWarp.allFinite()) choice = {Vec2::Zero(), FitReason::WarpClamped};
    if (!choice.homography) return choice;
    const Served served = cutToMap(*choice.homography, state.region, state.placement);
    if (served != Served::Everything) choice.reason = FitReason::PlaneCannotServe;
    if (served == Served::Nothing) choice.homography.reset();
    return choice;
}

/// Places the map with the longest part of the chosen warp at which rounding does not show.
Placement placeWarp(const WarpContext& context, const WarpChoice& choice, FitState& state) {
    const FocusRegion& region = context.region;
    Placement result{.liWarp = choice.liWarp, .affine = {}, .reason = choice.reason};
    if (pullIntoSafeSet(region.liHull, region.liCentre, context.thickness, result.liWarp) < 1.0)
        result.reason = FitReason::WarpClamped;
    const auto place = [&](const Vec2& warp) {
        Polygon2& warped = state.placement.warped;
        result.leastDenominator = warpPolygon(region.liHull, region.liCentre, warp, warped);
        const double liReach = context.scale.liReach;
        const std::optional<WorldAxes>& wsLast = state.memory.wsMapAxes;
        result.affine = placeRegion(context.problem, context.image, warped, warp, liReach, wsLast);
        if (choice.axes)
            result.affine = placeAlong(context.problem, context.image, warped, warp, liReach,
                                       *choice.axes, wsLast, result.affine);
        return result.affine.rounding <= GreatestRounding;
    };
    if (place(result.liWarp)) return result;
    const Vec2 whole = result.liWarp;
    double kept = 0.0;
    double lost = 1.0;
    for (int i = 0; i < PullSteps; ++i) {
        const double middle = (kept + lost) / 2.0;
        (place(middle * whole) ? kept : lost) = middle;
    }
    result.liWarp = kept * whole;
    result.reason = FitReason::WarpClamped;
    place(result.liWarp);
    return result;
}

/// A map that the rule gave whole.
Placement placeGiven(const WarpContext& context, const WarpChoice& choice, FitState& state) {
    const FocusRegion& region = context.region;
    Placement result{.liWarp = Vec2::Zero(), .affine = {}, .reason = choice.reason, .given = true};
    result.affine =
        affineOf(*choice.homography, region.liCentre, context.problem.filterRadius, result.liWarp);
    result.leastDenominator =
        warpPolygon(region.liHull, region.liCentre, result.liWarp, state.placement.warped);
    return result;
}

/// Remembers the map's axes for the next frame.
void remember(const Placement& placement, FitMemory& memory) {
    if (placement.given) return;
    memory.wsMapAxes = placement.affine.wsMapAxes;
    if (placement.affine.turned) ++memory.orientationJumps;
}

/// Row z for depths along the light's axis, so that z / w stays within -1 and 1 wherever
/// w / (depth or 1) >= leastDenominator.
Vec2 depthRow(bool directional, double lsNear, double lsFar, double leastDenominator) {
    const double range = lsFar - lsNear;
    // Directional: linear. Local: the perspective one, affine in 1 / depth after the division.
    const Vec2 row = directional ? Vec2(2.0, -(lsFar + lsNear)) / range
                                 : Vec2(lsFar + lsNear, -2.0 * lsFar * lsNear) / range;
    return row * leastDenominator;
}

/// The receivers' depth range. Where depths cannot be clamped, it is stretched to the casters.
DepthRow depthOf(const WarpContext& context, const RegionScale& scale, double leastDenominator) {
    const FocusRegion& region = context.region;
    const ShadowProblem& problem = context.problem;
    const bool directional = context.image.directional();
    double lsNear = region.lsReceiverNear;
    double lsFar = region.lsReceiverFar;
    if (!problem.depthClamp) lsNear = std::min(lsNear, region.lsCasterNear);
    const double size = directional ? scale.liSize : scale.liSize * lsFar;
    const double slack =
        std::max(LeastDepthRange * (size + (lsFar - lsNear)), LeastTexel * scale.wsReach);
    lsNear -= slack;
    lsFar += slack;
    if (!directional) lsNear = std::max(lsNear, 0.5 * problem.light.nearDistance);
    return {lsNear, lsFar, depthRow(directional, lsNear, lsFar, leastDenominator)};
}

/// Clip space from light space, of a homography of ℓ and a row z.
Mat4 clipFromLight(bool directional, const Mat3& homography, const Vec2& depth) {
    // ℓ = (x, y, 1) or (x, y, -z), and depth = -z, in light space.
    const int third = directional ? 3 : 2;
    const double toThird = directional ? 1.0 : -1.0;
    Mat4 clip = Mat4::Zero();
    for (int row = 0; row < 3; ++row) {
        const int target = row == 2 ? 3 : row;
        clip(target, 0) = homography(row, 0);
        clip(target, 1) = homography(row, 1);
        clip(target, third) = toThird * homography(row, 2);
    }
    clip(2, 2) = -depth.x();
    clip(2, 3) = depth.y();
    return clip;
}

/// The homography of ℓ that a clip space from the world has: the other way around.
Mat3 homographyOf(const Mat4& clipFromWorld, const LightImage& image) {
    Mat3 homography;
    const Mat3 wsFromLs = image.lsFromWs().transpose();
    for (const int row : {0, 1, 2}) {
        const int source = row == 2 ? 3 : row;
        const Vec3 ls = (clipFromWorld.block<1, 3>(source, 0) * wsFromLs).transpose();
        const double atEye = clipFromWorld.row(source).dot(image.wsEye().homogeneous());
        homography.row(row) << ls.x(), ls.y(), image.directional() ? atEye : -ls.z();
    }
    return homography;
}

/// Where the light camera stands, and the matrices to its clip space.
void setMatrices(const LightImage& image, const Mat4& clip, ShadowFit& fit) {
    fit.directional = image.directional();
    fit.wsEye = image.wsEye();
    fit.lsFromWs = image.lsFromWs();
    fit.clipFromLight = clip;
    Mat4 lightFromWorld = Mat4::Identity();
    lightFromWorld.topLeftCorner<3, 3>() = fit.lsFromWs;
    lightFromWorld.topRightCorner<3, 1>() = -fit.lsFromWs * fit.wsEye;
    fit.clipFromWorld = clip * lightFromWorld;
}

void setDepth(const DepthRow& depth, ShadowFit& fit) {
    fit.lsNear = depth.lsNear;
    fit.lsFar = depth.lsFar;
    const double zNear = depth.row.x() * depth.lsNear + depth.row.y();
    const double zFar = depth.row.x() * depth.lsFar + depth.row.y();
    fit.depthScale = 1.0 / (zFar - zNear);
    fit.depthOffset = -zNear * fit.depthScale;
    fit.depthPerWorldUnit = 1.0 / (depth.lsFar - depth.lsNear);
}

/// Sets the polygon that a receiver's filter may reach.
/// @return false where the polygon would need more vertices than it can hold
bool setFocus(const WarpContext& context, const Placement& placement, PlacementScratch& scratch,
              ShadowFit& fit) {
    const Vec2 size(context.problem.mapWidth, context.problem.mapHeight);
    Polygon2& focus = scratch.grown;
    growByBorder(placement.affine, size, placement.liWarp, context.region, scratch, focus);
    simplifyOutward(focus, FocusPolygon::Capacity);
    if (focus.size() > FocusPolygon::Capacity) return false;
    fit.liFocus.count = focus.size();
    std::copy(focus.begin(), focus.end(), fit.liFocus.vertices.begin());
    return true;
}

/// The four half spaces of a map that was given whole: where -w <= x <= w and -w <= y <= w.
void setServed(ShadowFit& fit) {
    for (const int row : {0, 1})
        for (const double sign : {1.0, -1.0}) {
            const Vec4 side = fit.clipFromWorld.row(3) + sign * fit.clipFromWorld.row(row);
            fit.wsServed[fit.servedCount++] = side / side.head<3>().norm();
        }
}

ShadowFit assemble(const WarpContext& context, const Placement& placement, const DepthRow& depth,
                   PlacementScratch& scratch) {
    const FocusRegion& region = context.region;
    ShadowFit fit;
    fit.liCentre = region.liCentre;
    fit.liWarp = placement.liWarp;
    fit.mapAngle = placement.affine.mapAngle;
    fit.mapSkew = placement.affine.mapSkew;
    const Mat3 homography =
        placement.affine.mapFromWarped * warpMatrix(placement.liWarp, region.liCentre);
    setMatrices(context.image, clipFromLight(context.image.directional(), homography, depth.row),
                fit);
    setDepth(depth, fit);
    const bool hasFocus = setFocus(context, placement, scratch, fit);
    if (placement.given) setServed(fit);
    const bool isFinite = fit.clipFromWorld.allFinite() && std::isfinite(fit.depthScale) &&
                          std::isfinite(fit.depthOffset) && std::isfinite(fit.depthPerWorldUnit);
    if (!hasFocus || !isFinite)
        fit.reason = FitReason::InvalidInput;
    else
        fit.reason = placement.reason != FitReason::None ? placement.reason : region.reason;
    return fit;
}

} // namespace

/*  1. Focus: the light rays that matter (Gusev 2007, §3.6).
    2. Choose: the technique's rule picks a warp (Gusev 2007, eq. 2), or gives a whole map.
    3. Make safe: the warp is pulled to where its denominator is positive (Warp.h), and further, to
       where rounding of positions to float does not show.
    4. Place: the smallest rectangle around the warped region becomes the map (Gusev 2007, §3.6).
    5. Depth: one row, monotone along the light, for the receivers' range (Chong 2006, §3.2).
    6. Assemble: matrices, what a filter may reach, and the reason. */
ShadowFit fitWithRule(const ShadowProblem& problem, FitState& state,
                      const WarpRule& rule) noexcept {
    if (!isValid(problem)) return withoutMap(FitReason::InvalidInput);
    if (needsParts(problem.light)) return withoutMap(FitReason::TooFewMaps);

    const LightImage image(problem.light);
    const FocusRegion& region = state.region;
    findFocusRegion(problem, image, state.focusing, state.region);
    if (!hasMap(region.reason)) return withoutMap(region.reason);

    const WarpContext context = warpContext(problem, image, region);
    const WarpChoice choice = choose(context, rule, state);
    const Placement placement =
        choice.homography ? placeGiven(context, choice, state) : placeWarp(context, choice, state);
    remember(placement, state.memory);
    // A map that is given whole has cut the region.
    const RegionScale scale = placement.given ? scaleOf(image, region) : context.scale;
    const DepthRow depth = depthOf(context, scale, placement.leastDenominator);
    return assemble(context, placement, depth, state.placement);
}

void focusOnWindow(ShadowFit& fit, FitState& state) noexcept {
    if (!fit.hasMap()) return;
    Mat3 homography;
    const int third = fit.directional ? 3 : 2;
    for (const int row : {0, 1, 2}) {
        const int source = row == 2 ? 3 : row;
        homography.row(row) << fit.clipFromLight(source, 0), fit.clipFromLight(source, 1),
            (fit.directional ? 1.0 : -1.0) * fit.clipFromLight(source, third);
    }
    // One over the denominator at a point of the map; the horizon is where that is 0.
    const Mat3 back = homography.inverse();
    const auto unwarped = [&](const Vec2& ms) { return back.row(2).dot(ms.homogeneous()); };
    double horizon = std::numeric_limits<double>::infinity();
    for (const Vec2& q : fit.liFocus.span())
        horizon = std::min(horizon, 1.0 / homography.row(2).dot(q.homogeneous()));
    if (!(horizon > 0.0) || !std::isfinite(horizon)) return;
    const double side = 1.0 + WindowSlack;
    const std::array square{Vec2(-side, -side), Vec2(side, -side), Vec2(side, side),
                            Vec2(-side, side)};
    Polygon2& window = state.placement.grown;
    clipBy(
        square, [&](const Vec2& ms) { return unwarped(ms) - 0.5 * horizon; }, window);
    if (window.size() < 3 || window.size() > FocusPolygon::Capacity) return;
    for (Vec2& ms : window)
        ms = (back * ms.homogeneous()).hnormalized();
    fit.liFocus.count = window.size();
    std::copy(window.begin(), window.end(), fit.liFocus.vertices.begin());
}

std::optional<ShadowFit> fitToTexels(const ShadowProblem& problem, FitState& state,
                                     const ShadowFit& earlier, const Vec3& wsShift) noexcept {
    if (!earlier.hasMap()) return std::nullopt;
    bool fits = false;
    const auto rule = [&](const WarpContext& context, RuleState) {
        const Mat4 clipFromWorld = [&] {
            Mat4 matrix = earlier.clipFromWorld;
            matrix.col(3) += matrix.leftCols<3>() * wsShift;
            return matrix;
        }();
        WarpChoice choice;
        choice.homography = movedByTexels(homographyOf(clipFromWorld, context.image),
                                          context.problem, context.region, context.thickness,
                                          context.scale.liReach, state.placement);
        fits = choice.homography.has_value();
        return choice;
    };
    ShadowFit fit = fitWithRule(problem, state, rule);
    if (!fits || !fit.hasMap() || fit.reason == FitReason::PlaneCannotServe) return std::nullopt;
    // It serves all, as a map that was fitted does.
    fit.servedCount = 0;
    fit.reason = earlier.reason;
    return fit;
}

} // namespace Lixel
