/// Chong's promises: a pixel of the plane is a texel, and what has no place in the map is known.
#include "fit/technique/PlaneOptimal.h"

#include "fit/Oracle.h"
#include "fit/Trials.h"

#include "fit/geometry/Polygon2.h"
#include "fit/problem/TexelInPixels.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

constexpr double Ground = -2.0;
const PlaneOptimalOptions Exact = {.wsPlane = Vec4(0.0, 1.0, 0.0, -Ground), .exact = true};
const PlaneOptimalOptions Clamped = {.wsPlane = Vec4(0.0, 1.0, 0.0, -Ground), .exact = false};

/// A ground, one bar over it, and a viewer that looks down on both through a map-sized viewport.
Scene table(const Vec3& lightDirection) {
    Scene scene;
    scene.size = 10.0;
    scene.mapWidth = 640;
    scene.mapHeight = 480;
    scene.viewer.viewFromWorld = lookAlong(Vec3::Zero(), Vec3(0.1, -0.5, -1.0));
    scene.viewer.clipFromView = perspective(50.0 * Degree, 4.0 / 3.0, 0.1, 100.0);
    scene.light.wsDirection = lightDirection;
    scene.receivers.add({Vec3(0.0, Ground, 0.0), Vec3(50.0, 0.0, 50.0)});
    scene.casters.add({Vec3(0.3, Ground + 0.3, -4.0), Vec3(0.5, 0.05, 0.2)});
    return scene;
}

struct HardCase {
    const char* name;
    Scene scene;
};

void PrintTo(const HardCase& hard, std::ostream* out) {
    *out << hard.name;
}

std::vector<HardCase> hardCases() {
    Scene lamp = table(Vec3(0.2, -1.0, 0.1));
    lamp.light.kind = LightKind::Spot;
    lamp.light.wsPosition = Vec3(-1.0, 3.0, -5.0);
    lamp.light.outerHalfAngle = 60.0 * Degree;
    Scene behind = lamp;
    behind.light.wsPosition = Vec3(1.0, 4.0, 6.0);
    behind.light.wsDirection = Vec3(0.0, -0.5, -1.0);
    Scene mirrored = table(Vec3(0.8, -1.0, 0.3));
    mirrored.viewer.viewFromWorld =
        Vec4(-1.0, 1.0, 1.0, 1.0).asDiagonal() * mirrored.viewer.viewFromWorld;
    Scene orthographicViewer = table(Vec3(0.8, -1.0, 0.3));
    orthographicViewer.viewer.clipFromView = orthographic(4.0, 3.0, 0.1, 100.0);
    return {{"SideLight", table(Vec3(0.8, -1.0, 0.3))},
            {"DuelingFrusta", table(Vec3(-0.1, -0.2, 1.0))},
            {"SunBehind", table(Vec3(0.1, -0.25, -1.0))},
            {"Lamp", lamp},
            {"LampBehindTheViewer", behind},
            {"MirroredViewer", mirrored},
            {"OrthographicViewer", orthographicViewer}};
}

class PlaneOptimal : public testing::TestWithParam<HardCase> {};

} // namespace

INSTANTIATE_TEST_SUITE_P(, PlaneOptimal, testing::ValuesIn(hardCases()), ByName{});

