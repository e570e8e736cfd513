/** Slices of the view, or strips of the light: by which of them texels are smaller. */
#include "fit/parts/CascadeDivision.h"

#include "fit/Oracle.h"
#include "fit/problem/TexelInPixels.h"
#include "fit/sampling/FitExtent.h"
#include "fit/technique/Optimal.h"
#include "fit/technique/Uniform.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

const PartFit Optimal = [](const ShadowProblem& part, FitState& state) {
    return fitMap(part, OptimalOptions{}, state);
};

/// One viewer's divisions, frame after frame.
struct Divided {
    LightPartition divide(const Scene& scene, std::size_t count = 2,
                          const CascadeOptions& options = {}, double vsPadding = 0.0) {
        return divideView(scene.problem(), count, options, vsPadding, memory, scratch, vsSplits,
                          Optimal);
    }
    bool isStrips() const { return !memory.strips.wsDirection.isZero(0.0); }

    CascadeMemory memory;
    CascadeScratch scratch;
    std::vector<double> vsSplits;
};

/// Boxes all over a square of ground, seen from straight above: all of it is at one depth.
Scene fromAbove() {
    Scene scene;
    scene.size = 10.0;
    scene.viewer.viewFromWorld =
        lookAlong(Vec3(0.0, 60.0, 0.0), Vec3(0.02, -1.0, 0.03), Vec3::UnitZ());
    scene.viewer.clipFromView = perspective(50.0 * Degree, 16.0 / 9.0, 0.1, 500.0);
    scene.light.wsDirection = Vec3(0.5, -1.0, 0.3);
    scene.receivers.add({Vec3::Zero(), Vec3(100.0, 0.0, 100.0)});
    for (int row = -4; row <= 4; ++row)
        for (int column = -4; column <= 4; ++column)
            scene.addBody({Vec3(11.0 * column, 1.0, 7.0 * row), Vec3(1.0, 1.0, 1.0)});
    return scene;
}

/// Boxes far into a view along the ground, turned by an angle from where it looks into a low sun.
Scene againstTheSun(double angle) {
    Scene scene = outdoors();
    for (int ring = 0; ring < 12; ++ring)
        for (int i = 0; i < 12; ++i) {
            const double at = (30.0 * i + 10.0 * ring) * Degree;
            const double far = 3.0 * std::exp(0.28 * ring);
            scene.addBody(
                {Vec3(far * std::sin(at), -1.5, far * std::cos(at)), Vec3(0.5, 0.5, 0.5)});
        }
    scene.light.wsDirection = Vec3(0.0, -0.12, 1.0);
    scene.viewer.viewFromWorld =
        lookAlong(Vec3::Zero(), Vec3(std::sin(angle), -0.1, -std::cos(angle)));
    return scene;
}

/// A sample of the light image, drawn at a scale.
ViewSample sampleAt(double x, double y, double scale = 1.0) {
    ViewSample sample;
    sample.liPoint = {x, y};
    sample.ndcFromLi *= scale;
    return sample;
}

const Polygon2 UnitSquare = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};

std::vector<ViewSample> evenly(std::size_t count) {
    std::vector<ViewSample> samples;
    for (std::size_t i = 0; i < count; ++i)
        samples.push_back(
            sampleAt((static_cast<double>(i) + 0.5) / static_cast<double>(count), 0.5));
    return samples;
}

std::array<double, ShadowPart::MostBounds> sharesOf(const std::vector<ViewSample>& samples,
                                                    std::size_t count) {
    std::vector<std::pair<double, double>> demands;
    return stripShares(samples, UnitSquare, Vec2::UnitX(), count, demands);
}

} // namespace

TEST(StripShares, OfEvenDemandAreEven) {
    const auto shares = sharesOf(evenly(1000), 4);
    EXPECT_NEAR(shares[0], 0.25, 1e-3);
    EXPECT_NEAR(shares[1], 0.5, 1e-3);
    EXPECT_NEAR(shares[2], 0.75, 1e-3);
    EXPECT_EQ(shares[3], 0.0);
}

TEST(StripShares, OfTwoAreTheBestOfAll) {
    const bool holds = rc::check([] {
        Dice dice(*anySeed());
        std::vector<ViewSample> samples;
        for (std::size_t i = 0; i < 5 + dice.below(40); ++i)
            samples.push_back(sampleAt(dice.in(0.0, 1.0), 0.5, std::exp(dice.in(-3.0, 3.0))));
        // Frobenius' norm of a scaled identity is the scale times root 2, a factor of all.
        const auto costOf = [&](double cut) {
            double before = 0.0;
            double beyond = 0.0;
            for (const ViewSample& sample : samples)
                (sample.liPoint.x() < cut ? before : beyond) += std::sqrt(sample.ndcFromLi(0, 0));
            return before * std::sqrt(cut) + beyond * std::sqrt(1.0 - cut);
        };
        const double cost = costOf(sharesOf(samples, 2)[0]);
        // Cuts lie in the middle between samples.
        std::vector<double> at;
        for (const ViewSample& sample : samples)
            at.push_back(sample.liPoint.x());
        std::ranges::sort(at);
        for (std::size_t i = 1; i < at.size(); ++i)
            RC_ASSERT(cost <= costOf((at[i - 1] + at[i]) / 2.0) * (1.0 + 1e-9));
    });
    EXPECT_TRUE(holds);
}

