/// The formulas of Wimmer, Scherzer and Purgathofer, where the paper derives them.
#include "fit/technique/LiSPSM.h"

#include "fit/technique/Corridor.h"

#include "fit/focus/LightImage.h"
#include "fit/technique/Uniform.h"

#include <gtest/gtest.h>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// Thin, so that its depths are those of its image.
Scene thinCorridor(const Vec3& lightDirection) {
    return corridor(lightDirection, 0.01);
}

} // namespace

TEST(LiSPSM, ApexIsAtNOptWithTheLightAcrossTheView) {
    // γ = 90°: the denominator n_opt + d - z_n is zero at the depth z_n - n_opt.
    const double nOpt = NearDepth + std::sqrt(NearDepth * FarDepth);
    for (const double factor : {0.5, 1.0, 3.0}) {
        const Scene scene = thinCorridor(Vec3(0.0, -1.0, 0.0));
        FitState state;
        const ShadowFit fit =
            fitMap(scene.problem(), LiSPSMOptions{.distanceFactor = factor}, state);
        ASSERT_EQ(fit.reason, FitReason::None);
        const double n = factor * nOpt;
        for (const double depth : {NearDepth, 20.0, FarDepth})
            EXPECT_NEAR(denominatorAt(fit, depth) / denominatorAt(fit, NearDepth),
                        (n + depth - NearDepth) / n, 1e-9);
    }
}

TEST(LiSPSM, PerspectiveErrorIsAlikeNearAndFar) {
    // Texels along the view are dense as 1 / denominator², pixels across the view as 1 / depth
    // (§4): n_opt makes the product the same at both ends.
    const Scene scene = thinCorridor(Vec3(0.0, -1.0, 0.0));
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), LiSPSMOptions{}, state);
    const auto error = [&](double depth) {
        return std::pow(denominatorAt(fit, depth), 2.0) / depth;
    };
    EXPECT_NEAR(error(NearDepth) / error(FarDepth), 1.0, 1e-9);
    EXPECT_LT(error(std::sqrt(NearDepth * FarDepth)), error(NearDepth));
}

TEST(LiSPSM, EndsOfTheRegionFollowTheGeneralFormula) {
    // n_opt = (z_n + sqrt(z_n (z_n + d sin γ))) / sin γ, at any γ. With the light tilted, z_n is a
    // bound: at least the nearest receiver's depth, at most what the region's near end has.
    for (const double degrees : {20.0, 50.0, 90.0, 130.0, 160.0}) {
        const double angle = degrees * Degree;
        const Scene scene = thinCorridor(Vec3(0.0, -std::sin(angle), -std::cos(angle)));
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), LiSPSMOptions{}, state);
        ASSERT_EQ(fit.reason, FitReason::None) << degrees;
        const LightImage image(scene.light);
        const Vec2 along = image.lsFromDirection(Vec3(0.0, 0.0, -1.0)).head<2>();
        const Vec2 direction = along.normalized();
        EXPECT_NEAR(along.norm(), std::sin(angle), 1e-12);
        EXPECT_NEAR(cross(direction, fit.liWarp), 0.0, 1e-12);
        const double top = -support(state.region.liHull, -direction);
        const double d = support(state.region.liHull, direction) - top;
        const auto denominator = [&](double s) {
            return 1.0 + fit.liWarp.dot(direction) * (s - direction.dot(fit.liCentre));
        };
        const double ratio = denominator(top + d) / denominator(top);
        const double sine = std::sin(angle);
        const auto expected = [&](double zn) {
            const double n = (zn + std::sqrt(zn * (zn + d * sine))) / sine;
            return (n + d) / n;
        };
        EXPECT_NEAR(ratio, expected(NearDepth), 1e-6) << degrees;
    }
}

TEST(LiSPSM, FadesAsTheLightTurnsIntoTheView) {
    double before = std::numeric_limits<double>::infinity();
    for (const double angle : {1e-1, 1e-2, 1e-4, 1e-8, 0.0}) {
        const Scene scene = thinCorridor(Vec3(0.0, -std::sin(angle), -std::cos(angle)));
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), LiSPSMOptions{}, state);
        EXPECT_EQ(fit.reason, FitReason::LightAlongView);
        EXPECT_LE(fit.liWarp.norm(), before);
        EXPECT_LE(fit.liWarp.norm(), angle / NearDepth);
        before = fit.liWarp.norm();
    }
}

TEST(LiSPSM, RegionIsNeverInFrontOfTheNearPlane) {
    // Whatever the light: nothing is left for the shared clamp to do.
    const bool holds = rc::check([] {
        const Scene scene = *anyScene();
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), LiSPSMOptions{}, state);
        RC_ASSERT(fit.reason != FitReason::WarpClamped || isLostInRounding(scene, state));
    });
    EXPECT_TRUE(holds);
}

TEST(LiSPSM, OfALampAcrossAGroundBalancesTheGroundsDepths) {
    // The lamp hangs over the ground and shines straight down: the light image is a scaled ground.
    Scene scene = thinCorridor(Vec3(0.0, -1.0, 0.0));
    scene.light.kind = LightKind::Spot;
    scene.light.wsPosition = Vec3(0.0, 40.0, -25.0);
    scene.light.outerHalfAngle = 60.0 * Degree;
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), LiSPSMOptions{}, state);
    ASSERT_EQ(fit.reason, FitReason::None);
    EXPECT_NEAR(denominatorAt(fit, FarDepth) / denominatorAt(fit, NearDepth),
                std::sqrt(FarDepth / NearDepth), 0.01);
}

TEST(LiSPSM, OrthographicViewerHasAUniformMap) {
    Scene scene = outdoors();
    scene.viewer.clipFromView = orthographic(20.0, 20.0, 0.1, 100.0);
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), LiSPSMOptions{}, state);
    EXPECT_EQ(fit.reason, FitReason::None);
    EXPECT_EQ(fit.liWarp, Vec2::Zero());
}