TEST_P(PlaneOptimal, APixelOfThePlaneIsATexel) {
    const Scene& scene = GetParam().scene;
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), Exact, state);
    ASSERT_EQ(fit.reason, FitReason::None);
    const Mat4 viewClip = scene.viewer.clipFromView * scene.viewer.viewFromWorld;
    const bool mirrored = scene.viewer.viewFromWorld.determinant() < 0.0;
    Dice dice(3);
    const auto points = shadowedPoints(scene, dice, 200);
    ASSERT_GT(points.size(), 20U);
    for (const ShadowedPoint& point : points) {
        const Vec3& x = point.wsReceiver;
        ASSERT_NEAR(x.y(), Ground, 1e-9);
        const Vec4 clip = clipOf(fit.clipFromWorld, x);
        EXPECT_GT(clip.w(), 0.0);
        EXPECT_LE(std::abs(clip.z()), clip.w());
        Vec2 pixel = texelOf(viewClip, scene, x);
        if (mirrored) pixel.x() = scene.mapWidth - pixel.x();
        EXPECT_LT((texelOf(fit.clipFromWorld, scene, x) - pixel).norm(), 1e-6);
        EXPECT_LT((texelOf(fit.clipFromWorld, scene, point.wsOccluder) - pixel).norm(), 1e-6);

        const Vec2 size(scene.mapWidth, scene.mapHeight);
        const auto m = texelInPixels(fit, size, scene.viewer, size, x, Vec3::UnitY());
        EXPECT_NEAR(m.value_or(0.0), 1.0, 1e-3);
        EXPECT_GE(servedMargin(fit, x), 0.0);
    }
}

TEST_P(PlaneOptimal, RowsAreChongsMatrix) {
    const Scene& scene = GetParam().scene;
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), Exact, state);
    const Vec4 light = homogeneousLight(scene.light);
    const Vec4 plane(0.0, 1.0, 0.0, -Ground);
    Mat4 expected = scene.viewer.clipFromView * scene.viewer.viewFromWorld *
                    (plane.dot(light) * Mat4::Identity() - light * plane.transpose());
    if (scene.viewer.viewFromWorld.determinant() < 0.0) expected.row(0) *= -1.0;
    expected *= fit.clipFromWorld.row(3).norm() / expected.row(3).norm();
    for (const int row : {0, 1, 3})
        EXPECT_LT((fit.clipFromWorld.row(row) - expected.row(row)).norm(),
                  1e-9 * expected.row(row).norm());
}

TEST_P(PlaneOptimal, ClampedServesEverything) {
    const Scene& scene = GetParam().scene;
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), Clamped, state);
    EXPECT_LE(fit.reason, FitReason::WarpClamped);
    EXPECT_EQ(fit.servedCount, 0U);
    if (fit.reason != FitReason::None) return;
    // Unclamped, its row w is the picture's: as the depth on the plane, in the viewer's clip space.
    const Mat4 viewClip = scene.viewer.clipFromView * scene.viewer.viewFromWorld;
    const Vec3 a(0.0, Ground, -4.0);
    const Vec3 b(1.0, Ground, -8.0);
    EXPECT_NEAR(clipOf(fit.clipFromWorld, a).w() / clipOf(fit.clipFromWorld, b).w(),
                clipOf(viewClip, a).w() / clipOf(viewClip, b).w(), 1e-9);
}

TEST(PlaneOptimalExact, SaysWhatItCannotServe) {
    // Chong's Figure 2: whatever is seen and shadowed is in the map, or outside of a half space.
    std::size_t served = 0;
    std::size_t refused = 0;
    const bool holds = rc::check([&] {
        const Scene scene = *anyScene();
        Dice dice(*anySeed());
        PlaneOptimalOptions options = groundOf(scene.problem());
        options.exact = true;
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), options, state);
        RC_LOG() << "reason: " << toString(fit.reason) << "\n";
        if (!fit.hasMap()) return;
        RC_ASSERT(fit.clipFromWorld.allFinite());
        if (fit.servedCount == 0) {
            RC_ASSERT(fit.reason == FitReason::PlaneCannotServe);
            RC_ASSERT(fit.liWarp.isZero(0.0));
        }
        // Beyond rounding, relative to the distances that half spaces are measured over.
        constexpr double Rounding = 1e-9;
        for (const ShadowedPoint& point : shadowedPoints(scene, dice, 50)) {
            const Vec3& x = point.wsReceiver;
            const double margin = servedMargin(fit, x);
            if (std::abs(margin) < Rounding * (x.norm() + scene.size)) continue;
            const Vec4 clip = clipOf(fit.clipFromWorld, x);
            const bool inMap = clip.w() > 0.0 && clip.head<2>().cwiseAbs().maxCoeff() <= clip.w();
            RC_LOG() << "receiver " << x.transpose() << " clip " << clip.transpose() << "\n";
            RC_ASSERT(inMap == (margin > 0.0));
            if (inMap) {
                ++served;
                RC_ASSERT(std::abs(clip.z()) <= (1.0 + Rounding) * clip.w());
            } else {
                ++refused;
                RC_ASSERT(fit.reason == FitReason::PlaneCannotServe);
            }
        }
    });
    EXPECT_TRUE(holds);
    EXPECT_GT(served, 100U);
    EXPECT_GT(refused, 100U);
}

