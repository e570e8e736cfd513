/// Gusev's own formulas, at the places where the paper states them.
#include "fit/technique/Xpsm.h"

#include "fit/technique/Corridor.h"

#include "fit/core/Warp.h"
#include "fit/focus/LightImage.h"
#include "fit/technique/Uniform.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// The technique as the paper has it: eq. (3) and §3.2 alone pick the length.
XpsmOptions literal(double strength, double epsilonW = 0.7) {
    return {.strength = strength, .epsilonW = epsilonW, .guarded = false};
}

Scene lampedCorridor(const Vec3& position, const Vec3& direction) {
    Scene scene = corridor(direction);
    scene.light.kind = LightKind::Spot;
    scene.light.wsPosition = position;
    scene.light.outerHalfAngle = 70.0 * Degree;
    return scene;
}

double coefOf(const XpsmOptions& options) {
    return options.strength / std::sqrt(NearDepth * FarDepth);
}

/// The least denominator of the focus region, relative to that at the viewer's image.
double leastDenominator(const ShadowFit& fit, const FitState& state, const Vec2& viewer) {
    const auto denominator = [&](const Vec2& q) { return 1.0 + fit.liWarp.dot(q - fit.liCentre); };
    double least = Infinity;
    for (const Vec2& q : state.region.liHull)
        least = std::min(least, denominator(q));
    return least / denominator(viewer);
}

Vec2 imageOfOrigin(const Scene& scene) {
    const LightImage image(scene.light);
    return image.project(image.lsFromPoint(Vec3::Zero()));
}

/// A light at `angle` to the view direction -z, in the y-z plane, shining down and away.
Vec3 lightAt(double angle) {
    return {0.0, -std::sin(angle), -std::cos(angle)};
}

} // namespace

TEST(Xpsm, DenominatorGrowsWithDepthByCoef) {
    // §3.2, whatever the angle between view and light, as long as eq. (3) does not bind.
    for (const double strength : {0.25, 1.0, 2.0})
        for (const double degrees : {15.0, 30.0, 60.0, 90.0, 100.0}) {
            const Scene scene = corridor(lightAt(degrees * Degree));
            const XpsmOptions options = literal(strength);
            FitState state;
            const ShadowFit fit = fitMap(scene.problem(), options, state);
            ASSERT_EQ(fit.reason, FitReason::None) << degrees;
            for (const double depth : {1.0, NearDepth, 20.0, FarDepth})
                EXPECT_NEAR(denominatorAt(fit, depth), 1.0 + coefOf(options) * depth, 1e-9)
                    << degrees << "°, depth " << depth;
        }
}

TEST(Xpsm, WarpOfASpotRunsAlongTheImageOfTheView) {
    for (const Vec3& position : {Vec3(0.0, 15.0, -20.0), Vec3(8.0, 12.0, -10.0)}) {
        const Scene scene = lampedCorridor(position, Vec3(0.0, 0.0, -20.0) - position);
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), literal(4.0), state);
        ASSERT_TRUE(fit.hasMap()) << fit.reason;
        // The view line's image by two of its points.
        const LightImage image(scene.light);
        const Vec2 along =
            image.project(image.lsFromPoint(Vec3(0.0, 0.0, -0.1))) - imageOfOrigin(scene);
        EXPECT_NEAR(cross(along.normalized(), fit.liWarp), 0.0, 1e-9);
        EXPECT_GE(along.dot(fit.liWarp), 0.0);
    }
}

TEST(Xpsm, DenominatorsOfASpotSpanNoMoreThanTheDepthsDo) {
    for (const Vec3& position : {Vec3(0.0, 15.0, -20.0), Vec3(8.0, 12.0, -10.0)})
        for (const double strength : {0.5, 2.0, 8.0}) {
            const Scene scene = lampedCorridor(position, Vec3(0.0, 0.0, -20.0) - position);
            const XpsmOptions options = literal(strength);
            FitState state;
            const ShadowFit fit = fitMap(scene.problem(), options, state);
            ASSERT_TRUE(fit.hasMap()) << fit.reason;
            const WarpExtent extent =
                warpExtent(state.region.liHull, fit.liCentre, fit.liWarp, 0.0);
            const double coef = coefOf(options);
            EXPECT_LE((1.0 + extent.greatest) / (1.0 - extent.least),
                      (1.0 + coef * FarDepth) / (1.0 + coef * NearDepth) + 1e-9)
                << position.transpose() << ", strength " << strength;
        }
}

