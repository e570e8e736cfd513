// Errors that are emulated from a map's matrices, beside errors of what is really drawn with it.

#include "common/MapCapture.h"
#include "common/OracleView.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

namespace Lixel::Tests {
namespace {

using namespace Samples;

constexpr int Width = 640;
constexpr int Height = 480;
constexpr int MapSize = 1024;

/// The bias that programs draw with, in units of stored depth: ShadowParameters' RoundingBias.
constexpr double DrawnBias = 0x1p-19;

/** How much the two errors may differ, as a part of the drawn one.

    The errors of a map lie within half a texel of shadows' edges, a quarter on the average. A
    rasteriser snaps a caster's corners to 1/256 texel, which moves its edges by up to 1/256 of a
    quarter.

    A depth is stored in a float and read with a bias of DrawnBias, which is some length in the
    world, `depthError`. It moves an edge by about as much; a texel is shadowDistance / MapSize
    wide. OGRE's LiSPSM maps, whose depth range is hundreds of times that of the scene, lose a
    tenth of a unit in this way, which they would with any program; the emulation leaves it out.
*/
double tolerance(double depthError, double shadowDistance) {
    return 4.0 / 256.0 + depthError / (shadowDistance / MapSize);
}

/// Errors are counts of pixels, of which a few at corners go either way.
constexpr double FewPixels = 5.0;

class Emulation : public testing::TestWithParam<const char*> {};

/// One stage's scene, both ways.
class BothWays {
public:
    explicit BothWays(const SampleScene& scene)
        : mStage({.headless = true,
                  .width = Width,
                  .height = Height,
                  .title = "Lixel",
                  .logFile = "",
                  .sceneManagerType = ""}),
          mReach(static_cast<double>(scene.shadowDistance)) {
        mStage.show(scene);
        mOracle.emplace(collectTriangles(mStage.sceneManager()));
        mEmulation.emplace(*mOracle, mStage.sceneManager().getShadowCasterRenderBackFaces()
                                         ? CasterFaces::Backs
                                         : CasterFaces::Fronts);
    }

    void set(const SampleView& view, const SampleLight& light) {
        mStage.setView(view);
        mStage.setLight(light);
        mEmulation->setView(oracleView(mStage.camera(), Width, Height, mReach));
        mEmulation->setLight(oracleLight(mStage.light()));
    }

    void compare(const NamedSetup& setup) {
        std::vector<EmulatedMap> maps =
            MapCapture(mStage).capture(setup, MapSize, mReach, mOracle->scene().wsOrigin);
        ASSERT_EQ(maps.size(), 1U);
        const double depthError = DrawnBias / maps.front().depthPerWorldUnit;
        maps.front().extraBias = depthError;
        const ClassificationError emulated = mEmulation->error(maps);

        mStage.setShadowSetup(setup.create());
        // OGRE's setups settle, as they did for the capture.
        for (int i = 0; i < 2; ++i)
            mStage.drawFrame();
        const ClassificationError drawn =
            compareWithTruth(mEmulation->truth(), mStage.drawVisibility());

        fmt::print("  {:<13} drawn {:6.3f} % (acne {:5.3f}, leaks {:5.3f}), emulated {:6.3f} % "
                   "({:5.3f}, {:5.3f}), depths known to {:.4f}\n",
                   setup.name, drawn.error, drawn.acne, drawn.leak, emulated.error, emulated.acne,
                   emulated.leak, depthError);
        ASSERT_EQ(drawn.counted(), emulated.counted());
        EXPECT_GT(drawn.counted(), 10000U);
        const double few = 100.0 * FewPixels / static_cast<double>(drawn.counted());
        const double allowed = tolerance(depthError, mReach);
        EXPECT_NEAR(emulated.error, drawn.error, allowed * drawn.error + few);
        EXPECT_NEAR(emulated.acne, drawn.acne, allowed * drawn.error + few);
        EXPECT_NEAR(emulated.leak, drawn.leak, allowed * drawn.error + few);
    }

private:
    Stage mStage;
    double mReach;
    std::optional<ShadowOracle> mOracle;
    std::optional<MapEmulation> mEmulation;
};

TEST_P(Emulation, ErrsAsTheDrawnMapDoes) {
    const SampleScene& scene = *findSampleScene(GetParam());
    BothWays both(scene);
    for (const SampleView& view : std::span(scene.views).first(2)) {
        for (const SampleLight& light : std::span(scene.lights).first(2)) {
            const std::string name = fmt::format("{}, {}, {}", scene.name, view.name, light.name);
            fmt::print("{}\n", name);
            SCOPED_TRACE(name);
            both.set(view, light);
            for (const char* const setup : {"Uniform", "XPSM", "Ogre-LiSPSM", "Ogre-Focused"}) {
                SCOPED_TRACE(setup);
                both.compare(*findShadowSetup(setup));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Emulation, testing::Values("field", "duel"),
                         [](const auto& instance) { return std::string(instance.param); });

} // namespace
} // namespace Lixel::Tests
