#include "fit/geometry/Polygon2.h"

#include "fit/Problems.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

constexpr double Pi = std::numbers::pi;

Polygon2 hullOf(std::vector<Vec2> points) {
    Polygon2 hull;
    convexHull(points, hull);
    return hull;
}

Polygon2 intersectionOf(const Polygon2& a, const Polygon2& b) {
    Polygon2 result;
    Polygon2 scratch;
    intersect(a, b, result, scratch);
    return result;
}

double areaOf(const Polygon2& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return twice / 2.0;
}

/// The greatest distance that the point lies outside of the polygon's edges; <= 0 inside.
double outside(const Polygon2& polygon, const Vec2& p) {
    double result = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        if (edge.norm() > 0.0) result = std::max(result, -cross(edge.normalized(), p - polygon[i]));
    }
    return result;
}

Vec2 randomPoint(Dice& dice) {
    return Vec3(dice.cube()).head<2>();
}

Polygon2 randomPolygon(Dice& dice, std::size_t points) {
    std::vector<Vec2> cloud;
    for (std::size_t i = 0; i < points; ++i)
        cloud.push_back(randomPoint(dice));
    return hullOf(cloud);
}

Polygon2 regular(std::size_t n, double radius = 1.0) {
    Polygon2 polygon;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2.0 * Pi * static_cast<double>(i) / static_cast<double>(n);
        polygon.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

const Polygon2 Square = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};

} // namespace

TEST(SumWithRectangle, HoldsTheSumOfAnEdgeInManyParts) {
    // Parts of an edge along the rectangle point to either side of it, by rounding: the sum may go
    // back and forth there, and its hull is what it should be.
    const bool holds = rc::check([] {
        Dice dice(*anySeed());
        const double angle = dice.in(0.0, 6.3);
        const Vec2 axis(std::cos(angle), std::sin(angle));
        const Vec2 normal(-axis.y(), axis.x());
        const Vec2 corner = Vec2(dice.in(-9.0, 9.0), dice.in(-9.0, 9.0));
        Polygon2 polygon;
        const std::size_t parts = 2 + dice.below(6);
        const auto side = [&](const Vec2& from, const Vec2& way) {
            for (std::size_t i = 0; i < parts; ++i)
                polygon.push_back(from + static_cast<double>(i) / static_cast<double>(parts) * way);
        };
        side(corner, 3.0 * axis);
        side(corner + 3.0 * axis, normal);
        side(corner + 3.0 * axis + normal, -3.0 * axis);
        side(corner + normal, -normal);
        std::ranges::rotate(polygon, polygon.begin() +
                                         static_cast<std::ptrdiff_t>(dice.below(polygon.size())));
        Polygon2 sum;
        sumWithRectangle(polygon, axis, Vec2(0.01, 0.02), sum);
        Polygon2 hull;
        convexHull(sum, hull);
        double length = 0.0;
        for (std::size_t i = 0; i < hull.size(); ++i)
            length += (hull[(i + 1) % hull.size()] - hull[i]).norm();
        RC_ASSERT(std::abs(length - 2.0 * (3.02 + 1.04)) < 1e-9);
    });
    EXPECT_TRUE(holds);
}

TEST(ConvexHull, OfASquareWithPointsInsideAndOnItsEdges) {
    const Polygon2 hull = hullOf({Vec2(1, 1), Vec2(0.5, 0.5), Vec2(0, 0), Vec2(0.5, 0), Vec2(0, 1),
                                  Vec2(1, 0), Vec2(1, 0.25), Vec2(0, 0)});
    ASSERT_EQ(hull.size(), 4U);
    EXPECT_DOUBLE_EQ(areaOf(hull), 1.0);
}

TEST(ConvexHull, OfNothingAPointAndASegment) {
    EXPECT_TRUE(hullOf({}).empty());
    EXPECT_EQ(hullOf({Vec2(2, 3), Vec2(2, 3), Vec2(2, 3)}), Polygon2{Vec2(2, 3)});
    const Polygon2 segment = hullOf({Vec2(1, 1), Vec2(0, 0), Vec2(3, 3), Vec2(2, 2)});
    EXPECT_EQ(segment, (Polygon2{Vec2(0, 0), Vec2(3, 3)}));
}

