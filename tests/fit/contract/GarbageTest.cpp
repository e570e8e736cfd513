/// Contract, 1 and 2: for every input a fit returns, and says why where there is no map.
#include "fit/Problems.h"
#include "fit/Trials.h"

#include "fit/technique/Uniform.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cstdlib>
#include <functional>
#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// What spoils a good scene, and what is to be said of it.
struct Spoiler {
    const char* name;
    FitReason reason;
    std::function<void(Scene&)> spoil;
};

void PrintTo(const Spoiler& spoiler, std::ostream* out) {
    *out << spoiler.name;
}

std::vector<Spoiler> spoilers() {
    const auto spot = [](auto change) {
        return [change](Scene& s) {
            s.light.kind = LightKind::Spot;
            s.light.wsPosition = Vec3(0.0, 20.0, -10.0);
            s.light.wsDirection = Vec3(0.0, -1.0, 0.0);
            change(s.light);
        };
    };
    constexpr FitReason Invalid = FitReason::InvalidInput;
    return {
        {"NanInViewMatrix", Invalid, [](Scene& s) { s.viewer.viewFromWorld(1, 2) = NaN; }},
        {"InfinityInViewMatrix", Invalid,
         [](Scene& s) { s.viewer.viewFromWorld(0, 3) = Infinity; }},
        {"ZeroViewMatrix", Invalid, [](Scene& s) { s.viewer.viewFromWorld.setZero(); }},
        {"SingularViewMatrix", Invalid, [](Scene& s) { s.viewer.viewFromWorld.row(0).setZero(); }},
        {"HugeViewMatrix", Invalid, [](Scene& s) { s.viewer.viewFromWorld.fill(1e308); }},
        {"HugeNumberInViewMatrix", Invalid, [](Scene& s) { s.viewer.viewFromWorld(1, 1) = 1e308; }},
        {"ScaledViewMatrix", Invalid,
         [](Scene& s) { s.viewer.viewFromWorld.topLeftCorner<3, 3>() *= 1.1; }},
        {"ProjectiveViewMatrix", Invalid, [](Scene& s) { s.viewer.viewFromWorld(3, 0) = 0.1; }},
        {"NanInProjection", Invalid, [](Scene& s) { s.viewer.clipFromView(0, 0) = NaN; }},
        {"ZeroProjection", Invalid, [](Scene& s) { s.viewer.clipFromView.setZero(); }},
        {"SingularProjection", Invalid, [](Scene& s) { s.viewer.clipFromView.row(1).setZero(); }},
        {"NanShadowDistance", Invalid, [](Scene& s) { s.viewer.shadowDistance = NaN; }},
        {"NegativeShadowDistance", Invalid, [](Scene& s) { s.viewer.shadowDistance = -1.0; }},
        {"NanLightDirection", Invalid, [](Scene& s) { s.light.wsDirection.x() = NaN; }},
        {"InfiniteLightDirection", Invalid, [](Scene& s) { s.light.wsDirection.x() = Infinity; }},
        {"ZeroLightDirection", Invalid, [](Scene& s) { s.light.wsDirection.setZero(); }},
        {"NanLightPosition", Invalid, spot([](ShadowLight& l) { l.wsPosition.y() = NaN; })},
        {"InfiniteLightPosition", Invalid,
         spot([](ShadowLight& l) { l.wsPosition.y() = -Infinity; })},
        {"ZeroNearDistance", Invalid, spot([](ShadowLight& l) { l.nearDistance = 0.0; })},
        {"NanNearDistance", Invalid, spot([](ShadowLight& l) { l.nearDistance = NaN; })},
        {"InfiniteNearDistance", Invalid, spot([](ShadowLight& l) { l.nearDistance = Infinity; })},
        {"NanRange", Invalid, spot([](ShadowLight& l) { l.range = NaN; })},
        {"RangeNearerThanNear", Invalid, spot([](ShadowLight& l) { l.range = 0.05; })},
        {"NanCone", Invalid, spot([](ShadowLight& l) { l.outerHalfAngle = NaN; })},
        {"ZeroCone", Invalid, spot([](ShadowLight& l) { l.outerHalfAngle = 0.0; })},
        {"HalfSpaceCone", FitReason::TooFewMaps,
         spot([](ShadowLight& l) { l.outerHalfAngle = std::numbers::pi / 2.0; })},
        {"PointLight", FitReason::TooFewMaps, [](Scene& s) { s.light.kind = LightKind::Point; }},
        {"ZeroMap", Invalid, [](Scene& s) { s.mapWidth = 0; }},
        {"NegativeMap", Invalid, [](Scene& s) { s.mapHeight = -1024; }},
        {"MapOfBordersAlone", Invalid, [](Scene& s) { s.mapWidth = 4; }},
        {"NanFilterRadius", Invalid, [](Scene& s) { s.filterRadius = NaN; }},
        {"InfiniteFilterRadius", Invalid, [](Scene& s) { s.filterRadius = Infinity; }},
        {"NegativeFilterRadius", Invalid, [](Scene& s) { s.filterRadius = -1.0; }},
        {"NanCaster", Invalid,
         [](Scene& s) {
             s.casters.add({Vec3(NaN, 0, 0), Vec3::Ones()});
         }},
        {"NegativeReceiver", Invalid,
         [](Scene& s) {
             s.receivers.add({Vec3::Zero(), Vec3(1, 1, -1)});
         }},
        {"NoCaster", FitReason::NothingShadowed, [](Scene& s) { s.casters.clear(); }},
        {"NoReceiver", FitReason::NoReceivers, [](Scene& s) { s.receivers.clear(); }},
        {"UnboundedReceiverAndView", FitReason::Unbounded,
         [](Scene& s) {
             s.receivers.addUnbounded();
             s.viewer.clipFromView = perspective(1.0, 1.0, 0.1, Infinity);
         }},
    };
}