TEST(Xpsm, BoundLeavesEpsilonWOnTheFocusRegion) {
    // Eq. (3): dueling light and view, so that the region's image is on both sides of the viewer's.
    for (const double epsilonW : {0.3, 0.7, 0.95}) {
        const Scene scene = corridor(Vec3(0.0, -0.3, 1.0), 3.0);
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), literal(4.0, epsilonW), state);
        ASSERT_EQ(fit.reason, FitReason::WarpClamped);
        EXPECT_NEAR(leastDenominator(fit, state, imageOfOrigin(scene)), epsilonW, 1e-9);
    }
}

TEST(Xpsm, MinersLampHasNoWarp) {
    // §3.11: the light along the view.
    const Scene scene = corridor(Vec3(0.0, 0.0, -1.0));
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), XpsmOptions{}, state);
    EXPECT_EQ(fit.reason, FitReason::LightAlongView);
    EXPECT_EQ(fit.liWarp, Vec2::Zero());
}

TEST(Xpsm, DuelingFrustaHaveNoWarpWhenExactlyOpposed) {
    Scene scene = corridor(Vec3(0.0, 0.0, 1.0));
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), XpsmOptions{}, state);
    EXPECT_EQ(fit.reason, FitReason::LightAlongView);
    EXPECT_EQ(fit.liWarp, Vec2::Zero());
}

TEST(Xpsm, LampInTheViewersHandHasNoWarp) {
    const Scene scene = lampedCorridor(Vec3::Zero(), Vec3(0.0, 0.0, -1.0));
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), XpsmOptions{}, state);
    ASSERT_TRUE(fit.hasMap()) << fit.reason;
    EXPECT_LT(fit.liWarp.norm(), 1e-12);
}

TEST(Xpsm, WarpFadesInAroundGusevsThreshold) {
    // Half of the warp at |V_xy| = 0.1 (step 3), all of it from 0.2 on.
    for (const auto& [sine, expected] : {std::pair(0.02, 0.028), std::pair(0.1, 0.5),
                                         std::pair(0.15, 0.84375), std::pair(0.2, 1.0)}) {
        // Above the view line, so that eq. (3) does not bind.
        const Scene scene = corridor(lightAt(std::asin(sine)), 1.0, 1.5);
        FitState state;
        const XpsmOptions options = literal(1.0);
        const ShadowFit fit = fitMap(scene.problem(), options, state);
        // Unfaded: eq. (2) about the viewer, with §3.2's length, moved to the region's centre.
        const LightImage image(scene.light);
        const Vec2 direction = image.lsFromDirection(Vec3(0.0, 0.0, -1.0)).head<2>().normalized();
        const double length = coefOf(options) / sine;
        const double atCentre = 1.0 + length * direction.dot(fit.liCentre - imageOfOrigin(scene));
        const Vec2 unfaded = length / atCentre * direction;
        EXPECT_NEAR((fit.liWarp - expected * unfaded).norm(), 0.0, 1e-9 * unfaded.norm()) << sine;
    }
}

TEST(Xpsm, CasterBehindViewerDampensTheWarpButDoesNotUndoIt) {
    // §2.2, the back projection interval: receivers in view are shadowed from behind the viewer.
    Scene scene = corridor(Vec3(0.0, -0.4, 1.0), 3.0);
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), literal(4.0), state);
    EXPECT_EQ(fit.reason, FitReason::WarpClamped);
    EXPECT_GT(fit.liWarp.norm(), 0.0);
    scene.casters.add({Vec3(0.0, 2.0, 6.0), Vec3(30.0, 30.0, 0.5)});
    scene.light.wsDirection = Vec3(0.0, -0.4, -1.0);
    const ShadowFit behind = fitMap(scene.problem(), literal(4.0), state);
    ASSERT_TRUE(behind.hasMap());
    EXPECT_GT(behind.liWarp.norm(), 0.0);
}

TEST(Xpsm, WithoutStrengthIsUniform) {
    const Scene scene = outdoors();
    FitState state;
    const ShadowFit uniform = fitMap(scene.problem(), UniformOptions{}, state);
    FitState other;
    const ShadowFit xpsm = fitMap(scene.problem(), XpsmOptions{.strength = 0.0}, other);
    EXPECT_EQ(xpsm.clipFromWorld, uniform.clipFromWorld);
    EXPECT_EQ(xpsm.reason, FitReason::None);
}

TEST(Xpsm, OfAnOrthographicViewerIsUniform) {
    Scene scene = outdoors();
    scene.viewer.clipFromView = orthographic(10.0, 10.0, 0.1, 100.0);
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), XpsmOptions{}, state);
    EXPECT_EQ(fit.reason, FitReason::None);
    EXPECT_EQ(fit.liWarp, Vec2::Zero());
}

