#include "fit/geometry/ConvexVolume.h"

#include "fit/Oracle.h"
#include "fit/focus/ViewVolume.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

std::vector<Vec3> clipped(const Aabb& box, const ConvexVolume& volume) {
    ClipScratch scratch;
    std::vector<Vec3> points;
    clipBox(box, volume, scratch, points);
    return points;
}

ShadowViewer walker() {
    return {.viewFromWorld = lookAlong(Vec3(1.0, 2.0, 3.0), Vec3(0.2, -0.3, -1.0)),
            .clipFromView = perspective(1.0, 1.5, 0.5, 40.0)};
}

/// The corners of a view, by unprojection.
std::array<Vec3, 8> viewCorners(const ShadowViewer& viewer) {
    const Mat4 worldFromClip = (viewer.clipFromView * viewer.viewFromWorld).inverse();
    std::array<Vec3, 8> result;
    for (std::size_t i = 0; i < 8; ++i)
        result[i] = (worldFromClip * Vec4((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                                          (i & 4) != 0 ? 1.0 : -1.0, 1.0))
                        .hnormalized();
    return result;
}

} // namespace

TEST(WithDepthAhead, TurnsReversedDepthAlone) {
    const Mat4 usual = frustum(-0.3, 0.5, -0.2, 0.4, 0.5, 90.0);
    Mat4 reversed = usual;
    reversed.row(2) *= -1.0;
    EXPECT_EQ(withDepthAhead(usual), usual);
    EXPECT_EQ(withDepthAhead(reversed), usual);
    const Mat4 flat = orthographic(4.0, 3.0, 0.1, 100.0);
    reversed = flat;
    reversed.row(2) *= -1.0;
    EXPECT_EQ(withDepthAhead(flat), flat);
    EXPECT_EQ(withDepthAhead(reversed), flat);
    const Mat4 endless = perspective(1.0, 1.5, 0.1, std::numeric_limits<double>::infinity());
    EXPECT_EQ(withDepthAhead(endless), endless);
}

TEST(ConvexVolume, NormalisesPlanesAndLeavesOutWhatIsNone) {
    ConvexVolume volume;
    volume.add(Vec3(0.0, 3.0, 4.0), 10.0);
    volume.add(Vec3::Zero(), 1.0);
    volume.add(Vec3(1.0, 0.0, 0.0), Infinity);
    volume.add(Vec3(std::nan(""), 0.0, 0.0), 0.0);
    ASSERT_EQ(volume.planes().size(), 1U);
    EXPECT_DOUBLE_EQ(volume.planes()[0].distance(Vec3(0.0, 3.0, 4.0)), 7.0);
}

TEST(ConvexVolume, TakesNoMoreThanItsCapacity) {
    ConvexVolume volume;
    for (std::size_t i = 0; i < ConvexVolume::Capacity + 3; ++i)
        volume.add(Vec3::UnitX(), static_cast<double>(i));
    EXPECT_EQ(volume.planes().size(), ConvexVolume::Capacity);
}

TEST(ConvexVolume, ClassifiesBoxesAgainstAHalfSpace) {
    ConvexVolume volume;
    volume.add(Vec3::UnitX(), 0.0);
    const Vec3 half = Vec3::Ones();
    EXPECT_EQ(volume.classify({Vec3(2.0, 9.0, 0.0), half}), ConvexVolume::Side::Inside);
    EXPECT_EQ(volume.classify({Vec3(0.5, 0.0, 0.0), half}), ConvexVolume::Side::Straddles);
    EXPECT_EQ(volume.classify({Vec3(-1.5, 0.0, 0.0), half}), ConvexVolume::Side::Outside);
    EXPECT_EQ(ConvexVolume().classify({Vec3::Zero(), half}), ConvexVolume::Side::Inside);
}

RC_GTEST_PROP(ConvexVolume, ClassifyAgreesWithThePointsOfTheBox, ()) {
    Dice dice = anyDice();
    const ConvexVolume volume = viewVolume(walker());
    const Aabb box{Vec3(1.0, 0.0, -10.0) + 15.0 * dice.cube(), 4.0 * dice.cube().cwiseAbs()};
    const ConvexVolume::Side side = volume.classify(box);
    for (int i = 0; i < 50; ++i) {
        const Vec3 p = box.centre + dice.cube().cwiseProduct(box.halfExtents);
        if (side == ConvexVolume::Side::Inside) RC_ASSERT(inside(volume, p) >= -1e-12);
        if (side == ConvexVolume::Side::Outside) RC_ASSERT(inside(volume, p) < 0.0);
    }
}

TEST(ViewVolume, HasNoFarPlaneForAnInfiniteProjection) {
    ShadowViewer viewer = walker();
    EXPECT_EQ(viewVolume(viewer).planes().size(), 6U);
    viewer.clipFromView = perspective(1.0, 1.5, 0.5, Infinity);
    EXPECT_EQ(viewVolume(viewer).planes().size(), 5U);
    viewer.shadowDistance = 20.0;
    EXPECT_EQ(viewVolume(viewer).planes().size(), 6U);
    const Vec3 eye = eyeOf(viewer);
    EXPECT_LT(inside(viewVolume(viewer), eye + 20.1 * forwardOf(viewer)), 0.0);
    EXPECT_GT(inside(viewVolume(viewer), eye + 19.9 * forwardOf(viewer)), 0.0);
}

