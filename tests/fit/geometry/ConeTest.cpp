#include "fit/geometry/Cone.h"

#include "fit/Problems.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// Half angle of the cone about an axis, as the chord between axis and rim, exact for small ones.
double chordAbout(const Vec3& unitAxis, const std::vector<Vec3>& directions) {
    double chord = 0.0;
    for (const Vec3& d : directions)
        chord = std::max(chord, (d - unitAxis).norm());
    return chord;
}

/// The smallest chord by brute force: over all cones through two or three of the directions.
double smallestChord(const std::vector<Vec3>& directions) {
    double smallest = directions.size() > 1 ? 2.0 : 0.0;
    const auto consider = [&](const Vec3& axis) {
        if (!(axis.norm() > 0.0)) return;
        smallest = std::min(smallest, chordAbout(axis.normalized(), directions));
        smallest = std::min(smallest, chordAbout(-axis.normalized(), directions));
    };
    for (std::size_t i = 0; i < directions.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            consider(directions[i] + directions[j]);
            for (std::size_t k = 0; k < j; ++k)
                consider((directions[j] - directions[i]).cross(directions[k] - directions[i]));
        }
    return smallest;
}

/// Directions of a half space, within a cone as narrow as a millionth or wider than 80°.
std::vector<Vec3> anyDirections(Dice& dice) {
    const std::size_t count = 1 + dice.below(20);
    const Vec3 middle = dice.direction();
    const double spread = std::pow(10.0, dice.in(-6.0, 1.0));
    const double squash = dice.chance(0.5) ? 1.0 : std::pow(10.0, dice.in(-6.0, 0.0));
    const Vec3 side = middle.unitOrthogonal();
    std::vector<Vec3> directions;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 d = dice.cube();
        directions.push_back(
            (middle + spread * (d.x() * side + squash * d.y() * middle.cross(side))).normalized());
        if (dice.chance(0.1)) directions.push_back(directions.back());
    }
    return directions;
}

} // namespace

TEST(SmallestConeAxis, OfNothingIsZero) {
    EXPECT_EQ(smallestConeAxis({}), Vec3::Zero());
}

TEST(SmallestConeAxis, OfOneDirectionIsTheDirection) {
    std::vector<Vec3> one = {Vec3(0.6, 0.0, 0.8)};
    EXPECT_EQ(smallestConeAxis(one), Vec3(0.6, 0.0, 0.8));
    std::vector<Vec3> thrice(3, Vec3(0.6, 0.0, 0.8));
    EXPECT_EQ(smallestConeAxis(thrice), Vec3(0.6, 0.0, 0.8));
}

TEST(SmallestConeAxis, OfASquarePyramidIsItsAxis) {
    std::vector<Vec3> corners;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            corners.push_back(Vec3(x, y, 3.0).normalized());
    corners.push_back(Vec3::UnitZ());
    EXPECT_LT((smallestConeAxis(corners) - Vec3::UnitZ()).norm(), 1e-12);
}

RC_GTEST_PROP(SmallestConeAxis, IsAsNarrowAsTheBestThroughTwoOrThree, ()) {
    Dice dice(*anySeed());
    std::vector<Vec3> directions = anyDirections(dice);
    const double best = smallestChord(directions);
    const Vec3 axis = smallestConeAxis(directions);
    RC_ASSERT(std::abs(axis.norm() - 1.0) < 1e-12);
    RC_LOG() << "found " << chordAbout(axis, directions) << ", best " << best << "\n";
    RC_ASSERT(chordAbout(axis, directions) <= best * (1.0 + 1e-9) + 1e-14);
}

RC_GTEST_PROP(SmallestConeAxis, DoesNotDependOnTheOrder, ()) {
    Dice dice(*anySeed());
    std::vector<Vec3> directions = anyDirections(dice);
    std::vector<Vec3> others(directions.rbegin(), directions.rend());
    const double chord = smallestChord(directions);
    const Vec3 axis = smallestConeAxis(directions);
    RC_ASSERT((axis - smallestConeAxis(others)).norm() <= 1e-6 * chord + 1e-9);
}
