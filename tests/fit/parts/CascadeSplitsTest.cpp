#include "fit/parts/CascadeSplits.h"
#include "fit/parts/CascadeMemory.h"

#include "fit/Oracle.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

std::vector<double> splitsOf(const Scene& scene, std::size_t count, const CascadeOptions& options) {
    CascadeMemory memory;
    CascadeScratch scratch;
    std::vector<double> splits;
    cascadeSplits(scene.problem(), count, options, memory, scratch, splits);
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

/// Splits into two of one viewer, from frame to frame.
class Following {
public:
    /// @return where the two slices meet
    double split(const ShadowProblem& problem) {
        cascadeSplits(problem, 2, {}, mMemory, mScratch, mSplits);
        return mSplits.size() == 1 ? mSplits[0] : 0.0;
    }

private:
    CascadeMemory mMemory;
    CascadeScratch mScratch;
    std::vector<double> mSplits;
};

/// Of walls at depths 2 and 250, which stay where they are, what is seen lies between a depth and
/// 200.
double splitSeeing(Following& following, double nearest, const Vec3& wsOrigin = Vec3::Zero(),
                   double angle = 0.0) {
    Scene scene = wallsAt(2.0, 250.0);
    scene.viewer.viewFromWorld =
        lookAlong(Vec3::Zero(), Vec3(std::sin(angle), 0.0, -std::cos(angle)));
    ShadowProblem problem = scene.problem();
    const std::array<VisiblePoint, 2> points = {
        {{Vec3(-0.5, 0.0, -nearest), Vec3::UnitZ()}, {Vec3(1.0, 0.0, -200.0), Vec3::UnitZ()}}};
    problem.visiblePoints = points;
    problem.wsOrigin = wsOrigin;
    return following.split(problem);
}

/// By how much the logarithm of the split changes in a frame from which on less is near.
double stepAfter(const Vec3& wsMoved, double angle) {
    Following following;
    const double before = splitSeeing(following, 2.0);
    return std::log(splitSeeing(following, 3.0, wsMoved, angle) / before);
}

} // namespace

TEST(CascadeSplits, AreLogarithmicBetweenWhatIsSeen) {
    const std::vector<double> splits = splitsOf(wallsAt(2.0, 250.0), 3, {});
    ASSERT_EQ(splits.size(), 2U);
    EXPECT_NEAR(splits[0], 10.0, 1e-6);
    EXPECT_NEAR(splits[1], 50.0, 1e-6);
}

TEST(CascadeSplits, AreNotWhereAllThatIsSeenIs) {
    // A wall that the viewer faces: its points must not be divided by rounding.
    for (const double depth : {0.7, 10.0, 300.0}) {
        const Scene scene = wallsAt(depth, depth);
        for (const double uniformity : {0.0, 0.5, 1.0})
            for (const std::size_t count : {2U, 3U, 4U}) {
                const std::vector<double> splits =
                    splitsOf(scene, count, {.uniformity = uniformity});
                ASSERT_EQ(splits.size(), count - 1);
                for (const double split : splits)
                    EXPECT_GT(std::abs(split / depth - 1.0), 0x1p-13);
            }
    }
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

TEST(CascadeSplits, AreGivenOnes) {
    const Scene scene = wallsAt(2.0, 250.0); // the near plane is at 0.1
    const auto given = [&](std::size_t count, std::vector<double> depths) {
        return splitsOf(scene, count, {.vsSplitDepths = std::move(depths)});
    };
    using Depths = std::vector<double>;
    EXPECT_EQ(given(3, {0.1, 5.0, 20.0, 1000.0}), Depths({5.0, 20.0}));
    EXPECT_EQ(given(3, {5.0, 20.0}), Depths({5.0, 20.0}));
    EXPECT_EQ(given(4, {5.0, 20.0}), Depths({5.0, 20.0}));
    EXPECT_EQ(given(2, {5.0, 20.0}), Depths({5.0}));
    // The second map is the second slice's, though nothing is seen of the first.
    EXPECT_EQ(given(3, {0.05, 20.0}), Depths({0.05, 20.0}));
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

TEST(CascadeSplits, FollowLittleByLittleWhileNothingMoves) {
    Following following;
    double last = splitSeeing(following, 2.0);
    EXPECT_NEAR(last, 20.0, 1e-6);
    for (int i = 0; i < 1000; ++i) {
        const double next = splitSeeing(following, 3.0);
        EXPECT_LE(std::abs(std::log(next / last)), 0.0005);
        last = next;
    }
    EXPECT_NEAR(last, std::sqrt(600.0), 1e-6);
}

TEST(CascadeSplits, FollowFasterWhileTheViewerMoves) {
    const double still = stepAfter(Vec3::Zero(), 0.0);
    EXPECT_GT(still, 0.0);
    EXPECT_LT(stepAfter(Vec3::Zero(), 1e-4), 5.0 * still);
    EXPECT_GT(stepAfter(Vec3::Zero(), 0.01), 10.0 * still);
    EXPECT_GT(stepAfter(Vec3(0.0, 0.0, 0.02), 0.0), 10.0 * still);
    // Never so fast that edges jump.
    EXPECT_LE(stepAfter(Vec3::Zero(), 0.04), 0.05);
}

TEST(CascadeSplits, AreAsTheyAreSeenAfterACameraCut) {
    const double whole = std::log(3.0 / 2.0) / 2.0; // one of the two ends
    EXPECT_NEAR(stepAfter(Vec3(0.0, 10.0, 0.0), 0.0), whole, 1e-6);
    EXPECT_NEAR(stepAfter(Vec3::Zero(), 0.1), whole, 0.05);
    Following following;
    EXPECT_NEAR(splitSeeing(following, 2.0), 20.0, 1e-6);
    EXPECT_NEAR(splitSeeing(following, 4.5), 30.0, 1e-6); // more than twice as far
}

/// The viewer does not move, but what it sees does.
TEST(CascadeSplits, StayWithWhatComesNearer) {
    for (const double speed : {0.0005, 0.001, 0.002, 0.009}) {
        Following following;
        double last = following.split(wallsAt(40.0, 250.0).problem());
        for (double nearest = 40.0; nearest > 5.0; nearest *= 1.0 - speed) {
            const double split = following.split(wallsAt(nearest, 250.0).problem());
            EXPECT_LE(std::abs(std::log(split / last)), 2.0 * speed + 0.0005);
            EXPECT_NEAR(std::log(split / std::sqrt(nearest * 250.0)), 0.0, 0.05);
            last = split;
        }
    }
}

TEST(CascadeSplits, AscendWhileTheyFollow) {
    CascadeMemory memory;
    CascadeScratch scratch;
    std::vector<double> splits;
    cascadeSplits(wallsAt(10.0, 70.0).problem(), 3, {}, memory, scratch, splits);
    for (int i = 0; i < 30; ++i) {
        // What is far goes, and what stays is nearer than what was near.
        cascadeSplits(wallsAt(8.0, 8.5).problem(), 3, {}, memory, scratch, splits);
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
