/** Contract, 3 to 5, for lights in several maps: every shadowed point is in the map of the
    part that serves it. */
#include "fit/Divisions.h"
#include "fit/Oracle.h"
#include "fit/Trials.h"

#include "fit/technique/PostProjectiveCube.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <iomanip>
#include <optional>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

constexpr std::size_t RaysPerDivision = 100;

struct Combination {
    std::string name;
    Division division;
    Trial trial;
};

std::vector<Combination> combinations() {
    std::vector<Combination> all;
    const auto add = [&](const Division& division, const Trial& trial) {
        all.push_back({std::string(division.name) + trial.name, division, trial});
    };
    const FitTechnique& cubeFace = CubeOptions::technique();
    const Trial face{"Face", &cubeFace, cubeFace.makeOptions(nullptr)};
    for (const Trial& trial : trialsThatServeAll())
        add(divisionNamed("Slices"), trial);
    add(divisionNamed("Strips"), trialNamed("Uniform"));
    add(divisionNamed("Strips"), trialNamed("Optimal"));
    add(divisionNamed("Chosen"), trialNamed("Optimal"));
    add(divisionNamed("Faces"), face);
    add(divisionNamed("FacesOfAPoint"), face);
    for (const char* const name : {"Uniform", "Uniform_stable", "Optimal"}) {
        add(divisionNamed("Cube"), trialNamed(name));
        add(divisionNamed("Aimed"), trialNamed(name));
    }
    return all;
}

void PrintTo(const Combination& combination, std::ostream* out) {
    *out << combination.name;
}

class PartsContract : public testing::TestWithParam<Combination> {};

} // namespace

INSTANTIATE_TEST_SUITE_P(EveryDivision, PartsContract, testing::ValuesIn(combinations()), ByName{});

TEST_P(PartsContract, HoldsForEveryShadowedPoint) {
    std::size_t checked = 0;
    const bool holds = rc::check([&] {
        Scene scene = *anyScene();
        Dice dice(*anySeed());
        if (GetParam().division.point) {
            if (scene.light.kind == LightKind::Directional)
                scene.light.wsPosition = eyeOf(scene.viewer) + scene.size * dice.cube();
            scene.light.kind = LightKind::Point;
            scene.light.nearDistance = 1e-2 * scene.size;
        }
        RC_LOG() << std::setprecision(17) << scene << "\n";
        const ShadowProblem whole = scene.problem();
        DivisionRoom room;
        const LightPartition parts = GetParam().division.divide(whole, room);
        // An aimed spot may be too wide; it is tested where it says so.
        if (parts.count == 0) return;
        std::array<std::optional<ShadowFit>, LightPartition::Capacity> fits;
        for (const ShadowedPoint& point : shadowedPoints(scene, dice, RaysPerDivision)) {
            const std::size_t i = parts.serving(point.wsReceiver);
            if (!fits[i]) {
                FitState state;
                fits[i] = GetParam().trial.fit(problemOf(whole, parts.parts[i]), state);
            }
            const ShadowFit& fit = *fits[i];
            RC_LOG() << "receiver " << point.wsReceiver.transpose() << " occluder "
                     << point.wsOccluder.transpose() << " part " << i << " of " << parts.count
                     << ": " << toString(fit.reason) << " texel "
                     << texelOf(fit.clipFromWorld, scene, point.wsReceiver).transpose() << "\n";
            RC_ASSERT(fit.hasMap());
            const Mat4 rounded = roundedToFloat(fit.clipFromWorld);
            const Vec2 texel = texelOf(rounded, scene, point.wsReceiver);
            RC_ASSERT(clipOf(rounded, point.wsReceiver).w() > 0.0);
            RC_ASSERT(insideBorder(texel, scene) >= scene.filterRadius + 1.0);

            const Vec4 occluder = clipOf(fit.clipFromWorld, point.wsOccluder);
            RC_ASSERT(occluder.w() > 0.0);
            RC_ASSERT(occluder.z() <= (1.0 + 1e-9) * occluder.w());
            RC_ASSERT(scene.depthClamp || occluder.z() >= -(1.0 + 1e-9) * occluder.w());
            const Vec2 apart = texelOf(fit.clipFromWorld, scene, point.wsOccluder) -
                               texelOf(fit.clipFromWorld, scene, point.wsReceiver);
            RC_ASSERT(apart.norm() <= 0.01);
            ++checked;
        }
    });
    EXPECT_TRUE(holds);
    EXPECT_GT(checked, 1000U);
}
