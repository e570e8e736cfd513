/** Contract, 7: with the same bodies, turning the viewer or the light by 1e-4 rad changes ln m at
    points of the common focus region by at most 0.02. @see fit/problem/TexelInPixels.h for m
*/
#include "fit/Oracle.h"
#include "fit/Trials.h"

#include "fit/focus/FocusRegion.h"
#include "fit/focus/LightImage.h"
#include "fit/geometry/Polygon2.h"
#include "fit/parts/CascadeDivision.h"
#include "fit/parts/CascadeMemory.h"
#include "fit/problem/TexelInPixels.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <iomanip>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

constexpr double Step = 1e-4;
constexpr double MostChange = 0.02;
/// Nothing flatter to the view or the light is measured.
constexpr double LeastCosine = 0.05;
const Vec2 ScreenSize(1280.0, 720.0);

/// A point on a face of a receiver.
struct Sample {
    Vec3 ws;
    Vec3 normal;
};

/// ln m; none where the surface is nearly edge-on to the light or the viewer.
std::optional<double> logTexelInPixels(const Scene& scene, const ShadowFit& fit, const Sample& s) {
    const Vec3 toEye = (eyeOf(scene.viewer) - s.ws).normalized();
    if (s.normal.dot(toEye) < LeastCosine) return std::nullopt;
    if (s.normal.dot(towardsLight(scene.light, s.ws)) < LeastCosine) return std::nullopt;
    const auto m = texelInPixels(fit, Vec2(scene.mapWidth, scene.mapHeight), scene.viewer,
                                 ScreenSize, s.ws, s.normal);
    if (!m) return std::nullopt;
    return std::log(*m);
}

/// Whether the ray of a point is within the region that the map was fitted to.
bool covers(const Scene& scene, const FitState& state, const Vec3& ws) {
    const LightImage image(scene.light);
    const Vec3 ls = image.lsFromPoint(ws);
    if (!image.directional() && -ls.z() <= scene.light.nearDistance) return false;
    const Vec2 q = image.project(ls);
    const Polygon2& hull = state.region.liHull;
    for (std::size_t i = 0; i < hull.size(); ++i)
        if (cross(hull[(i + 1) % hull.size()] - hull[i], q - hull[i]) < 0.0) return false;
    return true;
}

std::vector<Sample> samplesOf(const Scene& scene, Dice& dice, std::size_t count) {
    std::vector<Sample> samples;
    const auto& boxes = scene.receivers.boxes();
    const Mat4 worldFromClip = (scene.viewer.clipFromView * scene.viewer.viewFromWorld).inverse();
    for (std::size_t i = 0; i < count; ++i) {
        const double x = dice.in(-1.0, 1.0);
        const double y = dice.in(-1.0, 1.0);
        const Vec3 begin = (worldFromClip * Vec4(x, y, -1.0, 1.0)).hnormalized();
        const Vec3 end = (worldFromClip * Vec4(x, y, 0.0, 1.0)).hnormalized();
        for (const Aabb& box : boxes) {
            const auto hit = rayInBox(box, begin, end - begin);
            if (!hit || hit->begin <= 0.0) continue;
            const Vec3 p = begin + hit->begin * (end - begin);
            if (!sees(scene.viewer, p)) continue;
            // The face that was hit: where the point is nearest to the surface.
            Eigen::Index axis = 0;
            ((p - box.centre).cwiseAbs() - box.halfExtents).maxCoeff(&axis);
            Vec3 normal = Vec3::Zero();
            normal[axis] = std::copysign(1.0, (begin - box.centre)[axis]);
            samples.push_back({p, normal});
        }
    }
    return samples;
}

struct Change {
    double greatest = 0.0;
    Vec3 ws = Vec3::Zero();
    std::size_t measured = 0;
};

/// The greatest change of ln m over samples that both maps cover.
Change changeBetween(const Scene& a, const ShadowFit& fitA, const FitState& stateA, const Scene& b,
                     const ShadowFit& fitB, const FitState& stateB,
                     const std::vector<Sample>& samples) {
    Change change;
    for (const Sample& s : samples) {
        if (!covers(a, stateA, s.ws) || !covers(b, stateB, s.ws) || !sees(b.viewer, s.ws)) continue;
        const auto before = logTexelInPixels(a, fitA, s);
        const auto after = logTexelInPixels(b, fitB, s);
        if (!before || !after) continue;
        ++change.measured;
        if (std::abs(*after - *before) <= change.greatest) continue;
        change.greatest = std::abs(*after - *before);
        change.ws = s.ws;
    }
    return change;
}

