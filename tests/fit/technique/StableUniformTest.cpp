/** The stable form of the uniform map: texels stay where they are in the world. */
#include "fit/technique/Uniform.h"

#include "fit/Oracle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// A viewer somewhere in a large world, as OGRE hands it over: the matrix rounded to float, and all
/// positions relative to the viewer.
struct Walk {
    Scene scene;
    Vec3 wsEye;

    Walk(const Vec3& eye, double yaw, double pitch, const std::vector<Aabb>& world) : wsEye(eye) {
        const Vec3 forward(std::cos(pitch) * std::sin(yaw), std::sin(pitch),
                           -std::cos(pitch) * std::cos(yaw));
        scene.viewer.viewFromWorld = roundedToFloat(lookAlong(Vec3::Zero(), forward));
        scene.viewer.clipFromView =
            roundedToFloat(perspective(60.0 * Degree, 16.0 / 9.0, 0.1, 500.0));
        scene.viewer.shadowDistance = 60.0;
        scene.light.wsDirection = Vec3(0.4, -1.0, 0.3);
        for (const Aabb& box : world)
            scene.addBody({box.centre - eye, box.halfExtents});
    }
    ShadowProblem problem() const {
        ShadowProblem result = scene.problem();
        result.wsOrigin = wsEye;
        return result;
    }
    /// Texel of a point of the world by the matrix that the graphics card gets.
    Vec2 texel(const ShadowFit& fit, const Vec3& ws) const {
        return texelOf(roundedToFloat(fit.clipFromWorld), scene, ws - wsEye);
    }
};

void expectWholeTexels(const Vec3& start) {
    std::vector<Aabb> world;
    Dice dice(3);
    world.push_back({start + Vec3(0.0, -2.0, 0.0), Vec3(500.0, 0.1, 500.0)});
    for (int i = 0; i < 200; ++i)
        world.push_back({start + Vec3(dice.in(-200.0, 200.0), 0.0, dice.in(-200.0, 200.0)),
                         Vec3(dice.in(0.2, 2.0), 2.0, dice.in(0.2, 2.0))});
    FitState state;
    Walk before(start, 0.0, -0.1, world);
    ShadowFit fitBefore = fitMap(before.problem(), UniformOptions{.stable = true}, state);
    ASSERT_EQ(fitBefore.reason, FitReason::None);
    double worst = 0.0;
    double farthest = 0.0;
    for (int i = 1; i < 400; ++i) {
        const Vec3 eye = start + Vec3(0.31 * i, 0.2 * std::sin(0.1 * i), -0.17 * i);
        const Walk now(eye, 0.05 * i, -0.1 + 0.3 * std::sin(0.07 * i), world);
        const ShadowFit fit = fitMap(now.problem(), UniformOptions{.stable = true}, state);
        ASSERT_EQ(fit.reason, FitReason::None);
        for (int k = 0; k < 20; ++k) {
            const Vec3 ws = eye + 50.0 * dice.cube();
            const Vec2 step = now.texel(fit, ws) - before.texel(fitBefore, ws);
            worst = std::max(worst, (step - Vec2(step.array().round())).cwiseAbs().maxCoeff());
            farthest = std::max(farthest, step.norm());
        }
        before = now;
        fitBefore = fit;
    }
    EXPECT_LE(worst, 0.05);
    EXPECT_GT(farthest, 1.0); // the map did follow
    testing::Test::RecordProperty("worst_step_in_texels", std::to_string(worst));
}

} // namespace

TEST(StableUniform, WorldPointsMoveByWholeTexels) {
    expectWholeTexels(Vec3(3.0, 1.0, -7.0));
}

TEST(StableUniform, WorldPointsMoveByWholeTexelsFarFromTheOrigin) {
    expectWholeTexels(Vec3(1e6, 100.0, -2e6));
}

TEST(StableUniform, ServesEverythingInAnyScene) {
    std::size_t stable = 0;
    const bool holds = rc::check([&] {
        const Scene scene = *anyScene();
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), UniformOptions{.stable = true}, state);
        RC_ASSERT(fit.reason != FitReason::PlaneCannotServe);
        if (!fit.hasMap() || fit.reason == FitReason::ViewWithoutEnd) return;
        RC_ASSERT(fit.liWarp.norm() == 0.0);
        ++stable;
    });
    EXPECT_TRUE(holds);
    EXPECT_GT(stable, 100U);
}

TEST(StableUniform, ASpotsMapDoesNotDependOnTheViewer) {
    Scene scene = outdoors();
    scene.light.kind = LightKind::Spot;
    scene.light.wsPosition = Vec3(0.0, 12.0, -15.0);
    scene.light.outerHalfAngle = 50.0 * Degree;
    FitState state;
    const ShadowFit before = fitMap(scene.problem(), UniformOptions{.stable = true}, state);
    ASSERT_EQ(before.reason, FitReason::None);
    scene.viewer.viewFromWorld = lookAlong(Vec3(3.0, 1.0, -2.0), Vec3(-0.3, -0.4, -1.0));
    const ShadowFit after = fitMap(scene.problem(), UniformOptions{.stable = true}, state);
    ASSERT_EQ(after.reason, FitReason::None);
    Dice dice(2);
    for (int i = 0; i < 50; ++i) {
        const Vec3 ws = Vec3(0.0, 0.0, -15.0) + 5.0 * dice.cube();
        EXPECT_LT(
            (texelOf(before.clipFromWorld, scene, ws) - texelOf(after.clipFromWorld, scene, ws))
                .norm(),
            1e-6);
    }
}

TEST(StableUniform, AViewWithoutEndIsFocused) {
    Scene scene = outdoors();
    scene.viewer.clipFromView =
        perspective(60.0 * Degree, 1.5, 0.1, std::numeric_limits<double>::infinity());
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), UniformOptions{.stable = true}, state);
    EXPECT_EQ(fit.reason, FitReason::ViewWithoutEnd);
    EXPECT_EQ(fit.clipFromWorld, fitMap(scene.problem(), UniformOptions{}, state).clipFromWorld);
}
