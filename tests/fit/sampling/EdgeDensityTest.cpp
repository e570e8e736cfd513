// How densely outlines of boxes lie in the light image, and what samples count by that.
#include "fit/sampling/EdgeDensity.h"

#include "fit/Problems.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// A sun straight down: the light image is the ground, up to a mirror or a turn.
LightImage sunAbove() {
    ShadowLight light;
    light.wsDirection = Vec3(0.0, -1.0, 0.0);
    return LightImage(light);
}

Polygon2 squareHull(double half) {
    return {Vec2(-half, -half), Vec2(half, -half), Vec2(half, half), Vec2(-half, half)};
}

/// The integral over the grid: the mean over its cells' middles, where all is bilinear.
double lengthIn(const EdgeDensity& edges, double half, double lsDepth) {
    constexpr int Steps = 16 * EdgeDensity::Cells;
    const double step = 2.0 * half / Steps;
    double sum = 0.0;
    for (int i = 0; i < Steps; ++i)
        for (int k = 0; k < Steps; ++k)
            sum += edges.at(Vec2((i + 0.5) * step - half, (k + 0.5) * step - half), lsDepth);
    return sum * step * step;
}

BoxSet setOf(const Aabb& box) {
    BoxSet boxes;
    boxes.add(box);
    return boxes;
}

/// Of one box, in a square of 16 by 16, for receivers at these depths.
EdgeDensity edgesOf(const LightImage& image, const Aabb& box,
                    const Vec2& lsRange = Vec2(0.0, 30.0)) {
    EdgeDensity edges;
    edges.reset(image, squareHull(8.0), lsRange);
    edges.add(setOf(box), 0.1);
    edges.finish();
    return edges;
}

} // namespace

TEST(EdgeDensity, ABoxUnderTheSunHasThePerimeterOfItsTop) {
    const LightImage image = sunAbove();
    const EdgeDensity edges = edgesOf(image, {Vec3(1.0, -10.0, -2.0), Vec3(3.0, 0.0, 1.5)});
    EXPECT_NEAR(lengthIn(edges, 8.0, 30.0), 2.0 * (6.0 + 3.0), 1e-6);
    EXPECT_EQ(edges.turnsOf(2.0 * 64.0 / (16.0 * 16.0)), 2.0);
}

RC_GTEST_PROP(EdgeDensity, ABoxHasThePerimeterOfItsOutline, ()) {
    // That of the hull of its corners' images.
    Dice dice(*anySeed());
    ShadowLight light;
    light.wsDirection = dice.direction();
    const LightImage image(light);
    const Aabb box{dice.cube(), (dice.cube() + Vec3::Ones()) / 2.0};
    Polygon2 outline;
    const std::array<Vec2, 8> image8 = boxImage(image, box);
    std::vector<Vec2> corners(image8.begin(), image8.end());
    convexHull(corners, outline);
    double perimeter = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        perimeter += (outline[(i + 1) % outline.size()] - outline[i]).norm();
    const EdgeDensity edges = edgesOf(image, box, Vec2(-10.0, 10.0));
    RC_ASSERT(std::abs(lengthIn(edges, 8.0, 10.0) - perimeter) < 1e-6 * perimeter);
}

TEST(EdgeDensity, OfAnEdgeThatGoesFarBeyondTheGridIsThatOfItsPartWithin) {
    // Two edges from one side of the grid to the other, wherever along them the box's middle is.
    const LightImage image = sunAbove();
    const auto densityFor = [&](double x) {
        const EdgeDensity edges = edgesOf(image, {Vec3(x, -10.0, 0.0), Vec3(800.0, 0.0, 2.0)});
        return std::pair(lengthIn(edges, 8.0, 30.0),
                         edges.at(image.project(image.lsFromPoint(Vec3(0.3, -10.0, 2.0))), 30.0));
    };
    const auto [length, density] = densityFor(0.0);
    EXPECT_NEAR(length, 2.0 * 16.0, 1.0);
    EXPECT_GT(density, 0.0);
    for (const double x : {1e-4, 3.0, -37.0, 500.0}) {
        // Rounding decides whether an edge of 16 cells gets 16 points or 17.
        EXPECT_NEAR(densityFor(x).first, length, 0.01 * length);
        EXPECT_NEAR(densityFor(x).second, density, density / 16.0);
    }
}