/** Fits along a path of scenes, with the state carried over, and gives the greatest change from
    one to the next.

    @param scene gives the i-th scene of the path.
*/
template <typename ScenePath>
void expectSteadyPath(const Trial& trial, int steps, const ScenePath& path) {
    FitState state;
    Scene before = path(0);
    ShadowFit fitBefore = trial.fit(before.problem(), state);
    ASSERT_TRUE(fitBefore.hasMap());
    FitState stateBefore = state;
    Change worst;
    int worstStep = 0;
    std::size_t measured = 0;
    int violations = 0;
    Dice dice(7);
    std::vector<Sample> samples;
    for (int i = 1; i < steps; ++i) {
        if (i % 100 == 1) samples = samplesOf(before, dice, 60);
        Scene now = path(i);
        const ShadowFit fit = trial.fit(now.problem(), state);
        ASSERT_TRUE(fit.hasMap()) << "step " << i << ": " << fit.reason;
        const std::size_t jumps = state.memory.orientationJumps;
        // A jump of the orientation that gains 10 % is counted, and forgiven.
        if (jumps == stateBefore.memory.orientationJumps) {
            const Change change =
                changeBetween(before, fitBefore, stateBefore, now, fit, state, samples);
            measured += change.measured;
            if (change.greatest > MostChange) ++violations;
            if (change.greatest > worst.greatest) {
                worst = change;
                worstStep = i;
            }
        }
        before = now;
        fitBefore = fit;
        stateBefore = state;
    }
    EXPECT_GT(measured, static_cast<std::size_t>(steps));
    EXPECT_LE(worst.greatest, MostChange)
        << trial.name << ": " << violations << " of " << steps << " steps, the worst is step "
        << worstStep << " at " << worst.ws.transpose();
    EXPECT_LE(state.memory.orientationJumps, 10U) << trial.name;
}

/** Which bodies count, each for itself: receivers that are seen, and casters that shadow any of
   them. A fit may change at once when a body comes or goes. */
std::vector<bool> bodiesThatCount(const Scene& scene) {
    std::vector<bool> counts;
    const LightImage image(scene.light);
    FocusScratch scratch;
    FocusRegion region;
    const auto count = [&](const Scene& one) {
        findFocusRegion(one.problem(), image, scratch, region);
        counts.push_back(hasMap(region.reason));
    };
    Scene one = scene;
    one.turnedCasters.convex.clear();
    one.turnedReceivers.convex.clear();
    for (const Aabb& box : scene.casters.boxes()) {
        one.casters.clear();
        one.casters.add(box);
        count(one);
    }
    one.casters.clear();
    one.casters.addUnbounded();
    for (const Aabb& box : scene.receivers.boxes()) {
        one.receivers.clear();
        one.receivers.add(box);
        count(one);
    }
    return counts;
}

/// Boxes on a wide ground. The top of the view is 3° away from the horizon, or more: a ground that
/// is seen up to just below the horizon ends somewhere else after a step.
Scene randomOutdoors(Dice& dice) {
    Scene scene;
    scene.size = 10.0;
    const double height = dice.in(0.5, 6.0);
    const double fov = dice.in(40.0, 90.0) * Degree;
    double pitch = dice.in(-40.0, 5.0) * Degree;
    if (std::abs(pitch + fov / 2.0) < 3.0 * Degree) pitch -= 6.0 * Degree;
    const double yaw = dice.in(-180.0, 180.0) * Degree;
    const Vec3 forward(std::cos(pitch) * std::sin(yaw), std::sin(pitch),
                       -std::cos(pitch) * std::cos(yaw));
    const Vec3 level(std::sin(yaw), 0.0, -std::cos(yaw));
    scene.viewer.viewFromWorld = lookAlong(Vec3::Zero(), forward);
    scene.viewer.clipFromView = perspective(fov, 16.0 / 9.0, 0.1, dice.in(80.0, 500.0));
    scene.receivers.add({Vec3(0.0, -height, 0.0), Vec3(100.0, 0.0, 100.0)});
    const std::size_t bodies = 1 + dice.below(12);
    for (std::size_t i = 0; i < bodies; ++i) {
        const Vec3 half(dice.in(0.1, 1.5), dice.in(0.1, 3.0), dice.in(0.1, 1.5));
        const Vec3 at = dice.in(2.0, 30.0) * level + 6.0 * dice.cube();
        scene.addBody({Vec3(at.x(), half.y() - height, at.z()), half});
    }
    const double elevation = dice.in(8.0, 90.0) * Degree;
    const double azimuth = dice.in(-180.0, 180.0) * Degree;
    scene.light.wsDirection = Vec3(std::cos(elevation) * std::sin(azimuth), -std::sin(elevation),
                                   std::cos(elevation) * std::cos(azimuth));
    return scene;
}

