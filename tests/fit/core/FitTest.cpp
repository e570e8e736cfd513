/// What every map has, in closed form: its depth (Gusev 2007, §3.10) and Kozlov's texel matrix.
#include "fit/Oracle.h"
#include "fit/Trials.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <numbers>
#include <set>
#include <string>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// One fit by name: technique and kind of light.
struct Case {
    std::string name;
    Trial trial;
    LightKind kind;
};

void PrintTo(const Case& fit, std::ostream* out) {
    *out << fit.name;
}

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const Trial& trial : trials()) {
        all.push_back({std::string(trial.name) + "Sun", trial, LightKind::Directional});
        all.push_back({std::string(trial.name) + "Spot", trial, LightKind::Spot});
    }
    return all;
}

class Fit : public testing::TestWithParam<Case> {
protected:
    Fit() : mScene(outdoors()) {
        mScene.light.kind = GetParam().kind;
        mScene.light.wsPosition = Vec3(-8.0, 12.0, -12.0);
    }
    ShadowFit fit() { return GetParam().trial.fit(mScene.problem(), mState); }

    Scene mScene;
    FitState mState;
};

} // namespace

INSTANTIATE_TEST_SUITE_P(EveryTechnique, Fit, testing::ValuesIn(cases()), ByName{});

TEST_P(Fit, BiasAlongTheLightChangesDepthByTheSameAmountEverywhere) {
    // Gusev 2007, §3.10: a point moved by `bias` along the light's axis, whatever the warp.
    const ShadowFit map = fit();
    ASSERT_TRUE(map.hasMap()) << map.reason;
    const Vec3 axis = mScene.light.wsDirection.normalized();
    Dice dice(3);
    for (int i = 0; i < 100; ++i) {
        const Vec3 x = 20.0 * dice.cube();
        const double bias = dice.in(-1.0, 1.0);
        const auto stored = [&](const Vec3& p) {
            return map.depthScale * clipOf(map.clipFromWorld, p).z() + map.depthOffset;
        };
        ASSERT_NEAR(stored(x + bias * axis) - stored(x), bias * map.depthPerWorldUnit, 1e-12);
    }
}

TEST_P(Fit, StoredDepthIsZeroAtTheNearestReceiverAndOneAtTheFarthest) {
    const ShadowFit map = fit();
    ASSERT_TRUE(map.hasMap()) << map.reason;
    const Vec3 axis = mScene.light.wsDirection.normalized();
    for (const auto& [distance, expected] :
         {std::pair(map.lsNear, 0.0), std::pair(map.lsFar, 1.0)}) {
        const Vec4 clip = clipOf(map.clipFromWorld, map.wsEye + distance * axis);
        EXPECT_NEAR(map.depthScale * clip.z() + map.depthOffset, expected, 1e-9);
    }
    // The range is that of the receivers, within a thousandth of the region's size.
    EXPECT_LE(map.lsNear, mState.region.lsReceiverNear);
    EXPECT_GE(map.lsFar, mState.region.lsReceiverFar);
    const double range = mState.region.lsReceiverFar - mState.region.lsReceiverNear;
    EXPECT_LT(map.lsFar - map.lsNear, 1.01 * range);
}

TEST_P(Fit, DepthIsStretchedOverCastersWithoutDepthClamp) {
    mScene.casters.add(
        {mScene.light.kind == LightKind::Spot
             ? Vec3(mScene.light.wsPosition + 2.0 * mScene.light.wsDirection.normalized())
             : Vec3(Vec3(0.0, -2.0, -16.0) - 500.0 * mScene.light.wsDirection),
         Vec3::Constant(0.1)});
    const ShadowFit clampedMap = fit();
    mScene.depthClamp = false;
    const ShadowFit map = fit();
    ASSERT_TRUE(map.hasMap()) << map.reason;
    EXPECT_LT(map.lsNear, clampedMap.lsNear);
    EXPECT_LE(map.lsNear, mState.region.lsCasterNear);
}

TEST_P(Fit, RowsXYAndWVanishOnTheLight) {
    // The one idea: what annihilates the light maps rays to points.
    const ShadowFit map = fit();
    ASSERT_TRUE(map.hasMap()) << map.reason;
    const Vec3& direction = mScene.light.wsDirection;
    const Vec3& position = mScene.light.wsPosition;
    const Vec4 light = mScene.light.kind == LightKind::Directional
                           ? Vec4(direction.x(), direction.y(), direction.z(), 0.0)
                           : Vec4(position.x(), position.y(), position.z(), 1.0);
    const Vec4 image = map.clipFromWorld * light;
    EXPECT_NEAR(image.x(), 0.0, 1e-12);
    EXPECT_NEAR(image.y(), 0.0, 1e-12);
    EXPECT_NEAR(image.w(), 0.0, 1e-12);
    EXPECT_GT(std::abs(image.z()), 1e-6);
}