RC_GTEST_PROP(ConvexHull, HoldsItsPointsAndTurnsLeft, ()) {
    Dice dice = anyDice();
    const std::size_t count = 1 + dice.below(80);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i)
        // A coarse grid makes collinear and equal points.
        points.push_back(dice.chance(0.5) ? randomPoint(dice)
                                          : Vec2((4.0 * randomPoint(dice)).array().round() / 4.0));
    const Polygon2 hull = hullOf(points);
    if (hull.size() < 3) return;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2& b = hull[(i + 1) % hull.size()];
        RC_ASSERT(cross(b - hull[i], hull[(i + 2) % hull.size()] - b) > 0.0);
        RC_ASSERT(std::find(points.begin(), points.end(), b) != points.end());
    }
    for (const Vec2& p : points)
        RC_ASSERT(outside(hull, p) <= 1e-15);
}

RC_GTEST_PROP(ConvexHull, OfPointsOnALineButForRoundingIsThatSegment, ()) {
    // A receiver seen edge-on: columns of points that differ in the last bits.
    Dice dice = anyDice();
    const Vec2 along = Vec2(dice.in(-1.0, 1.0), dice.in(-1.0, 1.0)).normalized();
    const Vec2 origin = 100.0 * randomPoint(dice);
    std::vector<Vec2> points;
    double least = 1.0;
    double greatest = -1.0;
    for (int i = 0; i < 40; ++i) {
        const double t = dice.in(-1.0, 1.0);
        least = std::min(least, t);
        greatest = std::max(greatest, t);
        points.push_back(origin + t * along);
    }
    const Polygon2 hull = hullOf(points);
    RC_ASSERT(std::abs(support(hull, along) - along.dot(origin) - greatest) < 1e-12);
    RC_ASSERT(std::abs(support(hull, -along) + along.dot(origin) + least) < 1e-12);
}

TEST(Intersect, OverlappingSquares) {
    Polygon2 shifted = Square;
    for (Vec2& p : shifted)
        p += Vec2(0.5, 0.25);
    const Polygon2 both = intersectionOf(Square, shifted);
    EXPECT_NEAR(areaOf(both), 0.5 * 0.75, 1e-12);
    EXPECT_NEAR(support(both, -Vec2::UnitX()), -0.5, 1e-12);
    EXPECT_NEAR(support(both, Vec2::UnitY()), 1.0, 1e-12);
}

TEST(Intersect, OfOneInsideTheOtherIsTheInnerOne) {
    const Polygon2 inner = regular(7, 0.25);
    const Polygon2 outer = regular(12, 2.0);
    EXPECT_NEAR(areaOf(intersectionOf(inner, outer)), areaOf(inner), 1e-12);
    EXPECT_NEAR(areaOf(intersectionOf(outer, inner)), areaOf(inner), 1e-12);
}

TEST(Intersect, OfPolygonsApartIsEmpty) {
    Polygon2 away = Square;
    for (Vec2& p : away)
        p += Vec2(1.0 + 1e-9, 0.0);
    EXPECT_TRUE(intersectionOf(Square, away).empty());
    EXPECT_TRUE(intersectionOf(Square, {}).empty());
    EXPECT_TRUE(intersectionOf({}, Square).empty());
}

TEST(Intersect, OfPolygonsThatTouchIsWhatTheyTouchIn) {
    Polygon2 beside = Square;
    for (Vec2& p : beside)
        p += Vec2(1.0, 0.0);
    const Polygon2 edge = intersectionOf(Square, beside);
    ASSERT_FALSE(edge.empty());
    EXPECT_NEAR(support(edge, Vec2::UnitX()), 1.0, 1e-12);
    EXPECT_NEAR(support(edge, -Vec2::UnitX()), -1.0, 1e-12);
    EXPECT_NEAR(support(edge, Vec2::UnitY()), 1.0, 1e-12);
    EXPECT_NEAR(support(edge, -Vec2::UnitY()), 0.0, 1e-12);
}

TEST(Intersect, ASegmentAndASquare) {
    const Polygon2 segment = {Vec2(-1.0, 0.5), Vec2(0.25, 0.5)};
    for (const Polygon2& result :
         {intersectionOf(segment, Square), intersectionOf(Square, segment)}) {
        ASSERT_FALSE(result.empty());
        EXPECT_NEAR(support(result, Vec2::UnitX()), 0.25, 1e-12);
        EXPECT_NEAR(support(result, -Vec2::UnitX()), 0.0, 1e-12);
        EXPECT_NEAR(support(result, Vec2::UnitY()), 0.5, 1e-12);
        EXPECT_NEAR(support(result, -Vec2::UnitY()), -0.5, 1e-12);
    }
}

