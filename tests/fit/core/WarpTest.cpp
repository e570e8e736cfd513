#include "fit/core/Warp.h"

#include "fit/Problems.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

const Polygon2 Square = {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)};

struct Region {
    Polygon2 hull;
    Vec2 centre;
    double thickness;
};

Region anyRegion(Dice& dice) {
    Region region;
    std::vector<Vec2> points;
    const std::size_t count = 1 + dice.below(12);
    const Vec2 offset = 100.0 * dice.cube().head<2>();
    for (std::size_t i = 0; i < count; ++i)
        points.push_back(offset + Vec3(dice.cube()).head<2>());
    convexHull(points, region.hull);
    region.centre = steinerPoint(region.hull);
    region.thickness = dice.in(1e-4, 1e-2);
    return region;
}

} // namespace

TEST(WarpExtent, OfASquare) {
    const WarpExtent extent = warpExtent(Square, Vec2(0.5, 0.0), Vec2(0.25, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(extent.least, 0.25 * 1.5);
    EXPECT_DOUBLE_EQ(extent.greatest, 0.25 * 0.5);
}

TEST(WarpExtent, OfAThickenedPoint) {
    const WarpExtent extent = warpExtent({Vec2(3, 4)}, Vec2(3, 4), Vec2(0.0, 2.0), 0.5);
    EXPECT_DOUBLE_EQ(extent.least, 1.0);
    EXPECT_DOUBLE_EQ(extent.greatest, 1.0);
}

TEST(PullIntoSafeSet, LeavesSafeWarpsAlone) {
    Vec2 warp(0.5, 0.0);
    EXPECT_EQ(pullIntoSafeSet(Square, Vec2::Zero(), 0.0, warp), 1.0);
    EXPECT_EQ(warp, Vec2(0.5, 0.0));
    Vec2 none = Vec2::Zero();
    EXPECT_EQ(pullIntoSafeSet(Square, Vec2::Zero(), 0.0, none), 1.0);
    EXPECT_EQ(none, Vec2::Zero());
}

TEST(PullIntoSafeSet, PullsAWarpThroughTheRegionToTheBound) {
    // The line where the denominator vanishes would cross the square at x = -1/2.
    Vec2 warp(2.0, 0.0);
    const double factor = pullIntoSafeSet(Square, Vec2::Zero(), 0.0, warp);
    EXPECT_LT(factor, 0.5);
    EXPECT_DOUBLE_EQ(warp.x(), 2.0 * factor);
    // A + εB = 1 - ε with A = B = w.
    EXPECT_NEAR(warp.x(), (1.0 - WarpSafety) / (1.0 + WarpSafety), 1e-15);
}

RC_GTEST_PROP(PullIntoSafeSet, ResultIsSafeAndOnTheSameRay, ()) {
    Dice dice(*anySeed());
    const Region region = anyRegion(dice);
    const Vec2 wanted =
        std::pow(10.0, dice.in(-3.0, 9.0)) * Vec2(dice.in(-1.0, 1.0), dice.in(-1.0, 1.0));
    Vec2 warp = wanted;
    const double factor = pullIntoSafeSet(region.hull, region.centre, region.thickness, warp);
    RC_ASSERT(factor > 0.0);
    RC_ASSERT(factor <= 1.0);
    RC_ASSERT((warp - factor * wanted).norm() <= 1e-15 * warp.norm());
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (const Vec2& q : region.hull) {
        least = std::min(least, 1.0 + warp.dot(q - region.centre));
        greatest = std::max(greatest, 1.0 + warp.dot(q - region.centre));
    }
    constexpr double Rounding = 1e-10;
    RC_ASSERT(least >= WarpSafety * greatest - Rounding);
    RC_ASSERT(least >= WarpSafety - Rounding);
    // No more is taken than is needed: the bound is met with equality where it binds.
    const WarpExtent extent = warpExtent(region.hull, region.centre, warp, region.thickness);
    const double load = extent.least + WarpSafety * extent.greatest;
    if (factor < 1.0) RC_ASSERT(std::abs(load - (1.0 - WarpSafety)) < Rounding);
    RC_ASSERT(load <= 1.0 - WarpSafety + Rounding);
}

RC_GTEST_PROP(PullIntoSafeSet, IsContinuousInTheWarp, ()) {
    Dice dice(*anySeed());
    const Region region = anyRegion(dice);
    const Vec2 wanted = 5.0 * Vec2(dice.in(-1.0, 1.0), dice.in(-1.0, 1.0));
    constexpr double Step = 1e-7;
    Vec2 a = wanted;
    Vec2 b = wanted + Step * Vec2(dice.in(-1.0, 1.0), dice.in(-1.0, 1.0));
    pullIntoSafeSet(region.hull, region.centre, region.thickness, a);
    pullIntoSafeSet(region.hull, region.centre, region.thickness, b);
    // w / load(w): the load's slope is at most the region's radius, and a pulled warp is at most
    // 1 / thickness long.
    const double radius = std::sqrt(8.0) + region.thickness;
    const double slope = 1.0 + (1.0 + WarpSafety) * radius / region.thickness;
    RC_ASSERT((a - b).norm() < std::sqrt(2.0) * Step * slope);
}

RC_GTEST_PROP(WarpOf, HasTheCovectorsDenominators, ()) {
    Dice dice(*anySeed());
    const Region region = anyRegion(dice);
    Vec3 covector = dice.cube();
    // Positive all over the region.
    const WarpExtent extent = warpExtent(region.hull, region.centre, covector.head<2>(), 0.0);
    const double atCentre = extent.least + dice.in(1e-2, 10.0);
    covector.z() = atCentre - covector.head<2>().dot(region.centre);
    const Vec2 warp = warpOf(covector, region.hull, region.centre);
    for (const Vec2& q : region.hull)
        RC_ASSERT(std::abs(1.0 + warp.dot(q - region.centre) -
                           covector.dot(Vec3(q.x(), q.y(), 1.0)) / atCentre) <= 1e-9 / atCentre);
}

TEST(WarpOf, GoesOnAsTheCovectorTurnsNegative) {
    // From where the pull sets in, through zero at the centre and beyond: one warp once it is safe.
    Vec2 pulled = warpOf(Vec3(1.0, 0.0, 0.9), Square, Vec2::Zero());
    (void)pullIntoSafeSet(Square, Vec2::Zero(), 0.0, pulled);
    for (const double atCentre : {0.5, 1e-9, 0.0, -1e-9, -3.0, -1e9}) {
        Vec2 warp = warpOf(Vec3(1.0, 0.0, atCentre), Square, Vec2::Zero());
        EXPECT_TRUE(warp.allFinite());
        EXPECT_LT(pullIntoSafeSet(Square, Vec2::Zero(), 0.0, warp), 1.0);
        EXPECT_NEAR((warp - pulled).norm(), 0.0, 1e-12);
    }
}

TEST(WarpOf, WithoutSlopeIsNone) {
    EXPECT_EQ(warpOf(Vec3(0.0, 0.0, 2.0), Square, Vec2::Zero()), Vec2::Zero());
    EXPECT_EQ(warpOf(Vec3::Zero(), Square, Vec2::Zero()), Vec2::Zero());
}
