#include "fit/geometry/BodyHull.h"

#include "fit/Problems.h"
#include "fit/Trials.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// Of bodies of size 1 and 10 units away: a thousandth of what a float's positions leave.
constexpr double Rounding = 1e-10;

std::vector<Vec3> anyBody(Dice& dice) {
    std::vector<Vec3> points(1 + dice.below(40));
    const Vec3 offset = 10.0 * dice.cube();
    const Vec3 scale(dice.chance(0.1) ? 0.0 : 1.0, dice.in(0.01, 1.0), dice.chance(0.1) ? 0.0 : 2);
    for (Vec3& point : points)
        point = offset + scale.cwiseProduct(dice.cube());
    return points;
}

/// The hull's vertices, and no plane to clip them by.
std::vector<Vec3> placed(const BodyHull& hull, const Transform3& wsFromBody) {
    ClipScratch scratch;
    std::vector<Vec3> points;
    clipHull(hull, wsFromBody, ConvexVolume(), scratch, points);
    return points;
}

} // namespace

RC_GTEST_PROP(BodyHull, HoldsItsPoints, ()) {
    Dice dice(*anySeed());
    const std::vector<Vec3> points = anyBody(dice);
    const BodyHull hull = makeBodyHull(points);
    RC_ASSERT(!hull.empty());
    for (int i = 0; i < 100; ++i) {
        const Vec3 direction = dice.direction();
        RC_ASSERT(support3(hull.vertices, direction) >= support3(points, direction) - Rounding);
    }
}

RC_GTEST_PROP(BodyHull, ReachesHardlyBeyondItsPoints, ()) {
    Dice dice(*anySeed());
    const std::vector<Vec3> points = anyBody(dice);
    const BodyHull hull = makeBodyHull(points);
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                const Vec3 normal = Vec3(x, y, z).stableNormalized();
                // A face is left out that would cut off less than a 64th of half the longest side.
                RC_ASSERT(support3(hull.vertices, normal) <=
                          support3(points, normal) + 2.0 / 64.0 + 1e-9);
            }
}

TEST(BodyHull, OfABoxIsTheBox) {
    const Aabb box{Vec3(1, 2, 3), Vec3(1, 0.5, 2)};
    const auto corner = corners(box);
    const BodyHull hull = makeBodyHull(corner);
    EXPECT_EQ(hull.vertices.size(), 8U);
    EXPECT_NEAR(hull.volume, 8.0 * box.halfExtents.prod(), 1e-9);
    for (const Vec3& vertex : hull.vertices)
        EXPECT_NEAR(((vertex - box.centre).cwiseAbs() - box.halfExtents).norm(), 0.0, 1e-9);
    EXPECT_TRUE(hull.hasCorners);
}

TEST(BodyHull, HasNotAllCornersOfABoxWhereOneIsCutOffALittle) {
    // Too little for a face of its own.
    auto corner = corners({Vec3(1, 2, 3), Vec3(1, 0.5, 2)});
    for (Vec3& point : corner) {
        const Vec3 kept = point;
        point.x() += point.x() > 1.0 ? -1e-3 : 1e-3;
        std::vector<Vec3> points(corner.begin(), corner.end());
        points.push_back({kept.x(), 2.0, 3.0});
        const BodyHull hull = makeBodyHull(points);
        EXPECT_EQ(hull.vertices.size(), 8U);
        EXPECT_FALSE(hull.hasCorners);
        point = kept;
    }
}

/// Its faces have the normals (±1, ±1, ±1): the hull is exact.
TEST(BodyHull, OfAnOctahedronHasItsVolume) {
    std::vector<Vec3> points;
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
        points.push_back(axis);
        points.push_back(-axis);
    }
    const BodyHull hull = makeBodyHull(points);
    EXPECT_NEAR(hull.volume, 4.0 / 3.0, 1e-9);
    EXPECT_EQ(hull.vertices.size(), 6U);
}

TEST(BodyHull, OfABallIsNearlyIt) {
    std::vector<Vec3> points;
    Dice dice(1);
    for (int i = 0; i < 20000; ++i)
        points.push_back(dice.direction());
    const double ball = 4.0 / 3.0 * std::numbers::pi;
    const double volume = makeBodyHull(points).volume;
    EXPECT_GT(volume, ball);
    EXPECT_LT(volume, 1.2 * ball);
}

TEST(BodyHull, OfAPointIsThere) {
    const std::vector<Vec3> points = {Vec3(1, 2, 3)};
    const std::vector<Vec3> found = placed(makeBodyHull(points), Transform3::Identity());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR((found[0] - points[0]).norm(), 0.0, 1e-9);
}

TEST(BodyHull, OfNothingOrOfWhatIsNotANumberIsEmpty) {
    EXPECT_TRUE(makeBodyHull({}).empty());
    const std::vector<Vec3> points = {Vec3::Zero(), Vec3(0, Infinity, 0)};
    EXPECT_TRUE(makeBodyHull(points).empty());
}