TEST(Intersect, SegmentsThatCrossShareOnePoint) {
    const Polygon2 a = {Vec2(-1, -1), Vec2(1, 1)};
    const Polygon2 b = {Vec2(-1, 1), Vec2(1, -1)};
    const Polygon2 point = intersectionOf(a, b);
    ASSERT_FALSE(point.empty());
    for (const Vec2& p : point)
        EXPECT_LT(p.norm(), 1e-12);
}

TEST(Intersect, SegmentsOfOneLineApartShareNothing) {
    const Polygon2 a = {Vec2(0, 0), Vec2(1, 0)};
    const Polygon2 b = {Vec2(2, 0), Vec2(3, 0)};
    EXPECT_TRUE(intersectionOf(a, b).empty());
}

TEST(Intersect, APointIsInASquareOrNot) {
    const Polygon2 inside = {Vec2(0.25, 0.5)};
    const Polygon2 apart = {Vec2(1.25, 0.5)};
    EXPECT_EQ(intersectionOf(Square, inside), inside);
    EXPECT_EQ(intersectionOf(inside, Square), inside);
    EXPECT_TRUE(intersectionOf(Square, apart).empty());
    EXPECT_TRUE(intersectionOf(apart, Square).empty());
}

TEST(Intersect, TwoPointsApartShareNothing) {
    EXPECT_TRUE(intersectionOf({Vec2(0, 0)}, {Vec2(1, 0)}).empty());
    EXPECT_EQ(intersectionOf({Vec2(1, 0)}, {Vec2(1, 0)}), (Polygon2{Vec2(1, 0)}));
}

TEST(Intersect, APointBesideASegmentIsNotOnIt) {
    const Polygon2 segment = {Vec2(0, 0), Vec2(1, 0)};
    for (const Vec2& apart : {Vec2(0.5, 0.25), Vec2(2.0, 0.0)}) {
        EXPECT_TRUE(intersectionOf(segment, {apart}).empty()) << apart.transpose();
        EXPECT_TRUE(intersectionOf({apart}, segment).empty()) << apart.transpose();
    }
}

RC_GTEST_PROP(Intersect, HoldsExactlyThePointsOfBoth, ()) {
    Dice dice = anyDice();
    const Polygon2 a = randomPolygon(dice, 3 + dice.below(12));
    Polygon2 b = randomPolygon(dice, 3 + dice.below(12));
    const Vec2 shift = 0.7 * randomPoint(dice);
    for (Vec2& p : b)
        p += shift;
    const Polygon2 both = intersectionOf(a, b);
    for (const Vec2& p : both) {
        RC_ASSERT(outside(a, p) < 1e-12);
        RC_ASSERT(outside(b, p) < 1e-12);
    }
    for (int i = 0; i < 60; ++i) {
        const Vec2 p = 1.5 * randomPoint(dice);
        if (outside(a, p) > 0.0 || outside(b, p) > 0.0) continue;
        RC_ASSERT(!both.empty());
        RC_ASSERT(outside(hullOf(both), p) < 1e-12);
    }
}

TEST(ClipLeftOf, KeepsTheLeftHalfOfASquare) {
    Polygon2 half;
    clipLeftOf(Square, Vec2(0.25, 0.0), Vec2(0.25, 3.0), 0.0, half);
    EXPECT_NEAR(areaOf(half), 0.25, 1e-15);
    clipLeftOf(Square, Vec2(2.0, 2.0), Vec2(2.0, 2.0), 0.0, half);
    EXPECT_EQ(half, Square);
    clipLeftOf(Square, Vec2(-1.0, 0.0), Vec2(-1.0, 1.0), 0.0, half);
    EXPECT_TRUE(half.empty());
    clipLeftOf({}, Vec2(0.0, 0.0), Vec2(1.0, 0.0), 0.0, half);
    EXPECT_TRUE(half.empty());
}

