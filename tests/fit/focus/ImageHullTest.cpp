#include "fit/focus/ImageHull.h"

#include "fit/Problems.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

LightImage anyImage(Dice& dice) {
    ShadowLight light;
    light.wsDirection = dice.direction();
    if (dice.chance(0.5)) {
        light.kind = LightKind::Spot;
        light.wsPosition = dice.cube();
    }
    return LightImage(light);
}

/// Points, many of them equal, on one line, or on one line up to rounding.
std::vector<Vec2> anyImagePoints(Dice& dice) {
    std::vector<Vec2> points;
    const std::size_t count = 1 + dice.below(60);
    const bool coarse = dice.chance(0.4);
    const Vec2 along = dice.direction().head<2>();
    const double height = dice.chance(0.5) ? 1.0 : std::pow(10.0, dice.in(-18.0, -1.0));
    const Vec2 origin = dice.chance(0.5) ? Vec2(0.0, 0.0) : Vec2(100.0 * dice.cube().head<2>());
    for (std::size_t i = 0; i < count; ++i) {
        Vec2 p = dice.cube().head<2>();
        if (coarse) p = (4.0 * p).array().round() / 4.0;
        points.push_back(origin + p.x() * along + p.y() * height * Vec2(-along.y(), along.x()));
    }
    return points;
}

/// The hull of the points: some come one by one, and others many at a time.
ImageHull hullOf(const LightImage& image, std::span<const Vec2> points, Dice& dice) {
    ImageHull hull;
    hull.reset(image);
    while (!points.empty()) {
        const std::size_t count = std::min(points.size(), 1 + dice.below(12));
        hull.add(points.first(count));
        points = points.subspan(count);
    }
    return hull;
}

} // namespace

RC_GTEST_PROP(ImageHull, IsTheHullOfItsPoints, ()) {
    Dice dice(*anySeed());
    const LightImage image = anyImage(dice);
    const std::vector<Vec2> points = anyImagePoints(dice);
    const ImageHull hull = hullOf(image, points, dice);
    // At the tip of a hull that is just wide enough not to be flat.
    const double rounding = 1e-6;
    for (int i = 0; i < 100; ++i) {
        const double angle = dice.in(0.0, 2.0 * std::numbers::pi);
        const Vec2 d(std::cos(angle), std::sin(angle));
        RC_ASSERT(std::abs(support(hull.hull(), d) - support(points, d)) <= rounding);
    }
    // Convex, counter-clockwise, and made of points that were added.
    const Polygon2& polygon = hull.hull();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        RC_ASSERT(std::find(points.begin(), points.end(), polygon[i]) != points.end());
        const Vec2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        for (const Vec2& p : points)
            RC_ASSERT(cross(edge, p - polygon[i]) >= -rounding * edge.norm());
    }
    RC_ASSERT(hull.edges().size() == (polygon.size() > 2 ? polygon.size() : 0U));
}

RC_GTEST_PROP(ImageHull, HasItsEdgesAsPlanesInTheWorld, ()) {
    Dice dice(*anySeed());
    const LightImage image = anyImage(dice);
    const ImageHull hull = hullOf(image, anyImagePoints(dice), dice);
    const Polygon2& polygon = hull.hull();
    for (std::size_t i = 0; i < hull.edges().size(); ++i) {
        const Vec2& a = polygon[i];
        const Vec2 edge = polygon[(i + 1) % polygon.size()] - a;
        const Vec3 ws = image.wsEye() + dice.cube();
        const Vec3 ls = image.lsFromPoint(ws);
        if (!image.directional() && -ls.z() < 0.1) continue;
        const double depth = image.directional() ? 1.0 : -ls.z();
        const double expected = cross(edge, image.project(ls) - a) * depth;
        RC_ASSERT(std::abs(hull.edges()[i].distance(ws) - expected) < 1e-11 * edge.norm());
    }
}

TEST(ImageHull, CountsItsChanges) {
    ImageHull hull;
    hull.reset(LightImage(ShadowLight{}));
    const auto add = [&](const std::vector<Vec2>& points) { hull.add(points); };
    add({Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)});
    const std::size_t before = hull.revision();
    add({Vec2(0.25, 0.25)});
    add({Vec2(0.5, 0.5), Vec2(1.0, 0.0), Vec2(0.25, 0.5), Vec2(0.0, 0.0), Vec2(0.0, 0.5)});
    EXPECT_EQ(hull.revision(), before);
    add({Vec2(1.0, 1.0)});
    EXPECT_NE(hull.revision(), before);
    EXPECT_EQ(hull.hull().size(), 4U);
    hull.reset(LightImage(ShadowLight{}));
    EXPECT_TRUE(hull.hull().empty());
    EXPECT_TRUE(hull.edges().empty());
}

RC_GTEST_PROP(BoxImage, IsThatOfTheCorners, ()) {
    Dice dice(*anySeed());
    const LightImage image = anyImage(dice);
    const Aabb box{image.wsEye() + image.lsFromWs().transpose() * Vec3(0.5, 0.25, -4.0),
                   dice.cube().cwiseAbs()};
    const auto points = boxImage(image, box);
    const auto ws = corners(box);
    for (std::size_t i = 0; i < 8; ++i)
        RC_ASSERT((points[i] - image.project(image.lsFromPoint(ws[i]))).norm() < 1e-13);
}
