// Errors that are emulated from a map's matrices, beside errors of what is really drawn with it.

#include "common/MapCapture.h"
#include "common/OracleView.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>

namespace Lixel::Tests {
namespace {

using namespace Samples;

constexpr int PictureWidth = 640;
constexpr int PictureHeight = 480;
constexpr int MapTexels = 1024;

/// The bias that programs draw with, in units of stored depth: ShadowParameters' RoundingBias.
constexpr double DrawnBias = 0x1p-19;

/// Steps of a texel to which rasterisers snap corners.
constexpr double SubTexels = 256.0;

/** How much the two errors may differ, as a part of the drawn one.

    The errors of a map lie within half a texel of shadows' edges, a quarter on the average. A
    rasteriser snaps a caster's corners to 1/256 texel, which moves its edges by up to 1/256 of a
    quarter.

    A texel near the viewer may be hundreds of pixels wide, so that a single edge beside its centre
    decides more than this: @see Range.

    A depth is stored in a float and read with a bias of DrawnBias, which is some length in the
    world, `depthError`. It moves an edge by about as much; a texel is shadowDistance / MapTexels
    wide on the average. OGRE's LiSPSM maps lose a tenth of a unit in this way, as their clip z
    changes hundreds of times more across the light than along it, and as much again in the slope
    of a receiver, which programs derive from neighbouring pixels. The emulation leaves both out.
*/
double tolerance(double depthError, double shadowDistance) {
    return 4.0 / SubTexels + depthError / (shadowDistance / MapTexels);
}

/// Errors are counts of pixels; a few at corners go either way.
constexpr double FewPixels = 5.0;

/** A box from y = 1 to 2, 2 wide, over a ground at y = 0 that casts nothing, and the sun overhead.

    Seen from above, at y = 20: nothing hides the ground beside the box, nor its shadow's edges.
*/
class BoxInTheAir : public testing::Test {
protected:
    BoxInTheAir() : oracle(makeScene()), emulation(oracle, CasterFaces::Backs) {
        OracleView view;
        view.width = view.height = 200;
        // A viewer who looks down: x to the right, -z up. Sees 10 x 10 units of the ground, from
        // a little aside, so that the shadow shows beside the box.
        view.vsFromWs << 1, 0.5, 0, 0, 0, 0, -1, 0, 0, 1, 0, -20, 0, 0, 0, 1;
        view.clipFromVs = Eigen::Vector4d(0.2, 0.2, -0.05, 1).asDiagonal();
        view.clipFromVs(2, 3) = -1.0;
        emulation.setView(view);
        OracleLight sun;
        sun.direction = -Eigen::Vector3d::UnitY();
        emulation.setLight(sun);
    }

    static TriangleScene makeScene() {
        TriangleScene scene;
        Triangle ground;
        ground.casts = false;
        scene.add({-9, 0, -9}, {-9, 0, 9}, {9, 0, 9}, ground);
        scene.add({-9, 0, -9}, {9, 0, 9}, {9, 0, -9}, ground);
        const auto corner = [](int i) {
            return Eigen::Vector3d((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 2 : 1,
                                   (i & 4) != 0 ? 1 : -1);
        };
        for (const auto& [a, b, c, d] :
             {std::array{0, 1, 5, 4}, std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2},
              std::array{1, 3, 7, 5}, std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}}) {
            scene.add(corner(a), corner(b), corner(c));
            scene.add(corner(a), corner(c), corner(d));
        }
        return scene;
    }

    /// Covers x and z from -8 to 8 and heights from `top` down to -1.
    static EmulatedMap mapFrom(double top) {
        EmulatedMap map;
        map.width = map.height = 1024;
        const double half = 0.5 * (top + 1.0);
        map.clipFromWs << 0.125, 0, 0, 0, 0, 0, -0.125, 0, 0, -1.0 / half, 0, (top - half) / half,
            0, 0, 0, 1;
        return map;
    }

    ClassificationError errorOf(std::initializer_list<EmulatedMap> maps) {
        return emulation.error(std::span(maps.begin(), maps.size()));
    }