TEST(StripShares, AreAscendingAndApartWhateverIsAskedFor) {
    const bool holds = rc::check([] {
        Dice dice(*anySeed());
        std::vector<ViewSample> samples;
        const double spread = dice.chance(0.5) ? 1.0 : 1e-9;
        for (std::size_t i = 0; i < dice.below(30); ++i)
            samples.push_back(sampleAt(0.7 + 0.3 * spread * dice.in(-1.0, 1.0), 0.5));
        const std::size_t count = 2 + dice.below(ShadowPart::Most - 1);
        const auto shares = sharesOf(samples, count);
        double before = 0.0;
        for (std::size_t i = 0; i + 1 < count; ++i) {
            RC_ASSERT(shares[i] > before);
            RC_ASSERT(shares[i] < 1.0);
            before = shares[i];
        }
    });
    EXPECT_TRUE(holds);
}

TEST(FitExtent, IsOfAUniformMapItsTexel) {
    const Scene scene = outdoors();
    const LightImage image(scene.light);
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), UniformOptions{}, state);
    ASSERT_TRUE(fit.hasMap());
    // A uniform map is affine: one texel everywhere, as a step of clip space shows.
    const Eigen::Matrix2d texelsFromLi =
        (fit.clipFromLight.topLeftCorner<2, 2>() / fit.clipFromLight(3, 3)).array() *
        (scene.mapWidth / 2.0);
    const FitExtent extent(fit, image, scene.mapWidth, scene.mapHeight);
    const double expected = std::pow(texelsFromLi.inverse().norm(), 1.25);
    EXPECT_NEAR(extent(sampleAt(1.0, 2.0)), expected, 1e-9);
    EXPECT_NEAR(extent(sampleAt(1.0, 2.0, 9.0)), 3.0 * expected, 1e-9);
    const FitExtent coarser(fit, image, scene.mapWidth / 2, scene.mapHeight / 2);
    EXPECT_NEAR(coarser(sampleAt(1.0, 2.0)), std::pow(2.0, 1.25) * expected, 1e-9);
}

TEST(FitExtent, IsInfiniteBehindTheMap) {
    Scene scene = outdoors();
    scene.light.kind = LightKind::Spot;
    scene.light.wsPosition = Vec3(0.0, 10.0, -10.0);
    scene.light.wsDirection = Vec3(0.0, -1.0, 0.0);
    scene.light.outerHalfAngle = 40.0 * Degree;
    scene.light.nearDistance = 0.1;
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), OptimalOptions{}, state);
    ASSERT_TRUE(fit.hasMap());
    ASSERT_FALSE(fit.liWarp.isZero());
    const FitExtent extent(fit, LightImage(scene.light), scene.mapWidth, scene.mapHeight);
    const Vec2 beyondHorizon = fit.liCentre - 2.0 * fit.liWarp / fit.liWarp.squaredNorm();
    EXPECT_TRUE(std::isinf(extent(sampleAt(beyondHorizon.x(), beyondHorizon.y()))));
}

TEST(CascadeDivision, CutsWallsOneBehindTheOtherIntoSlices) {
    // With the light from behind the viewer, near and far walls lie on the same rays: no strip tells
    // them apart.
    Scene scene;
    scene.viewer.clipFromView = perspective(60.0 * Degree, 1.0, 0.1, 1000.0);
    scene.light.wsDirection = Vec3(0.1, -0.2, -1.0);
    for (int i = -3; i <= 3; ++i)
        scene.receivers.add({Vec3(0.3 * i, 0.0, -2.0), Vec3(0.06, 2.0, 0.0)});
    scene.receivers.add({Vec3(0.0, 0.0, -250.0), Vec3(250.0, 250.0, 0.0)});
    scene.casters.add({Vec3(0.0, 0.0, 5.0), Vec3(2000.0, 2000.0, 0.1)});
    Divided divided;
    const LightPartition parts = divided.divide(scene);
    EXPECT_EQ(parts.count, 2U);
    EXPECT_FALSE(divided.isStrips());
    EXPECT_EQ(parts.parts[0].vsEnd, divided.vsSplits.at(0));
}

TEST(CascadeDivision, CutsTheViewFromAboveIntoStrips) {
    for (const std::size_t count : {2U, 3U, 5U}) {
        Divided divided;
        const LightPartition parts = divided.divide(fromAbove(), count);
        EXPECT_EQ(parts.count, count);
        EXPECT_TRUE(divided.isStrips());
        // Across the light: moving along its rays leads from no strip to another.
        for (const ShadowPart& part : parts.span())
            for (const HalfSpace& border : part.bounds())
                EXPECT_NEAR(border.normal.dot(fromAbove().light.wsDirection), 0.0, 1e-9);
    }
}