TEST(EdgeDensity, LiesAroundTheOutline) {
    const LightImage image = sunAbove();
    // As wide as high, so that light space's turn about the light does not matter.
    const EdgeDensity edges = edgesOf(image, {Vec3(0.0, -10.0, 0.0), Vec3(4.0, 1.0, 4.0)});
    const double there = edges.at(Vec2(4.0, 0.5), 30.0);
    EXPECT_NEAR(there, edges.at(Vec2(-4.0, 0.5), 30.0), 1e-9);
    EXPECT_NEAR(there, edges.at(Vec2(0.5, 4.0), 30.0), 1e-9);
    // One edge, as long as a cell, in the area of a cell.
    EXPECT_NEAR(there, 1.0, 0.1);
    EXPECT_EQ(edges.at(Vec2(0.0, 0.0), 30.0), 0.0);
    EXPECT_EQ(edges.at(Vec2(7.0, 0.0), 30.0), 0.0);
}

TEST(EdgeDensity, CountsWhatLiesBeforeAReceiver) {
    const LightImage image = sunAbove();
    const EdgeDensity edges = edgesOf(image, {Vec3(0.0, -10.0, 0.0), Vec3(2.0, 0.0, 2.0)});
    const Vec2 li(2.0, 0.0);
    const double behind = edges.at(li, 30.0);
    EXPECT_GT(behind, 0.0);
    // Planes are at 0, 10, 20 and 30.
    EXPECT_EQ(edges.at(li, 0.0), 0.0);
    EXPECT_NEAR(edges.at(li, 5.0), 0.5 * behind, 1e-9);
    EXPECT_NEAR(edges.at(li, 10.0), behind, 1e-9);
    EXPECT_NEAR(edges.at(li, 20.0), behind, 1e-9);
}

TEST(EdgeDensity, OfASpotIsThatOfTheBoxNearItsMiddle) {
    ShadowLight light;
    light.kind = LightKind::Spot;
    light.wsPosition = Vec3(0.0, 10.0, 0.0);
    light.wsDirection = Vec3(0.0, -1.0, 0.0);
    EdgeDensity edges;
    edges.reset(LightImage(light), squareHull(1.0), Vec2(1.0, 20.0));
    // A flat box 10 below the light: a tenth of its size in the image.
    edges.add(setOf({Vec3(1.0, 0.0, -1.0), Vec3(1.0, 0.0, 2.0)}), 0.1);
    edges.add(setOf({Vec3(0.0, 9.95, 0.0), Vec3(1.0, 0.0, 1.0)}), 0.1); // too near
    edges.finish();
    EXPECT_NEAR(lengthIn(edges, 1.0, 20.0), 2.0 * (0.2 + 0.4), 1e-6);
}

TEST(EdgeDensity, WithoutAreaOrNumbersThereIsNone) {
    const LightImage image = sunAbove();
    EdgeDensity edges;
    const BoxSet boxes = setOf({Vec3(0.0, -10.0, 0.0), Vec3(2.0, 1.0, 2.0)});
    for (const Polygon2& hull :
         {Polygon2{Vec2(1.0, 1.0)}, Polygon2{Vec2(0.0, 0.0), Vec2(1.0, 0.0)}}) {
        edges.reset(image, hull, Vec2(0.0, 30.0));
        edges.add(boxes, 0.1);
        edges.finish();
        EXPECT_EQ(edges.at(hull[0], 30.0), 0.0);
        EXPECT_EQ(edges.turnsOf(edges.at(hull[0], 30.0)), 0.0);
    }
    // Where all that matters has one depth, all is before it.
    edges.reset(image, squareHull(8.0), Vec2(10.0, 10.0));
    edges.add(setOf({Vec3(0.0, -10.0, 0.0), Vec3(2.0, 0.0, 2.0)}), 0.1);
    edges.finish();
    EXPECT_NEAR(lengthIn(edges, 8.0, 10.0), 16.0, 1e-6);
}