TEST(SumWithRectangle, OfNothingAPointASegmentAndASquare) {
    Polygon2 sum;
    sumWithRectangle({}, Vec2::UnitX(), Vec2::Ones(), sum);
    EXPECT_TRUE(sum.empty());
    sumWithRectangle(Polygon2{Vec2(5.0, 6.0), Vec2(5.0, 6.0)}, Vec2::UnitX(), Vec2(2.0, 1.0), sum);
    EXPECT_EQ(sum, (Polygon2{Vec2(7, 7), Vec2(3, 7), Vec2(3, 5), Vec2(7, 5)}));
    sumWithRectangle(Polygon2{Vec2(0, 0), Vec2(3, 0)}, Vec2::UnitX(), Vec2(2.0, 1.0), sum);
    EXPECT_NEAR(areaOf(sum), 7.0 * 2.0, 1e-15);
    sumWithRectangle(Square, Vec2::UnitX(), Vec2(2.0, 1.0), sum);
    EXPECT_NEAR(areaOf(sum), 5.0 * 3.0, 1e-15);
    sumWithRectangle(Square, -Vec2::UnitY(), Vec2(2.0, 1.0), sum);
    EXPECT_NEAR(areaOf(sum), 5.0 * 3.0, 1e-15);
}

RC_GTEST_PROP(SumWithRectangle, IsTheHullOfAllSums, ()) {
    Dice dice = anyDice();
    Polygon2 polygon = randomPolygon(dice, 1 + dice.below(12));
    if (dice.chance(0.3)) // slivers, down to segments up to rounding
        for (Vec2& p : polygon)
            p.y() *= std::pow(10.0, dice.in(-17.0, -3.0));
    polygon = hullOf(polygon);
    const double angle = dice.chance(0.3) ? 0.0 : dice.in(0.0, 2.0 * Pi);
    const Vec2 axis(std::cos(angle), std::sin(angle));
    const Vec2 half(dice.in(0.0, 1.0), dice.in(0.0, 1.0));
    Polygon2 sum;
    sumWithRectangle(polygon, axis, half, sum);
    std::vector<Vec2> all;
    for (const Vec2& p : polygon)
        for (const double x : {-half.x(), half.x()})
            for (const double y : {-half.y(), half.y()})
                all.push_back(p + x * axis + y * Vec2(-axis.y(), axis.x()));
    const Polygon2 hull = hullOf(all);
    RC_ASSERT(std::abs(areaOf(sum) - areaOf(hull)) < 1e-12);
    for (const Vec2& p : hull)
        RC_ASSERT(outside(sum, p) < 1e-12);
}

TEST(SteinerPoint, OfKnownPolygons) {
    EXPECT_EQ(steinerPoint({}), Vec2::Zero());
    EXPECT_EQ(steinerPoint(Polygon2{Vec2(3, 4)}), Vec2(3, 4));
    EXPECT_TRUE(steinerPoint(Polygon2{Vec2(1, 2), Vec2(3, 6)}).isApprox(Vec2(2, 4)));
    EXPECT_TRUE(steinerPoint(Square).isApprox(Vec2(0.5, 0.5)));
    // A right isosceles triangle: exterior angles π/2, 3π/4, 3π/4, of a sum of 2π.
    const Polygon2 triangle = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    EXPECT_TRUE(steinerPoint(triangle).isApprox(Vec2(0.375, 0.375)));
    EXPECT_LT(steinerPoint(regular(9)).norm(), 1e-15);
}

TEST(SteinerPoint, DoesNotJumpWhenThePolygonBecomesASegment) {
    // The centroid goes to (1/3, 0) here, whatever the height.
    for (const double height : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0}) {
        const Polygon2 sliver = {Vec2(0, 0), Vec2(1, 0), Vec2(0, height)};
        EXPECT_NEAR(steinerPoint(hullOf(sliver)).x(), 0.5, height) << height;
    }
}

TEST(SteinerPoint, IgnoresARepeatedVertex) {
    // What clipping leaves where two polygons share a vertex.
    const Polygon2 once = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    const Polygon2 twice = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 0), Vec2(0, 1)};
    EXPECT_TRUE(steinerPoint(twice).isApprox(steinerPoint(once)))
        << steinerPoint(twice).transpose() << " instead of " << steinerPoint(once).transpose();
}