Scene viewerTurned(const Scene& scene, const Vec3& unitAxis, double angle) {
    Scene result = scene;
    const Mat3 turn = Eigen::AngleAxisd(-angle, unitAxis).toRotationMatrix();
    const Vec3 eye = eyeOf(scene.viewer);
    const Mat3 rotation = scene.viewer.viewFromWorld.topLeftCorner<3, 3>() * turn;
    result.viewer.viewFromWorld.topLeftCorner<3, 3>() = rotation;
    result.viewer.viewFromWorld.topRightCorner<3, 1>() = -rotation * eye;
    return result;
}

class Steadiness : public testing::TestWithParam<Trial> {
protected:
    /// Random scenes by `draw`, the viewer or the light turned by a step about a random axis.
    template <typename Draw>
    void expectSteady(const Draw& draw) {
        std::size_t measured = 0;
        std::size_t left = 0;
        const bool holds = rc::check([&] {
            Dice dice(*anySeed());
            const Scene a = draw(dice);
            const Vec3 axis = dice.direction();
            Scene b = a;
            const bool turnsViewer = dice.chance(0.5);
            if (turnsViewer)
                b = viewerTurned(a, axis, Step);
            else
                b.light.wsDirection = turned(a.light.wsDirection, axis, Step);
            FitState stateA;
            const ShadowFit fitA = GetParam().fit(a.problem(), stateA);
            FitState stateB = stateA;
            const ShadowFit fitB = GetParam().fit(b.problem(), stateB);
            if (!fitA.hasMap() || !fitB.hasMap() || bodiesThatCount(a) != bodiesThatCount(b)) {
                ++left;
                return;
            }
            if (stateB.memory.orientationJumps > stateA.memory.orientationJumps) return;
            const auto samples = samplesOf(a, dice, 100);
            const Change change = changeBetween(a, fitA, stateA, b, fitB, stateB, samples);
            measured += change.measured;
            RC_LOG() << std::setprecision(17) << a << "\n"
                     << (turnsViewer ? "viewer" : "light") << " turned about " << axis.transpose()
                     << "\nchange of ln m " << change.greatest << " at " << change.ws.transpose()
                     << "\nwarps " << fitA.liWarp.transpose() << " and " << fitB.liWarp.transpose()
                     << " centres " << fitA.liCentre.transpose() << " and "
                     << fitB.liCentre.transpose() << " angles " << fitA.mapAngle << " and "
                     << fitB.mapAngle << "\n";
            RC_ASSERT(change.greatest <= MostChange);
        });
        EXPECT_TRUE(holds);
        EXPECT_GT(measured, left);
    }
};

} // namespace

INSTANTIATE_TEST_SUITE_P(EveryTechnique, Steadiness, testing::ValuesIn(trials()), ByName{});

TEST_P(Steadiness, OfTheSunOutdoors) {
    expectSteady(randomOutdoors);
}

TEST_P(Steadiness, OfASpotOutdoors) {
    expectSteady([](Dice& dice) {
        Scene scene = randomOutdoors(dice);
        scene.light.kind = LightKind::Spot;
        const Vec3 level = forwardOf(scene.viewer).cwiseProduct(Vec3(1.0, 0.0, 1.0)).normalized();
        const Vec3 target = dice.in(3.0, 25.0) * level + 3.0 * dice.cube();
        scene.light.wsPosition =
            target + dice.in(3.0, 25.0) * Vec3(0.0, 1.0, 0.0) + 8.0 * dice.cube();
        scene.light.wsDirection = target - Vec3(0.0, 6.0, 0.0) - scene.light.wsPosition;
        scene.light.outerHalfAngle = dice.in(15.0, 70.0) * Degree;
        return scene;
    });
}

