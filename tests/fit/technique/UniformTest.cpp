#include "fit/technique/Uniform.h"

#include "fit/Problems.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

using namespace Lixel;
using namespace Lixel::Test;

TEST(Uniform, HasNoWarp) {
    const Scene scene = outdoors();
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), UniformOptions{}, state);
    EXPECT_EQ(fit.reason, FitReason::None);
    EXPECT_EQ(fit.liWarp, Vec2::Zero());
    EXPECT_EQ(fit.clipFromWorld.row(3), Vec4(0.0, 0.0, 0.0, 1.0).transpose());
}

TEST(Uniform, TexelsAreOfOneSizeAcrossTheLight) {
    const Scene scene = outdoors();
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), UniformOptions{}, state);
    const Vec3 right = fit.lsFromWs.row(0).transpose();
    const Vec3 up = fit.lsFromWs.row(1).transpose();
    Dice dice(5);
    const auto step = [&](const Vec3& x, const Vec3& d) {
        return Vec2(texelOf(fit.clipFromWorld, scene, x + d) -
                    texelOf(fit.clipFromWorld, scene, x));
    };
    const Vec2 stepRight = step(Vec3::Zero(), right);
    const Vec2 stepUp = step(Vec3::Zero(), up);
    for (int i = 0; i < 20; ++i) {
        const Vec3 x = 20.0 * dice.cube();
        EXPECT_LT((step(x, right) - stepRight).norm(), 1e-9 * stepRight.norm());
        EXPECT_LT((step(x, up) - stepUp).norm(), 1e-9 * stepUp.norm());
    }
    // Rectangular texels: the rows are orthogonal.
    EXPECT_NEAR(fit.clipFromWorld.row(0).head<3>().dot(fit.clipFromWorld.row(1).head<3>()), 0.0,
                1e-15);
}

TEST(Uniform, FillsTheMapWithARectangularShadow) {
    // The sun straight down on a box of 4 x 2 over a ground: its footprint fills the map.
    Scene scene;
    scene.viewer.viewFromWorld =
        lookAlong(Vec3(0.0, 20.0, 0.0), -Vec3::UnitY(), Vec3(0.0, 0.0, -1.0));
    scene.viewer.clipFromView = perspective(1.0, 1.0, 0.1, 100.0);
    scene.receivers.add({Vec3::Zero(), Vec3(100.0, 0.0, 100.0)});
    scene.casters.add({Vec3(1.0, 2.0, 0.5), Vec3(2.0, 0.5, 1.0)});
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), UniformOptions{}, state);
    ASSERT_EQ(fit.reason, FitReason::None);
    // And what rounding of positions to float needs, here less than a thousandth of a texel.
    const double border = scene.filterRadius + 1.0 + 1.0 / 64.0;
    constexpr double PositionRounding = 1e-3;
    double least = 1e9;
    double greatest = -1e9;
    for (const double x : {-1.0, 3.0})
        for (const double z : {-0.5, 1.5}) {
            const Vec2 texel = texelOf(fit.clipFromWorld, scene, Vec3(x, 0.0, z));
            least = std::min(least, texel.minCoeff());
            greatest = std::max(greatest, texel.maxCoeff());
            for (const double t : texel)
                EXPECT_NEAR(std::min(t, 1024.0 - t), border, PositionRounding);
        }
    EXPECT_NEAR(least, border, PositionRounding);
    EXPECT_GE(least, border - 1e-9);
    EXPECT_NEAR(greatest, 1024.0 - border, PositionRounding);
    EXPECT_LE(greatest, 1024.0 - border + 1e-9);
}