TEST_P(Fit, TexelMatrixMovesAPointByOneTexelInBothAxes) {
    mScene.mapHeight = 512;
    const ShadowFit map = fit();
    ASSERT_TRUE(map.hasMap()) << map.reason;
    const Mat4 texel = texelMatrix(map, mScene.mapWidth, mScene.mapHeight);
    Dice dice(4);
    const auto points = shadowedPoints(mScene, dice, 50);
    ASSERT_FALSE(points.empty());
    for (const ShadowedPoint& point : points) {
        const Vec3& x = point.wsReceiver;
        const Vec3 y = (texel * x.homogeneous()).hnormalized();
        const Vec2 moved =
            texelOf(map.clipFromWorld, mScene, y) - texelOf(map.clipFromWorld, mScene, x);
        ASSERT_NEAR(moved.x(), 1.0, 1e-6);
        ASSERT_NEAR(moved.y(), 1.0, 1e-6);
        const Vec4 a = clipOf(map.clipFromWorld, x);
        const Vec4 b = clipOf(map.clipFromWorld, y);
        ASSERT_NEAR(b.z() / b.w(), a.z() / a.w(), 1e-9);
        // Kozlov's length of a texel, against the finite difference of the inverse map.
        const Vec3 ndc = a.hnormalized();
        constexpr double Part = 1e-3;
        const Vec3 shifted = ndc + Part * Vec3(2.0 / mScene.mapWidth, 2.0 / mScene.mapHeight, 0.0);
        const Vec3 z = (map.clipFromWorld.inverse() * shifted.homogeneous()).hnormalized();
        ASSERT_NEAR((y - x).norm(), (z - x).norm() / Part, 0.05 * (y - x).norm());
    }
}

TEST_P(Fit, FillsTheMap) {
    mScene.filterRadius = 0.0;
    const ShadowFit map = fit();
    ASSERT_TRUE(map.hasMap()) << map.reason;
    if (map.servedCount > 0) return; // given whole, not fitted to the region
    Vec2 least = Vec2::Constant(1e9);
    Vec2 greatest = -least;
    for (const Vec2& q : mState.region.liHull) {
        const Vec4 clip = map.clipFromLight * Vec4(q.x(), q.y(), map.directional ? 0.0 : -1.0, 1.0);
        least = least.cwiseMin(clip.hnormalized().head<2>());
        greatest = greatest.cwiseMax(clip.hnormalized().head<2>());
    }
    // One texel and a rounding guard of 1/64 of 1024 stay free on each side, and what rounding of
    // positions to float needs: at these sizes less than a hundredth of a texel.
    const double border = (1.0 + 1.0 / 64.0) * 2.0 / 1024.0;
    constexpr double PositionRounding = 0.01 * 2.0 / 1024.0;
    for (const Vec2& free : {Vec2(least + Vec2::Ones()), Vec2(Vec2::Ones() - greatest)})
        for (const double side : {free.x(), free.y()}) {
            EXPECT_GE(side, border - 1e-9);
            EXPECT_LE(side, border + PositionRounding);
        }
}

TEST_P(Fit, OfAPointReceiverExists) {
    // A particle in the shadow of a box: its region is one ray.
    mScene.receivers.clear();
    const Vec3 lit =
        mScene.light.kind == LightKind::Spot
            ? Vec3(mScene.light.wsPosition + 15.0 * mScene.light.wsDirection.normalized())
            : Vec3(0.0, 0.0, -10.0);
    mScene.viewer.viewFromWorld = lookAlong(lit + Vec3(3.0, 4.0, 5.0), Vec3(-3.0, -4.0, -5.0));
    mScene.receivers.add({lit, Vec3::Zero()});
    mScene.casters.add({lit - 2.0 * mScene.light.wsDirection.normalized(), Vec3::Ones()});
    const ShadowFit map = fit();
    ASSERT_TRUE(map.hasMap()) << map.reason;
    EXPECT_TRUE(map.clipFromWorld.allFinite());
    const Vec2 texel = texelOf(roundedToFloat(map.clipFromWorld), mScene, lit);
    EXPECT_NEAR(texel.x(), 512.0, 509.0);
    EXPECT_NEAR(texel.y(), 512.0, 509.0);
}