/// However many are added at a time, to the last bit.
RC_GTEST_PROP(BodyHull, InPartsIsTheWhole, ()) {
    Dice dice(*anySeed());
    std::vector<Vec3> points = anyBody(dice);
    for (std::size_t i = dice.chance(0.3) ? 600 : 0; i > 0; --i)
        points.push_back(10.0 * dice.cube());
    BodyHullBuilder builder;
    for (std::span<const Vec3> left = points; !left.empty();) {
        const std::size_t count = std::min(left.size(), 1 + dice.below(dice.chance(0.5) ? 5 : 500));
        builder.add(left.first(count));
        builder.add({});
        left = left.subspan(count);
    }
    const BodyHull whole = makeBodyHull(points);
    const BodyHull inParts = builder.build();
    RC_ASSERT(inParts.vertices == whole.vertices);
    RC_ASSERT(inParts.volume == whole.volume);
    RC_ASSERT(inParts.edges.size() == whole.edges.size());
}

/// Clipped by planes, it has no vertex outside them, and all that was inside.
RC_GTEST_PROP(ClipHull, IsTheHullWithinTheVolume, ()) {
    Dice dice(*anySeed());
    const BodyHull hull = makeBodyHull(anyBody(dice));
    const Transform3 wsFromBody =
        Eigen::Translation3d(dice.cube()) *
        Eigen::AngleAxisd(dice.in(-3.0, 3.0), dice.direction()) *
        Eigen::Scaling(dice.chance(0.5) ? -1.5 : 0.5, dice.in(0.0, 2.0), 1.0);
    const std::vector<Vec3> whole = placed(hull, wsFromBody);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& point : whole)
        middle += point / static_cast<double>(whole.size());
    ConvexVolume volume;
    for (std::size_t i = dice.below(4); i > 0; --i) {
        const Vec3 normal = dice.direction();
        volume.add(normal, -normal.dot(middle + dice.cube()));
    }
    ClipScratch scratch;
    std::vector<Vec3> clipped;
    clipHull(hull, wsFromBody, volume, scratch, clipped);
    for (const Vec3& point : clipped)
        RC_ASSERT(inside(volume, point) >= -1e-9);
    // Any point of the hull that is inside reaches no farther than what is left.
    for (int i = 0; i < 50; ++i) {
        Vec3 point = Vec3::Zero();
        double sum = 0.0;
        for (const Vec3& vertex : whole) {
            const double weight = std::pow(dice.in(0.0, 1.0), 8.0);
            point += weight * vertex;
            sum += weight;
        }
        point /= sum;
        if (inside(volume, point) < 0.0) continue;
        for (int k = 0; k < 10; ++k) {
            const Vec3 direction = dice.direction();
            RC_ASSERT(support3(clipped, direction) >= direction.dot(point) - 1e-9);
        }
    }
}

/// A long plank across the view: its box is a square, and a map of that square would hold more of
/// the ground than of its shadow.
TEST(BodyHull, MakesTheMapOfATurnedPlankSmaller) {
    Scene scene;
    scene.viewer.viewFromWorld = lookAlong(Vec3(0, 10, 20), Vec3(0, -1, -2));
    scene.viewer.clipFromView = perspective(1.0, 1.5, 0.1, 100.0);
    scene.light.wsDirection = Vec3(0.2, -1.0, 0.1);
    scene.receivers.add({Vec3(0, -1, 0), Vec3(100, 0, 100)});
    const Mat3 turn = Eigen::AngleAxisd(std::numbers::pi / 4.0, Vec3::UnitY()).toRotationMatrix();
    addTurned({Vec3(0, 0.5, 0), Vec3(5, 0.2, 0.2)}, turn, scene.casters, scene.turnedCasters);
    Scene boxes = scene;
    boxes.turnedCasters.clear();
    FitState state;
    FitState other;
    const Trial& uniform = trialNamed("Uniform");
    const ShadowFit tight = uniform.fit(scene.problem(), state);
    const ShadowFit loose = uniform.fit(boxes.problem(), other);
    const auto area = [](const ShadowFit& fit, const Scene& in) {
        const Vec2 size(in.mapWidth, in.mapHeight);
        const Vec2 dx = derivative(fit.clipFromWorld, size, Vec3(0, -1, 0), Vec3::UnitX());
        const Vec2 dz = derivative(fit.clipFromWorld, size, Vec3(0, -1, 0), Vec3::UnitZ());
        return 1.0 / std::abs(dx.x() * dz.y() - dx.y() * dz.x());
    };
    // Its shadow is 10 by 0.6, that of its box 7.4 by 7.4.
    EXPECT_LT(area(tight, scene), 0.15 * area(loose, boxes));
}

TEST(BodyHull, IsFlatWhereItsPointsAreInOnePlane) {
    const auto isFlat = [](std::initializer_list<Vec3> points) {
        return makeBodyHull(std::vector<Vec3>(points)).flat;
    };
    EXPECT_TRUE(isFlat({{0, 5, 0}, {1, 5, 0}, {1, 5, 1}, {0, 5, 1}, {0.3, 5, 0.2}}));
    EXPECT_TRUE(isFlat({{0, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 0, 1}}));
    // A step in float's last place, and more than that.
    EXPECT_TRUE(isFlat({{0, 5, 0}, {1, 5.0000005, 0}, {1, 5, 1}, {0, 5, 1}}));
    EXPECT_FALSE(isFlat({{0, 5, 0}, {1, 5.00001, 0}, {1, 5, 1}, {0, 5, 1}}));
    // However large it is: relief of a tenth of a unit on a ground of a hundred thousand.
    EXPECT_FALSE(isFlat({{0, 0, 0}, {1e5, 0.1, 0}, {1e5, 0, 1e5}, {0, 0, 1e5}}));
    EXPECT_FALSE(isFlat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
}