TEST(Xpsm, OfAMirroredViewIsTheSame) {
    // A viewer with a mirror sees the same points from the same place.
    Scene scene = outdoors();
    FitState state;
    const ShadowFit plain = fitMap(scene.problem(), literal(2.0), state);
    scene.viewer.viewFromWorld =
        Vec4(-1.0, 1.0, 1.0, 1.0).asDiagonal() * scene.viewer.viewFromWorld;
    FitState other;
    const ShadowFit mirrored = fitMap(scene.problem(), literal(2.0), other);
    EXPECT_LT((mirrored.clipFromWorld - plain.clipFromWorld).norm(),
              1e-9 * plain.clipFromWorld.norm());
}

TEST(Xpsm, GarbageOptionsGiveAFiniteMap) {
    for (const double strength : {NaN, Infinity, -Infinity, -1.0, 1e300, 5e-324})
        for (const double epsilonW : {NaN, Infinity, -Infinity, -1.0, 0.0, 1.0, 2.0, 0.7}) {
            const Scene scene = outdoors();
            FitState state;
            for (const bool guarded : {true, false}) {
                const ShadowFit fit = fitMap(
                    scene.problem(),
                    XpsmOptions{.strength = strength, .epsilonW = epsilonW, .guarded = guarded},
                    state);
                ASSERT_TRUE(fit.hasMap()) << strength << ", " << epsilonW;
                ASSERT_TRUE(fit.clipFromWorld.allFinite());
                for (const Vec2& q : state.region.liHull)
                    ASSERT_GT(1.0 + fit.liWarp.dot(q - fit.liCentre), 0.0);
            }
        }
}

RC_GTEST_PROP(Xpsm, IsGusevsAlgorithmMovedToTheCentre, ()) {
    // Steps 2 to 7 as printed, about the viewer, on the code's focus region; then faded and moved.
    const Scene scene = *anyScene();
    RC_PRE(scene.light.kind == LightKind::Directional);
    RC_PRE(scene.viewer.clipFromView(3, 3) == 0.0);
    FitState state;
    const XpsmOptions options = literal(2.0);
    const ShadowFit fit = fitMap(scene.problem(), options, state);
    if (!fit.hasMap()) return;
    const FocusRegion& region = state.region;
    const LightImage image(scene.light);
    const Vec2 viewer = image.project(image.lsFromPoint(eyeOf(scene.viewer)));
    const Vec2 along = image.lsFromDirection(forwardOf(scene.viewer)).head<2>();
    if (along.norm() < 1e-7) return; // its direction is rounding
    const Vec2 unitP = along.normalized();
    const double farDepth = region.vsReceiverFar;
    const double coef =
        options.strength / std::sqrt(std::max(region.vsReceiverNear, 1e-3 * farDepth) * farDepth);
    double minFocusRegionProj = Infinity;
    for (const Vec2& q : region.liHull)
        minFocusRegionProj = std::min(minFocusRegionProj, unitP.dot(q - viewer));
    const double maxLengthP = (options.epsilonW - 1.0) / minFocusRegionProj;
    double lengthP = coef / along.dot(unitP);
    if (maxLengthP > 0.0 && lengthP > maxLengthP) lengthP = maxLengthP;
    const double atCentre = 1.0 + lengthP * unitP.dot(region.liCentre - viewer);
    RC_ASSERT(atCentre > 0.0);
    const double t = std::min(along.norm() / 0.2, 1.0);
    Vec2 expected = t * t * (3.0 - 2.0 * t) * lengthP / atCentre * unitP;
    // The map's own safety, at two texels' thickness at most.
    double extent = 0.0;
    for (const Vec2& q : region.liHull)
        extent = std::max(extent, (q - region.liCentre).cwiseAbs().sum());
    Vec2 safest = expected;
    pullIntoSafeSet(region.liHull, region.liCentre,
                    4.0 * extent / std::max(scene.mapWidth, scene.mapHeight), safest);
    RC_LOG() << "warp " << fit.liWarp.transpose() << ", Gusev's " << expected.transpose()
             << ", safe " << safest.transpose() << "\n";
    if ((safest - expected).norm() > 0.0) {
        RC_ASSERT(fit.liWarp.norm() <= (1.0 + 1e-6) * expected.norm());
        RC_ASSERT(fit.liWarp.norm() >= (1.0 - 1e-6) * safest.norm());
    } else {
        RC_ASSERT((fit.liWarp - expected).norm() <= 1e-6 * expected.norm());
    }
}