RC_GTEST_PROP(SteinerPoint, OfAnIntersectionIsThatOfItsHull, ()) {
    // Everything casts and receives: the hulls share vertices and edges, and clipping one by the
    // other leaves vertices that coincide up to rounding.
    Dice dice = anyDice();
    const Polygon2 a = randomPolygon(dice, 3 + dice.below(9));
    std::vector<Vec2> cloud = a;
    if (dice.chance(0.5)) cloud.push_back(2.0 * randomPoint(dice));
    if (dice.chance(0.5)) cloud.erase(cloud.begin());
    if (cloud.size() < 3) return;
    const Polygon2 b = hullOf(cloud);
    const Polygon2 both = intersectionOf(a, b);
    if (hullOf(both).size() < 3) return;
    // The exact answer from vertices that are further apart than rounding.
    Polygon2 apart;
    for (const Vec2& p : hullOf(both))
        if (apart.empty() || (p - apart.back()).norm() > 1e-10) apart.push_back(p);
    while (apart.size() > 1 && (apart.front() - apart.back()).norm() <= 1e-10)
        apart.pop_back();
    RC_LOG() << "got " << steinerPoint(both).transpose() << " expected "
             << steinerPoint(apart).transpose() << "\n";
    RC_ASSERT((steinerPoint(both) - steinerPoint(apart)).norm() < 1e-6);
}

RC_GTEST_PROP(SteinerPoint, MovesWithThePolygon, ()) {
    Dice dice = anyDice();
    const Polygon2 polygon = randomPolygon(dice, 3 + dice.below(12));
    const Vec2 shift = 1e4 * randomPoint(dice);
    const double angle = dice.in(0.0, 2.0 * Pi);
    const Eigen::Rotation2Dd turn(angle);
    Polygon2 moved;
    for (const Vec2& p : polygon)
        moved.push_back(turn * p + shift);
    RC_ASSERT((steinerPoint(moved) - (turn * steinerPoint(polygon) + shift)).norm() < 1e-9);
    RC_ASSERT(outside(polygon, steinerPoint(polygon)) < 0.0);
}

RC_GTEST_PROP(SteinerPoint, IsAdditive, ()) {
    // What names the Steiner point: s(A + B) = s(A) + s(B) for Minkowski sums.
    Dice dice = anyDice();
    const Polygon2 a = randomPolygon(dice, 3 + dice.below(6));
    const Polygon2 b = randomPolygon(dice, 3 + dice.below(6));
    std::vector<Vec2> sums;
    for (const Vec2& p : a)
        for (const Vec2& q : b)
            sums.push_back(p + q);
    RC_ASSERT((steinerPoint(hullOf(sums)) - steinerPoint(a) - steinerPoint(b)).norm() < 1e-6);
}

TEST(SimplifyOutward, ARegularPolygonOfFortyToSixteen) {
    Polygon2 polygon = regular(40);
    simplifyOutward(polygon, 16);
    EXPECT_LE(polygon.size(), 16U);
    for (const Vec2& p : regular(40))
        EXPECT_LE(outside(polygon, p), 1e-12);
    // A circumscribed 16-gon is 1.3 % larger than the circle; greedy removal may do a bit worse.
    EXPECT_LT(areaOf(polygon), 1.1 * Pi);
}

TEST(SimplifyOutward, LeavesSmallPolygonsAlone) {
    Polygon2 triangle = regular(3);
    simplifyOutward(triangle, 2);
    EXPECT_EQ(triangle, regular(3));
}

TEST(SimplifyOutward, StaysConvexWhereVerticesLieOnALine) {
    // A left side of six vertices that are collinear up to rounding, as clipping leaves them.
    const Polygon2 original = {Vec2(-1.8314919298064078, -0.44638008738316115),
                               Vec2(-1.8314919298064063, -0.57796517874189191),
                               Vec2(-1.8283535000548434, -0.58162786661404808),
                               Vec2(-1.6197547002715902, -0.82507199459937863),
                               Vec2(-1.5812288634644946, -0.86647017741388044),
                               Vec2(-1.5131861252926861, -0.84357434406138609),
                               Vec2(0.027050692493747919, -0.30025975980037295),
                               Vec2(0.027050692493759465, -0.30025975980036751),
                               Vec2(0.060218988602708245, -0.26939279231079089),
                               Vec2(0.0019530833285197335, -0.14619979689748258),
                               Vec2(-1.2737247343878961, 1.2245879104444768),
                               Vec2(-1.3122505711949917, 1.2659860932589786),
                               Vec2(-1.3122505711949992, 1.2659860932589821),
                               Vec2(-1.3454188673039478, 1.2351191257694056),
                               Vec2(-1.8314919298064061, 0.74904606326694756),
                               Vec2(-1.8314919298064072, 0.030334040366953571),
                               Vec2(-1.8314919298064074, -0.12412452579093408),
                               Vec2(-1.8314919298064078, -0.44210481505218713)};
    Polygon2 simple = original;
    simplifyOutward(simple, 16);
    EXPECT_LE(simple.size(), 16U);
    // An edge that runs backwards would be a half plane that holds nothing.
    for (const Vec2& p : original)
        EXPECT_LT(outside(simple, p), 1e-9) << p.transpose();
}