TEST(EdgeDensity, ChangesLittleAsTheLightTurnsLittle) {
    // A box turned through all directions by 1e-4 rad at a time.
    const auto densities = [](double angle) {
        ShadowLight light;
        light.wsDirection = Vec3(std::sin(angle), -std::cos(angle), 0.3);
        EdgeDensity edges;
        edges.reset(LightImage(light), squareHull(8.0), Vec2(-10.0, 10.0));
        for (int i = 0; i < 20; ++i)
            edges.add(setOf({Vec3(i % 5 - 2.0, 0.0, i / 5 - 1.5), Vec3(0.3, 1.0 + 0.1 * i, 0.4)}),
                      0.1);
        edges.finish();
        std::array<double, 36> found;
        for (std::size_t i = 0; i < found.size(); ++i)
            found[i] = edges.at(
                Vec2(static_cast<double>(i % 6) - 2.5, static_cast<double>(i / 6) - 2.5), 10.0);
        return found;
    };
    auto last = densities(0.0);
    for (int step = 1; step <= 5000; ++step) {
        const auto now = densities(step * 1e-4);
        for (std::size_t i = 0; i < now.size(); ++i) {
            const double most = *std::ranges::max_element(now);
            ASSERT_NEAR(now[i], last[i], 0.05 * most) << "step " << step;
        }
        last = now;
    }
}

TEST(WeighByEdges, SamplesCountMoreUnderManyBoxes) {
    Scene scene;
    scene.viewer.viewFromWorld =
        lookAlong(Vec3(0.0, 20.0, 0.0), Vec3(0.0, -1.0, 0.0), Vec3::UnitX());
    scene.viewer.clipFromView = perspective(1.5, 1.0, 0.1, 100.0);
    scene.light.wsDirection = Vec3(0.0, -1.0, 0.0);
    scene.receivers.add({Vec3(0.0, -0.5, 0.0), Vec3(20.0, 0.5, 20.0)});
    // Many on the right, two on the left.
    for (int i = 0; i < 36; ++i)
        scene.casters.add({Vec3(5.0 + i % 6, 1.0, 2.0 * (i / 6) - 5.0), Vec3(0.3, 0.1, 0.3)});
    for (const double z : {-8.0, 8.0})
        scene.casters.add({Vec3(-10.0, 1.0, z), Vec3(0.3, 0.1, 0.3)});
    const ShadowProblem problem = scene.problem();
    const LightImage image(problem.light);
    FocusScratch focusing;
    FocusRegion region;
    findFocusRegion(problem, image, focusing, region);
    ASSERT_EQ(region.reason, FitReason::None);
    std::vector<ViewSample> samples = samplesOf(problem, {.most = 64, .enough = 64});
    EdgeDensity edges;
    weighByEdges(problem, image, region, region.liHull, 1.0, edges, samples);
    double many = 0.0;
    double few = 0.0;
    double sum = 0.0;
    for (const ViewSample& sample : samples) {
        const double x =
            (image.lsFromWs().transpose() * Vec3(sample.liPoint.x(), sample.liPoint.y(), 0.0)).x();
        EXPECT_GT(sample.weight, 0.0);
        sum += sample.weight;
        if (x > 5.0 && x < 9.0) many = std::max(many, sample.weight);
        if (x < 0.0) few = std::max(few, sample.weight);
    }
    EXPECT_NEAR(sum, static_cast<double>(samples.size()), 1e-9);
    EXPECT_GT(many, 1.5);
    EXPECT_GT(many, few);

    // Nothing of a share, and little of a single outline.
    weighByEdges(problem, image, region, region.liHull, 0.0, edges, samples);
    for (const ViewSample& sample : samples)
        EXPECT_EQ(sample.weight, 1.0);
}
