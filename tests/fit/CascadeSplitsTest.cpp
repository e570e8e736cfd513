#include "fit/CascadeSplits.h"

#include "Oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

constexpr double Degree = std::numbers::pi / 180.0;

std::vector<double> splitsOf(const Scene& scene, int count, const CascadeOptions& options) {
    CascadeMemory memory;
    std::vector<double> splits;
    cascadeSplits(scene.problem(), count, options, memory, splits);
    return splits;
}

/// Two walls across the view at these depths, each with a caster before it, the nearer one in the
/// left half only.
Scene wallsAt(double nearer, double farther) {
    Scene scene;
    scene.viewer.clipFromView = perspective(60.0 * Degree, 1.0, 0.1, 1000.0);
    scene.light.wsDirection = Vec3(0.1, -0.2, -1.0);
    scene.receivers.add({Vec3(-nearer, 0.0, -nearer), Vec3(nearer, nearer, 0.0)});
    scene.receivers.add({Vec3(0.0, 0.0, -farther), Vec3(farther, farther, 0.0)});
    scene.casters.add({Vec3(0.0, 0.0, 5.0), Vec3(2000.0, 2000.0, 0.1)});
    return scene;
}

} // namespace

TEST(CascadeSplits, AreLogarithmicBetweenWhatIsSeen) {
    const std::vector<double> splits = splitsOf(wallsAt(2.0, 250.0), 3, {});
    ASSERT_EQ(splits.size(), 2U);
    EXPECT_NEAR(splits[0], 10.0, 1e-6);
    EXPECT_NEAR(splits[1], 50.0, 1e-6);
}

TEST(CascadeSplits, AreEqualWhereUniformityIsOne) {
    const std::vector<double> splits = splitsOf(wallsAt(10.0, 40.0), 3, {.uniformity = 1.0});
    ASSERT_EQ(splits.size(), 2U);
    EXPECT_NEAR(splits[0], 20.0, 1e-6);
    EXPECT_NEAR(splits[1], 30.0, 1e-6);
}

TEST(CascadeSplits, AreBetweenThePlanesWhereTheyDoNotFollow) {
    Scene scene = wallsAt(2.0, 250.0);
    const CascadeOptions fixed = {.uniformity = 0.0, .followReceivers = false};
    std::vector<double> splits = splitsOf(scene, 2, fixed);
    ASSERT_EQ(splits.size(), 1U);
    EXPECT_NEAR(splits[0], std::sqrt(0.1 * 1000.0), 1e-6); // near and far plane
    scene.viewer.shadowDistance = 40.0;
    splits = splitsOf(scene, 2, fixed);
    ASSERT_EQ(splits.size(), 1U);
    EXPECT_NEAR(splits[0], std::sqrt(0.1 * 40.0), 1e-6);
}

TEST(CascadeSplits, AreNoneWhereNothingIsToBeSplit) {
    EXPECT_TRUE(splitsOf(wallsAt(2.0, 250.0), 1, {}).empty());
    Scene empty = wallsAt(2.0, 250.0);
    empty.casters.clear();
    EXPECT_TRUE(splitsOf(empty, 3, {}).empty());
    Scene endless = wallsAt(2.0, 250.0);
    endless.viewer.clipFromView =
        perspective(60.0 * Degree, 1.0, 0.1, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(splitsOf(endless, 3, {.uniformity = 0.0, .followReceivers = false}).empty());
}

TEST(CascadeSplits, FollowLittleByLittleAndJumpAfterACut) {
    CascadeMemory memory;
    std::vector<double> splits;
    const auto split = [&](const Scene& scene) {
        cascadeSplits(scene.problem(), 2, {}, memory, splits);
        return splits.size() == 1 ? splits[0] : 0.0;
    };
    EXPECT_NEAR(split(wallsAt(2.0, 200.0)), 20.0, 1e-6);
    double last = 20.0;
    // The nearer wall is little of the region, which hardly changes.
    for (int i = 0; i < 1000; ++i) {
        const double next = split(wallsAt(3.0, 200.0));
        EXPECT_LE(std::abs(std::log(next / last)), 0.001);
        last = next;
    }
    EXPECT_NEAR(last, std::sqrt(600.0), 1e-6);
    EXPECT_NEAR(split(wallsAt(50.0, 200.0)), 100.0, 1e-6);
}

TEST(CascadeSplits, FollowFasterWhileTheViewerTurns) {
    const auto stepAfter = [](double angle) {
        CascadeMemory memory;
        std::vector<double> splits;
        cascadeSplits(wallsAt(2.0, 200.0).problem(), 2, {}, memory, splits);
        const double before = splits.at(0);
        Scene turned = wallsAt(3.0, 200.0);
        turned.viewer.viewFromWorld =
            lookAlong(Vec3::Zero(), Vec3(std::sin(angle), 0.0, -std::cos(angle)));
        cascadeSplits(turned.problem(), 2, {}, memory, splits);
        return std::log(splits.at(0) / before);
    };
    // One of the two ends moves.
    EXPECT_GT(stepAfter(0.01), 5.0 * stepAfter(1e-4));
    EXPECT_LT(stepAfter(1e-4), 0.001);
    EXPECT_GT(stepAfter(1e-4), 0.0);
}

TEST(CascadeSplits, AscendWhileTheyFollow) {
    CascadeMemory memory;
    std::vector<double> splits;
    cascadeSplits(wallsAt(10.0, 70.0).problem(), 3, {}, memory, splits);
    for (int i = 0; i < 30; ++i) {
        // What is far goes, and what stays is nearer than what was near.
        cascadeSplits(wallsAt(8.0, 8.5).problem(), 3, {}, memory, splits);
        ASSERT_EQ(splits.size(), 2U);
        EXPECT_LE(splits[0], splits[1]);
        EXPECT_LE(splits[1], 8.5 * 1.01);
    }
}

TEST(CascadeSplits, AscendForAnyScene) {
    std::size_t checked = 0;
    const bool holds = rc::check([&] {
        const Scene scene = *anyScene();
        Dice dice(*anySeed());
        const CascadeOptions options = {dice.in(0.0, 1.0), dice.chance(0.5)};
        const std::vector<double> splits = splitsOf(scene, 4, options);
        if (splits.empty()) return;
        RC_ASSERT(splits.size() == 3U);
        RC_ASSERT(splits[0] > 0.0);
        RC_ASSERT(splits[0] <= splits[1]);
        RC_ASSERT(splits[1] <= splits[2]);
        RC_ASSERT(std::isfinite(splits[2]));
        ++checked;
    });
    EXPECT_TRUE(holds);
    EXPECT_GT(checked, 100U);
}