TEST(CascadeDivision, LeavesSlicesWhereStripsAreNotWanted) {
    const Scene scene = fromAbove();
    const auto isStrips = [&](const CascadeOptions& options, double vsPadding = 0.0) {
        Divided divided;
        divided.divide(scene, 2, options, vsPadding);
        return divided.isStrips();
    };
    EXPECT_TRUE(isStrips({}));
    EXPECT_FALSE(isStrips({.stripLight = false}));
    EXPECT_FALSE(isStrips({.followReceivers = false}));
    EXPECT_FALSE(isStrips({.vsSplitDepths = {55.0}}));
    EXPECT_FALSE(isStrips({}, 0.1));
}

TEST(CascadeDivision, HasSmallerTexelsThanSlicesAlone) {
    // m at visible points that are not the samples, of the map that serves each.
    const auto meanLogOf = [](const Scene& scene, const LightPartition& parts,
                              const std::vector<Vec3>& points) -> std::optional<double> {
        std::array<ShadowFit, LightPartition::Capacity> fits;
        for (std::size_t i = 0; i < parts.count; ++i) {
            FitState state;
            const ShadowProblem whole = scene.problem();
            fits[i] = Optimal(problemOf(whole, parts.parts[i]), state);
        }
        double sum = 0.0;
        std::size_t count = 0;
        for (const Vec3& ws : points) {
            const auto m =
                texelInPixels(fits[parts.serving(ws)], Vec2(scene.mapWidth, scene.mapHeight),
                              scene.viewer, Vec2(1280.0, 720.0), ws, Vec3::UnitY());
            if (!m || !std::isfinite(*m)) continue;
            sum += std::log(*m);
            ++count;
        }
        if (count < 50) return std::nullopt;
        return sum / static_cast<double>(count);
    };
    double gain = 0.0;
    int judged = 0;
    int strips = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Dice dice(seed);
        Scene scene = fromAbove();
        // From straight above to nearly along the ground.
        const double height = std::exp(dice.in(0.7, 4.0));
        const double pitch = -dice.in(15.0, 89.0) * Degree;
        scene.viewer.viewFromWorld =
            lookAlong(Vec3(0.0, height, -0.7 * height), Vec3(0.1, std::sin(pitch), std::cos(pitch)),
                      Vec3::UnitZ());
        const double azimuth = dice.in(0.0, 2.0 * std::numbers::pi);
        scene.light.wsDirection = Vec3(std::cos(azimuth), -1.0, std::sin(azimuth));
        std::vector<Vec3> points;
        const Mat4 worldFromClip =
            (scene.viewer.clipFromView * scene.viewer.viewFromWorld).inverse();
        for (int i = 0; i < 200; ++i) {
            const double x = dice.in(-1.0, 1.0);
            const double y = dice.in(-1.0, 1.0);
            const Vec3 begin = (worldFromClip * Vec4(x, y, -1.0, 1.0)).hnormalized();
            const Vec3 end = (worldFromClip * Vec4(x, y, 0.9, 1.0)).hnormalized();
            const double t = begin.y() / (begin.y() - end.y());
            const Vec3 ws = begin + t * (end - begin);
            if (t > 0.0 && ws.cwiseAbs().maxCoeff() < 100.0) points.push_back(ws);
        }
        Divided divided;
        const LightPartition chosen = divided.divide(scene);
        if (!divided.isStrips()) continue;
        ++strips;
        Divided sliced;
        const auto ofChosen = meanLogOf(scene, chosen, points);
        const auto ofSlices =
            meanLogOf(scene, sliced.divide(scene, 2, {.stripLight = false}), points);
        if (!ofChosen || !ofSlices) continue;
        ++judged;
        gain += *ofSlices - *ofChosen;
    }
    EXPECT_GT(strips, 5);
    EXPECT_LT(strips, 40);
    ASSERT_GT(judged, 5);
    EXPECT_GT(gain / judged, std::log(1.1)) << "strips are taken for a tenth or more";
}

TEST(CascadeDivision, ChangesForAClearGainAloneWhileTheViewerTurns) {
    // All around: into the sun, across its light, with it.
    Divided divided;
    std::size_t strips = 0;
    std::size_t slices = 0;
    for (int frame = 0; frame <= 720; ++frame) {
        divided.divide(againstTheSun(0.5 * frame * Degree));
        ++(divided.isStrips() ? strips : slices);
    }
    EXPECT_GT(strips, 30U);
    EXPECT_GT(slices, 30U);
    EXPECT_GE(divided.memory.strips.jumps, 2U);
    EXPECT_LE(divided.memory.strips.jumps, 7U);
}