RC_GTEST_PROP(SimplifyOutward, HoldsTheOriginal, ()) {
    Dice dice = anyDice();
    Polygon2 original;
    if (dice.chance(0.5)) {
        original = randomPolygon(dice, 3 + dice.below(200));
    } else {
        // Vertices on an ellipse, some of them nearly equal.
        std::vector<Vec2> cloud;
        for (int i = 0; i < 30; ++i) {
            const double angle = dice.in(0.0, 2.0 * Pi);
            cloud.emplace_back(std::cos(angle), 0.1 * std::sin(angle));
            if (dice.chance(0.3)) cloud.push_back(cloud.back() + 1e-12 * randomPoint(dice));
        }
        original = hullOf(cloud);
    }
    if (dice.chance(0.5)) {
        // Cuts along an axis: whole sides of vertices that are collinear up to rounding.
        Polygon2 cut = {Vec2(-0.5, -2.0), Vec2(0.5, -2.0), Vec2(0.5, 2.0), Vec2(-0.5, 2.0)};
        std::vector<Vec2> points = intersectionOf(original, cut);
        for (int i = 0; i < 8; ++i)
            points.emplace_back(-0.5 * (1.0 + 4e-16 * dice.in(-1.0, 1.0)), dice.in(-0.1, 0.1));
        original = hullOf(points);
    }
    const std::size_t most = 4 + dice.below(13);
    Polygon2 simple = original;
    simplifyOutward(simple, most);
    RC_ASSERT(simple.size() <= most || simple.size() == original.size());
    RC_ASSERT(simple.size() <= most);
    for (const Vec2& p : original)
        RC_ASSERT(outside(simple, p) < 1e-9);
}

TEST(BoundsAt, OfTheUnitSquareTurned) {
    const OrientedRectangle r = boundsAt(Square, Pi / 4.0);
    EXPECT_NEAR(r.area(), 2.0, 1e-12);
    EXPECT_NEAR(r.min.x(), 0.0, 1e-12);
    EXPECT_NEAR(r.max.x(), std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(r.min.y(), -std::sqrt(0.5), 1e-12);
}

TEST(SmallestRectangle, OfDegeneratePolygons) {
    EXPECT_EQ(smallestRectangle({}).area(), 0.0);
    EXPECT_EQ(smallestRectangle(Polygon2{Vec2(5, 6)}).area(), 0.0);
    const OrientedRectangle r = smallestRectangle(Polygon2{Vec2(0, 0), Vec2(3, 4)});
    EXPECT_NEAR((r.max - r.min).maxCoeff(), 5.0, 1e-12);
    EXPECT_NEAR((r.max - r.min).minCoeff(), 0.0, 1e-12);
}

RC_GTEST_PROP(SmallestRectangle, IsAsSmallAsASearchOverAngles, ()) {
    Dice dice = anyDice();
    const Polygon2 polygon = randomPolygon(dice, 3 + dice.below(20));
    const OrientedRectangle best = smallestRectangle(polygon);
    RC_ASSERT(best.angle >= 0.0);
    RC_ASSERT(best.angle < Pi / 2.0);
    const OrientedRectangle again = boundsAt(polygon, best.angle);
    RC_ASSERT(std::abs(again.area() - best.area()) < 1e-12);
    for (int i = 0; i < 900; ++i)
        RC_ASSERT(best.area() <= boundsAt(polygon, i * Pi / 1800.0).area() + 1e-12);
}