    ShadowOracle oracle;
    MapEmulation emulation;
};

TEST_F(BoxInTheAir, AFineMapIsRightButForTheEdges) {
    const ClassificationError error = errorOf({mapFrom(5.0)});
    EXPECT_GT(error.shadowed, 200U);
    EXPECT_GT(error.lit, 20000U);
    // At most half a texel, of 1/64, beside edges of 8 units among the 100 that are seen.
    EXPECT_LT(error.error, 100.0 * 8.0 / 128.0 / 100.0);
}

TEST_F(BoxInTheAir, ACasterInFrontOfTheDepthRangeIsMissingUnlessItIsClamped) {
    EmulatedMap map = mapFrom(0.5);
    EXPECT_EQ(errorOf({map}).leakPixels, errorOf({map}).shadowed);
    map.clampsDepth = true;
    EXPECT_EQ(errorOf({map}).leakPixels, errorOf({mapFrom(5.0)}).leakPixels);
}

TEST_F(BoxInTheAir, NoMapAndOutsideOfTheMapIsLit) {
    EmulatedMap beside = mapFrom(5.0);
    beside.clipFromWs(0, 3) = 10.0;
    EmulatedMap behind = mapFrom(5.0);
    behind.clipFromWs.row(3) *= -1.0;
    EmulatedMap none = mapFrom(5.0);
    none.clipFromWs.setZero();
    for (const EmulatedMap& map : {beside, behind, none}) {
        const ClassificationError error = errorOf({map});
        EXPECT_EQ(error.leakPixels, error.shadowed);
        EXPECT_EQ(error.acnePixels, 0U);
    }
    EXPECT_EQ(errorOf({}).leakPixels, errorOf({}).shadowed);
}

TEST_F(BoxInTheAir, EachMapServesItsViewDepths) {
    EmulatedMap near = mapFrom(5.0);
    near.endDepth = 19.0; // the ground is 20 away, the box' top 18
    EmulatedMap far = mapFrom(5.0);
    far.beginDepth = 19.0;
    EXPECT_EQ(errorOf({near}).leakPixels, errorOf({near}).shadowed);
    EXPECT_EQ(errorOf({near, far}).leakPixels, errorOf({mapFrom(5.0)}).leakPixels);
    // The first of two that overlap counts.
    EmulatedMap none;
    EXPECT_EQ(errorOf({none, far}).leakPixels, errorOf({none}).shadowed);
}

/// The least and the greatest of a map's errors while it is moved by what a rasteriser rounds.
struct Range {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();

    void add(double error) {
        least = std::min(least, error);
        greatest = std::max(greatest, error);
    }
    /// How far outside of the range an error lies.
    double distance(double error) const { return std::max({least - error, error - greatest, 0.0}); }
};

class Emulation : public testing::TestWithParam<const char*> {};

/// One stage's scene, both ways.
class BothWays {
public:
    explicit BothWays(const SampleScene& scene)
        : mStage({.headless = true, .width = PictureWidth, .height = PictureHeight}),
          mReach(static_cast<double>(scene.shadowDistance)) {
        mStage.show(scene);
        mOracle.emplace(collectTriangles(mStage.sceneManager()));
        mEmulation.emplace(*mOracle, casterFaces(mStage.sceneManager()));
    }

    void set(const SampleView& view, const SampleLight& light) {
        mStage.setView(view);
        mStage.setLight(light);
        mEmulation->setView(oracleView(mStage.camera(), PictureWidth, PictureHeight, mReach));
        mEmulation->setLight(oracleLight(mStage.light()));
    }

    void compare(const NamedSetup& setup) {
        MapCapture capture(mStage);
        std::vector<EmulatedMap> maps =
            capture.capture(setup, MapTexels, mReach, mOracle->scene().wsOrigin);
        ASSERT_EQ(maps.size(), 1U);
        const double depthError = DrawnBias / maps.front().depthPerWorldUnit;
        maps.front().extraBias = depthError;
        const ClassificationError emulated = mEmulation->error(maps);
        Range error, acne, leak;
        for (const double x : {-1.0, 0.0, 1.0}) {
            for (const double y : {-1.0, 0.0, 1.0}) {
                const ClassificationError moved = mEmulation->error(
                    std::array{movedByTexels(maps.front(), x / SubTexels, y / SubTexels)});
                error.add(moved.error);
                acne.add(moved.acne);
                leak.add(moved.leak);
            }
        }

        capture.begin(setup, MapTexels, mReach, mOracle->scene().wsOrigin);
        const ClassificationError drawn =
            compareWithTruth(mEmulation->truth(), capture.nextVisibility());

        fmt::print("  {:<13} drawn {:6.3f} % (acne {:5.3f}, leaks {:5.3f}), emulated {:6.3f} % "
                   "({:5.3f}, {:5.3f}), depths known to {:.4f}\n",
                   setup.name, drawn.error, drawn.acne, drawn.leak, emulated.error, emulated.acne,
                   emulated.leak, depthError);
        ASSERT_EQ(drawn.counted(), emulated.counted());
        EXPECT_GT(drawn.counted(), 10000U);
        const double few = 100.0 * FewPixels / static_cast<double>(drawn.counted());
        const double allowed = tolerance(depthError, mReach);
        EXPECT_LE(error.distance(drawn.error), allowed * drawn.error + few);
        EXPECT_LE(acne.distance(drawn.acne), allowed * drawn.error + few);
        EXPECT_LE(leak.distance(drawn.leak), allowed * drawn.error + few);
    }

private:
    /// The map as it is while its texels' centres lie elsewhere.
    static EmulatedMap movedByTexels(EmulatedMap map, double x, double y) {
        map.clipFromWs.row(0) += 2.0 * x / map.width * map.clipFromWs.row(3);
        map.clipFromWs.row(1) += 2.0 * y / map.height * map.clipFromWs.row(3);
        return map;
    }

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

INSTANTIATE_TEST_SUITE_P(Scenes, Emulation, testing::Values("field", "duel", "miners-lamp"),
                         [](const auto& instance) {
                             std::string name = instance.param;
                             std::erase(name, '-');
                             return name;
                         });

} // namespace
} // namespace Lixel::Tests