TEST(PlaneOptimalExact, HasNoHiddenUnit) {
    const bool holds = rc::check([] {
        const Scene scene = *anyScene();
        PlaneOptimalOptions options = groundOf(scene.problem());
        options.exact = true;
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), options, state);
        for (const double factor : {1024.0, 1.0 / 1024.0}) {
            const Scene other = scaled(scene, factor);
            PlaneOptimalOptions moved = options;
            moved.wsPlane.w() *= factor;
            FitState otherState;
            const ShadowFit same = fitMap(other.problem(), moved, otherState);
            RC_ASSERT(same.reason == fit.reason);
            RC_ASSERT(same.servedCount == fit.servedCount);
        }
    });
    EXPECT_TRUE(holds);
}

TEST(PlaneOptimalExact, UniformWhereThePlaneIsNotSeen) {
    const auto expectUniform = [](const Scene& scene, const PlaneOptimalOptions& options) {
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), options, state);
        EXPECT_EQ(fit.reason, FitReason::PlaneCannotServe);
        EXPECT_EQ(fit.servedCount, 0U);
        EXPECT_EQ(fit.liWarp, Vec2::Zero());
    };
    const auto plane = [](const Vec3& normal, double offset) {
        PlaneOptimalOptions options{.exact = true};
        options.wsPlane << normal, offset;
        return options;
    };
    const Scene scene = table(Vec3(1.0, -1.0, 0.0));
    expectUniform(scene, plane(Vec3(1.0, 1.0, 0.0), 5.0));   // the light is in the plane
    expectUniform(scene, plane(Vec3::UnitY(), 0.0));         // the viewer is
    expectUniform(scene, plane(Vec3::UnitY(), -1.0));        // the viewer is below, the light above
    expectUniform(scene, plane(Vec3(0.0, 0.0, -1.0), -1e3)); // nothing of it is in view
    expectUniform(scene, plane(Vec3::Zero(), 1.0));
    expectUniform(scene, plane(Vec3(NaN, 1.0, 0.0), 1.0));
    expectUniform(scene, plane(Vec3::UnitY(), Infinity));
    expectUniform(scene, plane(Vec3::UnitY(), NaN));
}

TEST(PlaneOptimalClamped, FadesAsTheLightTurnsIntoThePlane) {
    for (const double elevation : {3e-2, 1e-3, 1e-6, 0.0, -1e-6, -1e-3}) {
        Scene scene = table(Vec3(1.0, -elevation, 0.0));
        scene.receivers.add({Vec3(0.5, Ground + 0.5, -5.0), Vec3(0.3, 0.5, 0.3)});
        scene.casters.add({Vec3(-1.0, Ground + 0.5, -5.0), Vec3(0.3, 0.5, 0.3)});
        scene.casters.add({Vec3(2.0, Ground + 0.5, -5.0), Vec3(0.3, 0.5, 0.3)});
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), Clamped, state);
        EXPECT_EQ(fit.reason, FitReason::PlaneCannotServe) << elevation;
        EXPECT_LE(fit.liWarp.norm(), 10.0 * std::pow(std::abs(elevation) / 0.05, 2.0)) << elevation;
    }
}