class Garbage : public testing::TestWithParam<Spoiler> {};

/// Whether the matrix that the graphics card gets has an inverse. Rows may differ in size by any
/// factor: each is brought to size 1 first.
bool invertibleInFloat(const Mat4& m) {
    Mat4 rows = roundedToFloat(m);
    if (!rows.allFinite()) return false;
    for (Eigen::Index i = 0; i < 4; ++i) {
        const double size = rows.row(i).cwiseAbs().maxCoeff();
        if (size == 0.0) return false;
        rows.row(i) /= size;
    }
    return rows.determinant() != 0.0 && rows.inverse().allFinite();
}

/// One garbage value in a random place.
void spoilSomething(Scene& scene, Dice& dice) {
    constexpr std::array<double, 14> Values = {NaN,    Infinity, -Infinity, 0.0,   -1.0,
                                               1e308,  -1e308,   1e200,     1e154, -1e100,
                                               1e-308, 5e-324,   1e-160,    1e30};
    const double value = Values[dice.below(Values.size())];
    const auto of3 = [&](Vec3& v) { v[static_cast<Eigen::Index>(dice.below(3))] = value; };
    const auto of16 = [&](Mat4& m) {
        m(static_cast<Eigen::Index>(dice.below(4)), static_cast<Eigen::Index>(dice.below(4))) =
            value;
    };
    switch (dice.below(10)) {
    case 0:
        return of16(scene.viewer.viewFromWorld);
    case 1:
        return of16(scene.viewer.clipFromView);
    case 2:
        scene.viewer.shadowDistance = value;
        return;
    case 3:
        return of3(scene.light.wsDirection);
    case 4:
        return of3(scene.light.wsPosition);
    case 5:
        (dice.chance(0.5) ? scene.light.nearDistance : scene.light.range) = value;
        return;
    case 6:
        scene.light.outerHalfAngle = value;
        return;
    case 7:
        scene.filterRadius = value;
        return;
    default: {
        Aabb box{scene.size * dice.cube(), scene.size * dice.cube().cwiseAbs()};
        of3(dice.chance(0.5) ? box.centre : box.halfExtents);
        if (dice.chance(0.5)) of3(dice.chance(0.5) ? box.centre : box.halfExtents);
        const double role = dice.in(0.0, 1.0);
        if (role < 0.7) scene.casters.add(box);
        if (role > 0.3) scene.receivers.add(box);
        return;
    }
    }
}

} // namespace