TEST_P(Steadiness, OfTheSunThatPassesAWall) {
    // The wall of a block on the viewer's left, whose other sides are out of view, turns away from
    // the light, with a post before it, and a ground under both, which is nearer to the viewer.
    Scene scene;
    scene.size = 10.0;
    scene.viewer.viewFromWorld = lookAlong(Vec3::Zero(), Vec3(-0.5, -0.8, -1.0));
    scene.viewer.clipFromView = perspective(50.0 * Degree, 16.0 / 9.0, 0.1, 500.0);
    scene.viewer.shadowDistance = 25.0;
    scene.addBody({Vec3(-23.0, 10.0, -10.0), Vec3(20.0, 14.0, 30.0)});
    scene.setConvex(0, 0, std::nullopt, true);
    scene.receivers.add({Vec3(0.0, -2.0, 0.0), Vec3(60.0, 0.0, 60.0)});
    scene.casters.add({Vec3(-1.5, 1.0, -6.0), Vec3(0.2, 3.0, 0.2)});
    scene.addBody({Vec3(1.0, -1.5, -9.0), Vec3(0.6, 0.5, 0.6)});
    constexpr int Steps = 4000;
    expectSteadyPath(GetParam(), Steps, [&](int i) {
        Scene now = scene;
        const double azimuth = (i - Steps / 2) * Step;
        now.light.wsDirection = Vec3(std::sin(azimuth), -0.5, -std::cos(azimuth));
        return now;
    });
}

TEST_P(Steadiness, ThroughTheMinersLamp) {
    // The light turns from one side of the view to the other, through its very direction.
    const Scene scene = outdoors();
    const Vec3 forward = forwardOf(scene.viewer);
    const Vec3 axis = Vec3(1.0, 0.3, 0.0).cross(forward).normalized();
    constexpr int Steps = 6000;
    expectSteadyPath(GetParam(), Steps, [&](int i) {
        Scene now = scene;
        now.light.wsDirection = turned(forward, axis, (i - Steps / 2) * Step);
        return now;
    });
}

TEST_P(Steadiness, ThroughDuelingFrusta) {
    Scene scene = outdoors();
    scene.viewer.viewFromWorld = lookAlong(Vec3::Zero(), Vec3(0.0, 0.25, -1.0));
    const Vec3 forward = forwardOf(scene.viewer);
    const Vec3 axis = Vec3(1.0, 0.2, 0.0).cross(forward).normalized();
    constexpr int Steps = 4000;
    expectSteadyPath(GetParam(), Steps, [&](int i) {
        Scene now = scene;
        now.light.wsDirection = turned(-forward, axis, (i - Steps / 2) * Step);
        return now;
    });
}

TEST_P(Steadiness, OfTheSunThroughTheBorderOfItsBasis) {
    // Light space is turned about the light by a rule that jumps where z of the direction changes
    // its sign. That must not show.
    for (const double x : {0.0, 0.3, 0.5, 0.8}) {
        SCOPED_TRACE(x);
        const Scene scene = outdoors();
        constexpr int Steps = 20;
        expectSteadyPath(GetParam(), Steps, [&](int i) {
            Scene now = scene;
            now.light.wsDirection = Vec3(x, -std::sqrt(1.0 - x * x), (i - Steps / 2 + 0.5) * Step);
            return now;
        });
    }
}

namespace {

// A map of what stands still comes to rest: to the last bit, so that its texture can be kept.

/// Where nothing moves a warp changes by at most 0.003 a frame, and the ends of all slices by at most
/// 0.0005 of ln 2.
constexpr int MostFrames = 1500;
/// So many alike are at rest: a search tries a direction after the other.
constexpr int Alike = 60;

/// The frames until nothing changes any more; MostFrames where that never happens.
template <typename Frame>
int framesToRest(const Frame& drawFrame) {
    int alike = 0;
    for (int frame = 0; frame < MostFrames; ++frame) {
        alike = drawFrame() ? alike + 1 : 0;
        if (alike == Alike) return frame - Alike;
    }
    return MostFrames;
}

/// After a walk of some frames.
Scene walked(const Scene& scene, int frame) {
    Scene now = scene;
    const Vec3 eye = eyeOf(scene.viewer) + 0.05 * frame * Vec3(1.0, 0.0, 0.3);
    now.viewer.viewFromWorld = lookAlong(eye, forwardOf(scene.viewer));
    return now;
}

} // namespace

class Rest : public testing::TestWithParam<Trial> {};

INSTANTIATE_TEST_SUITE_P(EveryTechnique, Rest, testing::ValuesIn(trials()), ByName{});

TEST_P(Rest, ComesAfterAWalk) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        Dice dice(seed);
        const Scene scene = randomOutdoors(dice);
        FitState state;
        constexpr int Steps = 20;
        for (int frame = 0; frame < Steps; ++frame)
            GetParam().fit(walked(scene, frame).problem(), state);
        const Scene still = walked(scene, Steps);
        ShadowFit last;
        EXPECT_LT(framesToRest([&] {
                      const ShadowFit before = last;
                      last = GetParam().fit(still.problem(), state);
                      return last.clipFromWorld == before.clipFromWorld &&
                             last.depthScale == before.depthScale &&
                             last.depthOffset == before.depthOffset;
                  }),
                  MostFrames)
            << "seed " << seed;
    }
}