TEST(FitOfAPoint, AtTheOriginsDepthExists) {
    // Its light-space depth is 0, and so is its extent: nothing gives the depth range a scale.
    for (const Trial& trial : trials()) {
        Scene scene;
        scene.viewer.clipFromView = perspective(1.0, 1.0, 0.1, 100.0);
        scene.light.wsDirection = Vec3(0.0, -1.0, 0.0);
        scene.receivers.add({Vec3(0.0, 0.0, -5.0), Vec3::Zero()});
        scene.casters.add({Vec3(0.0, 2.0, -5.0), Vec3::Ones()});
        Dice dice(1);
        ASSERT_FALSE(shadowedPoints(scene, dice, 50).empty());
        FitState state;
        const ShadowFit map = trial.fit(scene.problem(), state);
        EXPECT_TRUE(map.hasMap()) << trial.name << ": " << map.reason;
    }
}

TEST(FitOfAViewer, DoesNotDependOnHowItStoresDepth) {
    // Reversed Z, with depths from 1 at the near plane to 0 or -1 at the far one, and the far plane
    // at infinity too: what is seen is the same.
    for (const Trial& trial : trials()) {
        Scene scene = outdoors();
        FitState state;
        const ShadowFit usual = trial.fit(scene.problem(), state);
        ASSERT_TRUE(usual.hasMap());
        scene.viewer.clipFromView.row(2) *= -1.0;
        FitState reversedState;
        const ShadowFit reversed = trial.fit(scene.problem(), reversedState);
        EXPECT_LT((usual.clipFromWorld - reversed.clipFromWorld).norm(),
                  1e-9 * usual.clipFromWorld.norm())
            << trial.name;

        // z = near everywhere, in the range from 0 to 1.
        scene.viewer.clipFromView.row(2) << 0.0, 0.0, 0.0, 0.1;
        scene.viewer.shadowDistance = 150.0;
        FitState endlessState;
        const ShadowFit endless = trial.fit(scene.problem(), endlessState);
        ASSERT_TRUE(endless.hasMap()) << trial.name;
        Dice dice(4);
        for (const ShadowedPoint& point : shadowedPoints(scene, dice, 100)) {
            const Vec2 texel = texelOf(endless.clipFromWorld, scene, point.wsReceiver);
            EXPECT_GE(texel.minCoeff(), scene.filterRadius + 1.0) << trial.name;
            EXPECT_LE(texel.maxCoeff(), 1024.0 - scene.filterRadius - 1.0) << trial.name;
        }
    }
}

TEST(FocusPolygon, ReachesHardlyBeyondAWarpedMap) {
    // A ring of casters, whose region has more edges than the polygon may have. At the near
    // end of the warp a large part of the map is a small area of the light image.
    Scene scene = outdoors();
    for (int i = 0; i < 80; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 80;
        scene.addBody({Vec3(9.0 * std::sin(angle), -1.8, -20.0 - 16.5 * std::cos(angle)),
                       Vec3(0.02, 0.2, 0.02)});
    }
    for (const char* const name : {"XPSM", "Optimal", "LiSPSM"}) {
        FitState state;
        const ShadowFit fit = trialNamed(name).fit(scene.problem(), state);
        ASSERT_TRUE(fit.hasMap());
        EXPECT_GT(state.region.liHull.size(), 16U);
        double beyond = 0.0;
        for (const Vec2& q : fit.liFocus.span()) {
            const Vec3 ws = fit.wsEye + fit.lsFromWs.transpose() * Vec3(q.x(), q.y(), 0.0);
            beyond = std::max(beyond, -insideBorder(texelOf(fit.clipFromWorld, scene, ws), scene));
        }
        // So far do the corners of a regular polygon reach beyond a circle as wide as the map.
        const double corner = 1.0 / std::cos(std::numbers::pi / FocusPolygon::Capacity) - 1.0;
        EXPECT_LT(beyond, corner * scene.mapWidth / 2.0) << name;
    }
}

TEST(FitReasonNames, AreDistinctAndKnown) {
    std::set<std::string> names;
    for (int i = 0; i <= static_cast<int>(FitReason::TooFewMaps); ++i)
        names.insert(toString(static_cast<FitReason>(i)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(FitReason::TooFewMaps) + 1);
    EXPECT_EQ(names.count("unknown"), 0U);
    EXPECT_TRUE(hasMap(FitReason::WarpClamped));
    EXPECT_TRUE(hasMap(FitReason::UnboundedBody));
    EXPECT_FALSE(hasMap(FitReason::NoReceivers));
    EXPECT_FALSE(hasMap(FitReason::TooFewMaps));
}

TEST(TexelMatrix, WithoutAMapIsTheIdentity) {
    EXPECT_EQ(texelMatrix(ShadowFit{}, 1024, 1024), Mat4::Identity());
}