TEST(ViewVolume, KeepsTheFarPlaneOfADeepView) {
    // Near and far ten decades apart: the far plane's rows cancel down to 1e-10.
    ShadowViewer viewer;
    viewer.clipFromView = perspective(1.0, 1.0, 1e-4, 1e6);
    EXPECT_GT(inside(viewVolume(viewer), Vec3(0.0, 0.0, -0.999e6)), 0.0);
    EXPECT_LT(inside(viewVolume(viewer), Vec3(0.0, 0.0, -1.001e6)), 0.0);
}

RC_GTEST_PROP(ViewVolume, HoldsExactlyThePointsThatProjectIntoTheView, ()) {
    const Scene scene = *anyScene();
    Dice dice = anyDice();
    const ConvexVolume volume = viewVolume(scene.viewer);
    const Vec3 eye = eyeOf(scene.viewer);
    std::size_t seen = 0;
    for (int i = 0; i < 200; ++i) {
        const double reach = scene.size * std::pow(10.0, dice.in(-3.0, 1.0));
        const Vec3 p = eye + reach * (dice.cube() + dice.in(0.0, 2.0) * forwardOf(scene.viewer));
        const double distance = inside(volume, p);
        if (std::abs(distance) < 1e-9 * scene.size) continue; // on the border, up to rounding
        RC_LOG() << "point " << p.transpose() << " distance " << distance << "\n";
        RC_ASSERT(sees(scene.viewer, p) == (distance > 0.0));
        if (distance > 0.0) ++seen;
    }
    RC_CLASSIFY(seen > 0);
}

TEST(ClipBox, FindsACornerOfTheViewInsideABox) {
    // A huge box around the view: what remains is the view itself.
    const ShadowViewer viewer = walker();
    const ConvexVolume volume = viewVolume(viewer);
    const std::vector<Vec3> points = clipped({Vec3::Zero(), Vec3::Constant(1000.0)}, volume);
    for (const Vec3& corner : viewCorners(viewer)) {
        const auto near = [&](const Vec3& p) { return (p - corner).norm() < 1e-9; };
        EXPECT_TRUE(std::any_of(points.begin(), points.end(), near)) << corner.transpose();
    }
    // A small box around the eighth corner holds that corner alone.
    const Vec3 corner = viewCorners(viewer)[7];
    const std::vector<Vec3> one = clipped({corner, Vec3::Constant(0.25)}, volume);
    const auto near = [&](const Vec3& p) { return (p - corner).norm() < 1e-9; };
    EXPECT_TRUE(std::any_of(one.begin(), one.end(), near));
}

TEST(ClipBox, OfAFlatGroundIsTheViewsCut) {
    ShadowViewer viewer;
    viewer.viewFromWorld = lookAlong(Vec3::Zero(), Vec3(0.0, -1.0, 0.0), -Vec3::UnitZ());
    viewer.clipFromView = perspective(std::numbers::pi / 2.0, 1.0, 0.1, 100.0);
    const std::vector<Vec3> points =
        clipped({Vec3(0.0, -3.0, 0.0), Vec3(50.0, 0.0, 50.0)}, viewVolume(viewer));
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
        EXPECT_NEAR(support3(points, axis), 3.0, 1e-12);
    EXPECT_NEAR(support3(points, Vec3::UnitY()), -3.0, 1e-12);
}

TEST(ClipBox, OfAPointAndOfWhatIsOutside) {
    ConvexVolume volume;
    volume.add(Vec3::UnitX(), 0.0);
    EXPECT_FALSE(clipped({Vec3(1.0, 0.0, 0.0), Vec3::Zero()}, volume).empty());
    EXPECT_TRUE(clipped({Vec3(-1.0, 0.0, 0.0), Vec3::Zero()}, volume).empty());
    EXPECT_TRUE(clipped({Vec3(-2.0, 0.0, 0.0), Vec3::Ones()}, volume).empty());
}

RC_GTEST_PROP(ClipBox, AgreesWithPointsOfTheBox, ()) {
    const Scene scene = *anyScene();
    Dice dice = anyDice();
    const ConvexVolume volume = viewVolume(scene.viewer);
    std::vector<Aabb> boxes;
    for (const BoxSet* set : {&scene.receivers, &scene.casters})
        for (const Aabb& box : set->boxes())
            boxes.push_back(box);
    for (const Aabb& box : boxes) {
        const std::vector<Vec3> points = clipped(box, volume);
        const double extent = box.centre.norm() + box.halfExtents.norm() + scene.size;
        const double rounding = 1e-11 * extent;
        for (const Vec3& p : points) {
            RC_ASSERT(inside(volume, p) >= -rounding);
            RC_ASSERT(((p - box.centre).cwiseAbs() - box.halfExtents).maxCoeff() <= rounding);
        }
        // No point of both is outside the hull of what was found, along any direction.
        std::vector<Vec3> both;
        for (int i = 0; i < 40; ++i) {
            const Vec3 p = box.centre + dice.cube().cwiseProduct(box.halfExtents);
            if (inside(volume, p) >= 0.0) both.push_back(p);
        }
        if (both.empty()) continue;
        RC_ASSERT(!points.empty());
        for (int i = 0; i < 20; ++i) {
            const Vec3 d = dice.direction();
            RC_ASSERT(support3(both, d) <= support3(points, d) + rounding);
        }
    }
}

TEST(Corners, AreTheEightOfTheBox) {
    const Aabb box{Vec3(1.0, 2.0, 3.0), Vec3(0.5, 0.25, 4.0)};
    Vec3 sum = Vec3::Zero();
    for (const Vec3& c : corners(box)) {
        EXPECT_EQ((c - box.centre).cwiseAbs(), box.halfExtents);
        sum += c;
    }
    EXPECT_EQ(sum, 8.0 * box.centre);
}
