#include "fit/technique/PostProjectiveCube.h"

#include "fit/Oracle.h"

#include "fit/focus/LightImage.h"
#include "fit/parts/LightPartition.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// Where the light ray of a point leaves the view: on the plane, by an intersection.
Vec3 exitOf(const ShadowPart& part, const ShadowLight& light, const Vec3& ws) {
    const Vec3 along = -towardsLight(light, ws);
    const Vec3 normal = part.wsExit.head<3>();
    const double distance = part.wsExit.dot(ws.homogeneous()) / -normal.dot(along);
    return ws + distance * along;
}

} // namespace

TEST(PostProjectiveCube, TheDenominatorIsTheDepthAtWhichTheRayLeavesTheView) {
    // Where the warp was not clamped, ratios of denominators are ratios of depths on the face.
    std::size_t compared = 0;
    for (const bool local : {false, true}) {
        Scene scene = outdoors();
        if (local) {
            scene.light.kind = LightKind::Spot;
            scene.light.wsPosition = Vec3(-3.0, 9.0, -12.0);
            scene.light.wsDirection = Vec3(0.2, -1.0, 0.1);
            scene.light.outerHalfAngle = 70.0 * Degree;
        }
        AimScratch scratch;
        const ShadowProblem whole = scene.problem();
        const LightPartition parts = facesOfView(scene.viewer, scene.light, scratch);
        Dice dice(11);
        const auto points = visiblePoints(scene, dice, 500);
        for (std::size_t i = 0; i < parts.count; ++i) {
            FitState state;
            const ShadowFit fit =
                fitMap(problemOf(whole, parts.parts[i]), CubeOptions{.slideBack = 0.0}, state);
            if (fit.reason != FitReason::None) continue;
            const LightImage image(scene.light);
            double ratio = 0.0;
            for (const Vec3& ws : points) {
                if (parts.serving(ws) != i || !shinesOn(scene.light, ws)) continue;
                const Vec3 exit = exitOf(parts.parts[i], scene.light, ws);
                const double depth = -(scene.viewer.viewFromWorld * exit.homogeneous()).z();
                const Vec3 ls = image.lsFromPoint(exit);
                // Along a ray of a spot, the covector grows with the distance from the light.
                const double along = local ? -ls.z() : 1.0;
                const double denominator =
                    along * (1.0 + fit.liWarp.dot(image.project(ls) - fit.liCentre));
                if (ratio == 0.0) ratio = denominator / depth;
                EXPECT_NEAR(denominator / depth / ratio, 1.0, 1e-6);
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 200U);
}

TEST(PostProjectiveCube, IsUniformWithoutAPart) {
    const Scene scene = outdoors();
    FitState state;
    EXPECT_EQ(fitMap(scene.problem(), CubeOptions{}, state).liWarp, Vec2::Zero());
}

TEST(PostProjectiveCube, IsUniformOnAFaceOfOneDepth) {
    // The sun shines into the far plane: all its rays leave there.
    Scene scene = outdoors();
    scene.viewer.viewFromWorld = lookAlong(Vec3::Zero(), Vec3(0.0, -1.0, -0.01), Vec3::UnitX());
    scene.light.wsDirection = forwardOf(scene.viewer);
    AimScratch scratch;
    const ShadowProblem whole = scene.problem();
    const LightPartition parts = facesOfView(scene.viewer, scene.light, scratch);
    ASSERT_EQ(parts.count, 1U);
    FitState state;
    const ShadowFit fit = fitMap(problemOf(whole, parts.parts[0]), CubeOptions{}, state);
    if (fit.hasMap()) {
        EXPECT_LT(fit.liWarp.norm(), 1e-9);
    }
}