INSTANTIATE_TEST_SUITE_P(Invalid, Garbage, testing::ValuesIn(spoilers()), ByName{});

TEST_P(Garbage, HasNoMapAndAReason) {
    for (const Trial& trial : trials()) {
        Scene scene = outdoors();
        FitState state;
        ASSERT_TRUE(trial.fit(scene.problem(), state).hasMap()) << trial.name;
        GetParam().spoil(scene);
        const ShadowFit fit = trial.fit(scene.problem(), state);
        EXPECT_FALSE(fit.hasMap()) << trial.name << ": " << fit.reason;
        EXPECT_EQ(fit.reason, GetParam().reason) << trial.name << ": " << fit.reason;
        // The state is none the worse for it.
        const Scene good = outdoors();
        EXPECT_TRUE(trial.fit(good.problem(), state).hasMap()) << trial.name;
    }
}

TEST(GarbageInput, WithoutBodySetsIsInvalid) {
    for (const Trial& trial : trials()) {
        FitState state;
        EXPECT_EQ(trial.fit(ShadowProblem{}, state).reason, FitReason::InvalidInput);
    }
}

TEST(GarbageInput, OfHugeNumbersDoesNotCrash) {
    // Each is finite, but not what is computed from it. In a process of its own.
    std::vector<Scene> scenes;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        Scene scene = outdoors();
        Aabb box{Vec3(0.0, 0.0, -10.0), Vec3::Ones()};
        box.centre[axis] = box.halfExtents[axis] = 1e308;
        scene.addBody(box);
        scenes.push_back(scene);
        scenes.push_back(outdoors());
        scenes.back().viewer.viewFromWorld(1, axis) = -1e308;
        scenes.push_back(outdoors());
        scenes.back().viewer.viewFromWorld(axis, 3) = 1e308;
        scenes.push_back(outdoors());
        scenes.back().viewer.clipFromView(axis, axis) = 1e308;
    }
    for (const Trial& trial : trials())
        for (const Scene& scene : scenes)
            EXPECT_EXIT(
                {
                    FitState state;
                    const ShadowFit fit = trial.fit(scene.problem(), state);
                    std::exit(fit.hasMap() && !fit.clipFromWorld.allFinite() ? 1 : 0);
                },
                testing::ExitedWithCode(0), "")
                << trial.name << "\n"
                << scene;
}

TEST(GarbageInput, OfAnyKindGivesAFiniteMapOrNone) {
    const bool holds = rc::check([] {
        Scene scene = *anyScene();
        Dice dice(*anySeed());
        const std::size_t times = 1 + dice.below(2);
        for (std::size_t i = 0; i < times; ++i)
            spoilSomething(scene, dice);
        RC_LOG() << scene << "\n";
        for (const Trial& trial : trials()) {
            FitState state;
            const ShadowFit fit = trial.fit(scene.problem(), state);
            RC_LOG() << trial.name << ": " << toString(fit.reason) << "\n"
                     << fit.clipFromWorld << "\n";
            if (!fit.hasMap()) continue;
            RC_ASSERT(fit.clipFromWorld.allFinite());
            RC_ASSERT(fit.clipFromLight.allFinite());
            RC_ASSERT(invertibleInFloat(fit.clipFromWorld));
            RC_ASSERT(std::isfinite(fit.depthScale));
            RC_ASSERT(std::isfinite(fit.depthOffset));
            RC_ASSERT(std::isfinite(fit.depthPerWorldUnit));
            RC_ASSERT(fit.liCentre.allFinite());
            RC_ASSERT(fit.liWarp.allFinite());
        }
    });
    EXPECT_TRUE(holds);
}

TEST(ViewMatrix, MayBeMirroredOrHaveDrifted) {
    FitState state;
    Scene mirrored = outdoors();
    mirrored.viewer.viewFromWorld.row(0) *= -1.0;
    EXPECT_TRUE(fitMap(mirrored.problem(), UniformOptions{}, state).hasMap());
    Scene drifted = outdoors();
    drifted.viewer.viewFromWorld.topLeftCorner<3, 3>() *= 1.0001;
    EXPECT_TRUE(fitMap(drifted.problem(), UniformOptions{}, state).hasMap());
}
