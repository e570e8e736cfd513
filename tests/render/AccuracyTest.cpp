// XPSM beside a uniform map that is focused the same way.

#include "common/Comparison.h"
#include "common/Setups.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace Lixel::Tests {
namespace {

using namespace Samples;

/// A house, which comes with Debian's assimp-testmodels.
const char* const Model = "/usr/share/assimp/models/IFC/AC14-FZK-Haus.ifc";

std::vector<ComparedCase> compare(const std::string& scene) {
    Stage stage({.headless = true, .width = 400, .height = 300});
    const SampleScene shown = scene.empty() ? modelScene(Model) : *findSampleScene(scene);
    stage.show(shown);
    return compareSetups(stage, shown, *findShadowSetup("XPSM"), *findShadowSetup("Uniform"), 4,
                         std::span(shown.views).first(1), [](const std::string&) {});
}

/// Five scenes as they first show, four lights each, on maps sized so that Uniform errs 1 to 5 %.
TEST(Accuracy, XpsmErrsLessThanUniform) {
    std::vector<double> ratios;
    for (const std::string scene : {"field", "duel", "miners-lamp", "street", ""}) {
        for (const ComparedCase& one : compare(scene)) {
            fmt::print("{:<32} map {:>4}  Uniform {:.3f} %  XPSM {:.3f} %  ratio {:.3f}\n",
                       fmt::format("{}, {}", one.scene, one.light), one.mapSize, one.baseline,
                       one.error, one.ratio());
            EXPECT_LE(one.ratio(), 1.05) << one.scene << ", " << one.light;
            ratios.push_back(one.ratio());
        }
    }
    const GeometricMean mean = geometricMean(ratios);
    fmt::print("geometric mean {:.3f} [{:.3f}, {:.3f}] over {} cases\n", mean.mean, mean.lower,
               mean.upper, mean.count);
    EXPECT_EQ(mean.count, 20U);
    EXPECT_LE(mean.mean, 0.5);
}

} // namespace
} // namespace Lixel::Tests