/// Frame after frame of one viewer, with what is seen divided into three.
class Divided {
public:
    explicit Divided(const Trial& trial)
        : mTechnique([&trial](const ShadowProblem& part, FitState& state) {
              return trial.fit(part, state);
          }) {}

    void divide(const Scene& scene) {
        mBefore = parts;
        parts = divideView(scene.problem(), 3, {}, 0.0, memory, mScratch, mSplits, mTechnique);
    }
    /// Whether parts are what they were the frame before, to the last bit.
    bool isAlike() const {
        if (parts.count != mBefore.count) return false;
        for (std::size_t i = 0; i < parts.count; ++i)
            if (parts.parts[i].wsRow != mBefore.parts[i].wsRow) return false;
        return true;
    }

    CascadeMemory memory;
    LightPartition parts;

private:
    PartFit mTechnique;
    CascadeScratch mScratch;
    std::vector<double> mSplits;
    LightPartition mBefore;
};

/// The same seen from far above: its ground is all at one depth.
Scene fromAbove(const Scene& scene) {
    Scene above = scene;
    above.viewer.viewFromWorld =
        lookAlong(Vec3(0.0, 60.0, 0.0), Vec3(0.1, -1.0, 0.05), Vec3::UnitZ());
    return above;
}

TEST(RestOfParts, ComesAfterAWalk) {
    int strips = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        Dice dice(seed);
        const Scene outdoors = randomOutdoors(dice);
        const Scene scene = seed % 2 == 0 ? outdoors : fromAbove(outdoors);
        const auto walk = [&](int frame) {
            Scene now = scene;
            const Vec3 wsStep = 0.05 * frame * Vec3(1.0, 0.0, 0.3);
            now.viewer.viewFromWorld.topRightCorner<3, 1>() -=
                now.viewer.viewFromWorld.topLeftCorner<3, 3>() * wsStep;
            return now;
        };
        Divided divided(trialNamed("Optimal"));
        constexpr int Steps = 20;
        for (int frame = 0; frame < Steps; ++frame)
            divided.divide(walk(frame));
        const Scene still = walk(Steps);
        EXPECT_LT(framesToRest([&] {
                      divided.divide(still);
                      return divided.isAlike();
                  }),
                  MostFrames)
            << "seed " << seed;
        if (!divided.memory.strips.wsDirection.isZero(0.0)) ++strips;
    }
    EXPECT_GT(strips, 2);
    EXPECT_LT(strips, 10);
}

TEST(SteadinessOfParts, BordersMoveLittleWithTheView) {
    const Trial& trial = trialNamed("Optimal");
    std::size_t measured = 0;
    std::size_t jumps = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        Dice dice(seed);
        const Scene outdoors = randomOutdoors(dice);
        const Scene scene = seed % 2 == 0 ? outdoors : fromAbove(outdoors);
        const Vec3 axis = dice.direction();
        Divided divided(trial);
        divided.divide(scene);
        double greatest = 0.0;
        for (int i = 1; i < 2000; ++i) {
            const LightPartition before = divided.parts;
            const std::size_t jumpsBefore = divided.memory.strips.jumps;
            const Scene now = viewerTurned(scene, axis, i * Step);
            divided.divide(now);
            const LightPartition& after = divided.parts;
            if (divided.memory.strips.jumps != jumpsBefore) continue;
            ASSERT_EQ(after.count, before.count);
            // Where the border lies on its normal, relative to what is seen, which is the view's
            // depth for slices and the focus region for strips.
            const std::vector<Sample> samples =
                i % 100 == 1 ? samplesOf(now, dice, 40) : std::vector<Sample>();
            for (const Sample& sample : samples) {
                const std::size_t servedBefore = before.serving(sample.ws);
                const std::size_t servedAfter = after.serving(sample.ws);
                ++measured;
                if (servedBefore == servedAfter) continue;
                // Points that change their map lie near the border.
                const HalfSpace& border =
                    before.parts[servedBefore]
                        .wsBounds[servedAfter < servedBefore ? servedAfter : servedAfter - 1];
                greatest = std::max(greatest, std::abs(border.distance(sample.ws)) /
                                                  (sample.ws - eyeOf(scene.viewer)).norm());
            }
        }
        EXPECT_LT(greatest, 0.02) << "seed " << seed;
        jumps += divided.memory.strips.jumps;
    }
    EXPECT_GT(measured, 1000U);
    // Turning by 0.2 rad, a dozen times.
    EXPECT_LE(jumps, 6U);
}
