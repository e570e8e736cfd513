// The optimal warp, its measure and its search, against their definitions and brute force.
#include "fit/Problems.h"

#include "fit/core/Fit.h"
#include "fit/core/Warp.h"
#include "fit/rule/WarpSearch.h"
#include "fit/technique/Optimal.h"
#include "fit/technique/Uniform.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// A convex hull of random points and a point in it.
struct Region {
    Polygon2 hull;
    Vec2 centre;
};

Region randomRegion(Dice& dice) {
    std::vector<Vec2> points;
    for (std::size_t i = 3 + dice.below(10); i > 0; --i)
        points.push_back(Vec2(dice.in(-3.0, 5.0), dice.in(-1.0, 1.0)));
    Region region;
    convexHull(points, region.hull);
    region.centre = steinerPoint(region.hull);
    return region;
}

/// Runs `look` on the context of a scene, and gives the fit with the warp that it returns.
template <typename Look>
ShadowFit withContext(const Scene& scene, FitState& state, const Look& look) {
    return fitWithRule(scene.problem(), state, [&](const WarpContext& context, RuleState memory) {
        return WarpChoice{look(context, memory), FitReason::None};
    });
}

/// The expected extent, relative to a uniform map's, of the least warp on a fine polar grid.
double bruteForce(WarpSearch& search) {
    double least = 1.0;
    constexpr int Turns = 90;
    for (int i = 0; i < Turns; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / Turns;
        for (double s = 0.05; s <= WarpSearch::GreatestSpread; s += 0.05)
            least = std::min(least, search(s * Vec2(std::cos(angle), std::sin(angle))));
    }
    return least;
}

/// The hull's greatest coordinate about the centre.
double sizeOf(const Region& region) {
    double size = 0.0;
    for (const Vec2& vertex : region.hull)
        size = std::max(size, (vertex - region.centre).cwiseAbs().maxCoeff());
    return size;
}

} // namespace

RC_GTEST_PROP(WarpSearch, SpreadIsTheLogRatioOfDenominators, ()) {
    Dice dice(*anySeed());
    const Region region = randomRegion(dice);
    const double angle = dice.in(0.0, 2.0 * std::numbers::pi);
    const Vec2 spread = dice.in(0.01, 8.0) * Vec2(std::cos(angle), std::sin(angle));
    const Vec2 warp = warpOfSpread(region.hull, region.centre, spread);
    double least = 1e300;
    double greatest = 0.0;
    for (const Vec2& vertex : region.hull) {
        const double denominator = 1.0 + warp.dot(vertex - region.centre);
        least = std::min(least, denominator);
        greatest = std::max(greatest, denominator);
    }
    RC_ASSERT(least > 0.0);
    RC_ASSERT(std::abs(std::log(greatest / least) - spread.norm()) < 1e-8);
    RC_ASSERT((spreadOfWarp(region.hull, region.centre, warp) - spread).norm() < 1e-8);
}

TEST(WarpSearch, NoSpreadIsNoWarpAndAPointHasNone) {
    const Polygon2 point{Vec2(2.0, 3.0)};
    EXPECT_EQ(warpOfSpread(point, point[0], Vec2(1.0, 1.0)), Vec2::Zero());
    const Polygon2 triangle{Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(0.0, 1.0)};
    EXPECT_EQ(warpOfSpread(triangle, Vec2(0.2, 0.2), Vec2::Zero()), Vec2::Zero());
    EXPECT_EQ(spreadOfWarp(triangle, Vec2(0.2, 0.2), Vec2::Zero()), Vec2::Zero());
}

RC_GTEST_PROP(TexelExtent, IsTheMeanOfItsDefinition, ()) {
    // (mean of |d li / d texel|^(3/4) |d ndc / d texel|^(1/2))^(4/5), by differences of the map's
    // own formula. The light image is brought to the hull's size.
    Dice dice(*anySeed());
    const Region region = randomRegion(dice);
    RC_PRE(region.hull.size() > 2U);
    const double angle = dice.in(0.0, 2.0 * std::numbers::pi);
    const Vec2 warp = warpOfSpread(region.hull, region.centre,
                                   dice.in(0.0, 3.0) * Vec2(std::cos(angle), std::sin(angle)));
    std::vector<ViewSample> samples(5);
    for (ViewSample& sample : samples) {
        // Somewhere between a vertex and the centre.
        const Vec2& vertex = region.hull[dice.below(region.hull.size())];
        sample.liPoint = region.centre + dice.in(0.0, 1.0) * (vertex - region.centre);
        for (double& entry : sample.ndcFromLi.reshaped())
            entry = dice.in(-1.0, 1.0);
        RC_PRE(std::abs(sample.ndcFromLi.determinant()) > 1e-3);
        sample.weight = dice.in(0.0, 3.0);
    }
    const auto warped = [&](const Vec2& li) {
        const Vec2 q = li - region.centre;
        return Vec2(q / (1.0 + warp.dot(q)));
    };
    Polygon2 hull;
    for (const Vec2& vertex : region.hull)
        hull.push_back(warped(vertex));
    const double area = smallestRectangle(hull).area();
    RC_PRE(area > 1e-9);
    const auto meanFor = [&](const OrientedRectangle& map) {
        const auto texel = [&](const Vec2& li) {
            const Vec2 p = warped(li);
            const Vec2 u(std::cos(map.angle), std::sin(map.angle));
            return Vec2(u.dot(p) / (map.max.x() - map.min.x()),
                        cross(u, p) / (map.max.y() - map.min.y()));
        };
        double sum = 0.0;
        for (const ViewSample& sample : samples) {
            constexpr double Step = 1e-6;
            Eigen::Matrix2d texelFromLi;
            for (int axis = 0; axis < 2; ++axis) {
                const Vec2 step = Step * Vec2::Unit(axis);
                texelFromLi.col(axis) =
                    (texel(sample.liPoint + step) - texel(sample.liPoint - step)) / (2.0 * Step);
            }
            const Eigen::Matrix2d liFromTexel = texelFromLi.inverse();
            sum += sample.weight * std::pow(liFromTexel.norm() / sizeOf(region), 0.75) *
                   std::sqrt((sample.ndcFromLi * liFromTexel).norm());
        }
        return std::pow(sum / static_cast<double>(samples.size()), 0.8);
    };
    TexelExtent extent;
    extent.reset(samples, region.hull, region.centre);
    RC_ASSERT(extent.hasSamples());
    const double mean = extent(warp);
    // Rectangles whose areas are the same up to rounding are equally small: a triangle has three.
    bool found = false;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2 edge = hull[(i + 1) % hull.size()] - hull[i];
        const OrientedRectangle map = boundsAt(hull, std::atan2(edge.y(), edge.x()));
        if (!(map.area() <= area * (1.0 + 1e-9))) continue;
        const double expected = meanFor(map);
        RC_LOG() << mean << " where " << expected << " is expected\n";
        // Values agree up to rounding of differences.
        found = found || std::abs(mean - expected) < 1e-4 * expected;
    }
    RC_ASSERT(found);
}

RC_GTEST_PROP(TexelExtent, ItsMapIsASmallestRectangle, ()) {
    Dice dice(*anySeed());
    const Region region = randomRegion(dice);
    // In whole fours and one more, filled up with the first vertex.
    const std::size_t count = (region.hull.size() + 3) / 4 * 4;
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t i = 0; i <= count; ++i) {
        const Vec2& vertex = region.hull[i < region.hull.size() ? i : 0];
        x.push_back(vertex.x());
        y.push_back(vertex.y());
    }
    const MapSides map = smallestMap(x.data(), y.data(), count);
    const OrientedRectangle slow = smallestRectangle(region.hull);
    RC_ASSERT(std::abs(map.u.norm() * map.v.norm() - slow.area()) <= 1e-12 * slow.area() + 1e-14);
    RC_ASSERT(std::abs(map.u.dot(map.v)) <= 1e-12 * map.u.norm() * map.v.norm());
    // As wide along its sides as the polygon is.
    for (const Vec2& side : {map.u, map.v}) {
        if (!(side.norm() > 0.0)) continue;
        const Vec2 axis = side.normalized();
        const double width = support(region.hull, axis) + support(region.hull, -axis);
        RC_ASSERT(std::abs(side.norm() - width) < 1e-12 * (1.0 + width));
    }
}

RC_GTEST_PROP(TexelExtent, ChoosesAxesThatAreNoWorseThanTheRectangle, ()) {
    Dice dice(*anySeed());
    const Region region = randomRegion(dice);
    RC_PRE(region.hull.size() > 2U);
    std::vector<ViewSample> samples(7);
    for (ViewSample& sample : samples) {
        sample.liPoint = region.centre;
        for (double& entry : sample.ndcFromLi.reshaped())
            entry = dice.in(-1.0, 1.0);
    }
    TexelExtent extent;
    extent.reset(samples, region.hull, region.centre);
    const double rectangle = extent(Vec2::Zero());
    RC_PRE(rectangle > 1e-9);
    // Without a warp the sides that axes make are those of every texel.
    const auto meanFor = [&](const MapAxes& axes) {
        Eigen::Matrix2d mapFromLi;
        for (const Eigen::Index i : {0, 1}) {
            const Vec2& n = axes.normals[static_cast<std::size_t>(i)];
            mapFromLi.row(i) = n.transpose() / (support(region.hull, n) + support(region.hull, -n));
        }
        const Eigen::Matrix2d sides = mapFromLi.inverse();
        double sum = 0.0;
        for (const ViewSample& sample : samples)
            sum += std::pow(sides.norm() / sizeOf(region), 0.75) *
                   std::sqrt((sample.ndcFromLi * sides).norm());
        return std::pow(sum / static_cast<double>(samples.size()), 0.8);
    };
    const auto axes = extent.chooseAxes(Vec2::Zero(), std::nullopt);
    RC_ASSERT(axes.has_value());
    RC_ASSERT(!axes->kept);
    RC_ASSERT(cross(axes->normals[0], axes->normals[1]) > 0.0);
    const double chosen = meanFor(*axes);
    RC_ASSERT(chosen <= rectangle * (1.0 + 1e-9));
    // No pair of edges is better by more than what is asked of a parallelogram.
    const auto normalOf = [&](std::size_t i) {
        const Vec2 edge = region.hull[(i + 1) % region.hull.size()] - region.hull[i];
        return Vec2(Vec2(-edge.y(), edge.x()).normalized());
    };
    for (std::size_t i = 0; i < region.hull.size(); ++i)
        for (std::size_t k = i + 1; k < region.hull.size(); ++k) {
            MapAxes other{{normalOf(i), normalOf(k)}};
            if (cross(other.normals[0], other.normals[1]) < 0.0) other.normals[1] *= -1.0;
            // Nearly parallel, or too large to be judged.
            const auto [a, b] = other.normals;
            const double area = (support(region.hull, a) + support(region.hull, -a)) *
                                (support(region.hull, b) + support(region.hull, -b)) / cross(a, b);
            if (cross(a, b) < 0.11 || area > 1.19 * smallestRectangle(region.hull).area()) continue;
            RC_ASSERT(meanFor(other) >= chosen * (1.0 - 0.021));
        }
    // What was chosen is kept, to the last bit.
    const auto again = extent.chooseAxes(Vec2::Zero(), axes);
    RC_ASSERT(again.has_value());
    RC_ASSERT(again->kept);
    RC_ASSERT(again->normals == axes->normals);
}

TEST(TexelExtent, AParallelogramThatIsSeenAsASquareBecomesTheMap) {
    // The sides (4, 0) and (3, 2), which the viewer sees at right angles and as long as each other.
    const Polygon2 hull{Vec2(0.0, 0.0), Vec2(4.0, 0.0), Vec2(7.0, 2.0), Vec2(3.0, 2.0)};
    Eigen::Matrix2d sides;
    sides << 4.0, 3.0, 0.0, 2.0;
    ViewSample sample;
    sample.liPoint = Vec2(3.5, 1.0);
    sample.ndcFromLi = sides.inverse();
    TexelExtent extent;
    extent.reset({sample}, hull, sample.liPoint);
    const auto axes = extent.chooseAxes(Vec2::Zero(), std::nullopt);
    ASSERT_TRUE(axes.has_value());
    const Vec2 across = Vec2(-2.0, 3.0).normalized(); // normal of the side (3, 2)
    const auto has = [&](const Vec2& normal) {
        return std::ranges::any_of(
            axes->normals, [&](const Vec2& own) { return std::abs(cross(own, normal)) < 1e-12; });
    };
    EXPECT_TRUE(has(Vec2::UnitY()));
    EXPECT_TRUE(has(across));
    // A far better one is not given up for the last map's rectangle; nor a point's for anything.
    const MapAxes last{{Vec2::UnitX(), Vec2::UnitY()}};
    EXPECT_FALSE(extent.chooseAxes(Vec2::Zero(), last)->kept);
    extent.reset({sample}, {sample.liPoint}, sample.liPoint);
    EXPECT_FALSE(extent.chooseAxes(Vec2::Zero(), last).has_value());
}

TEST(TexelExtent, TheMapOfAPointHasNoSidesAndThatOfASegmentOne) {
    const std::array<double, 5> x{1.0, 1.0, 1.0, 1.0, 1.0};
    const MapSides none = smallestMap(x.data(), x.data(), 4);
    EXPECT_EQ(none.u, Vec2(0.0, 0.0));
    EXPECT_EQ(none.v, Vec2(0.0, 0.0));
    const std::array<double, 5> y{1.0, 3.0, 1.0, 1.0, 1.0};
    const MapSides one = smallestMap(x.data(), y.data(), 4);
    EXPECT_EQ(one.u.norm() + one.v.norm(), 2.0);
}

RC_GTEST_PROP(Optimal, IsNeverExpectedToBeWorseThanUniform, ()) {
    const Scene scene = *anyScene();
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), OptimalOptions{}, state);
    if (!fit.hasMap()) return;
    FitState other;
    double cost = 0.0;
    (void)withContext(scene, other, [&](const WarpContext& context, RuleState memory) {
        WarpSearch search(context, {.most = 64}, memory);
        if (search.usable()) cost = search(search.spread(fit.liWarp));
        return Vec2(0.0, 0.0);
    });
    RC_LOG() << "expected extent " << cost << " of a uniform map's, warp " << fit.liWarp.transpose()
             << ", " << fit.reason << "\n";
    RC_ASSERT(cost <= 1.0 + 1e-9);
}

TEST(Optimal, FindsWhatBruteForceFinds) {
    double sum = 0.0;
    for (const double turn : {0.0, 0.5, 1.3, 2.2, 3.1}) {
        for (const double elevation : {0.2, 0.7, 1.3}) {
            Scene scene = outdoors();
            scene.light.wsDirection =
                Vec3(std::cos(elevation) * std::sin(turn), -std::sin(elevation),
                     std::cos(elevation) * std::cos(turn));
            FitState state;
            FitState generous;
            const ShadowFit fit = fitMap(scene.problem(), OptimalOptions{}, state);
            const ShadowFit best = fitMap(
                scene.problem(), OptimalOptions{.samples = 64, .evaluations = 400}, generous);
            ASSERT_TRUE(fit.hasMap()) << fit.reason;
            FitState other;
            (void)withContext(scene, other, [&](const WarpContext& context, RuleState memory) {
                WarpSearch search(context, {.most = 64}, memory);
                EXPECT_TRUE(search.usable());
                const double least = bruteForce(search);
                const double ratio = search(search.spread(fit.liWarp)) / least;
                sum += std::log(ratio);
                EXPECT_LT(ratio, 1.2) << turn << ", " << elevation;
                EXPECT_LT(search(search.spread(best.liWarp)), 1.02 * least)
                    << turn << ", " << elevation;
                return Vec2(0.0, 0.0);
            });
        }
    }
    // A search with few evaluations misses narrow valleys, where the map's orientation changes.
    EXPECT_LT(std::exp(sum / 15.0), 1.05);
}

TEST(Optimal, JudgesByTheApplicationsPointsWhereThereAreAny) {
    // Points at the far end alone leave nothing to gain from favouring the near.
    const Scene scene = outdoors();
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), OptimalOptions{}, state);
    std::vector<VisiblePoint> points;
    for (int i = 0; i < 32; ++i)
        points.push_back({Vec3(-4.0 + 0.25 * i, -2.0, -26.0), Vec3::UnitY()});
    ShadowProblem problem = scene.problem();
    problem.visiblePoints = points;
    FitState other;
    const ShadowFit far = fitMap(problem, OptimalOptions{}, other);
    ASSERT_TRUE(fit.hasMap());
    ASSERT_TRUE(far.hasMap());
    const Vec3 wsNear(0.0, -2.0, -5.0);
    const Vec3 wsFar(0.0, -2.0, -26.0);
    const auto denominators = [&](const ShadowFit& one) {
        const double atNear = clipOf(one.clipFromWorld, wsNear).w();
        const double atFar = clipOf(one.clipFromWorld, wsFar).w();
        return atFar / atNear;
    };
    EXPECT_GT(denominators(fit), 2.0);
    EXPECT_LT(denominators(far), 1.0);
}

TEST(Optimal, GarbageOptionsGiveAFiniteMap) {
    for (const int samples : {-5, 0, 1, 1 << 30})
        for (const int evaluations : {-5, 0, 1, 3, 9}) {
            FitState state;
            const ShadowFit fit =
                fitMap(outdoors().problem(), OptimalOptions{samples, evaluations}, state);
            ASSERT_TRUE(fit.hasMap()) << samples << ", " << evaluations;
            ASSERT_TRUE(fit.clipFromWorld.allFinite());
        }
}

TEST(Optimal, FollowingFindsWhatSearchingAnewFinds) {
    double sum = 0.0;
    double worst = 0.0;
    int count = 0;
    for (const double turn : {0.0, 0.5, 1.3, 2.2, 3.1})
        for (const double elevation : {0.2, 0.7, 1.3}) {
            Scene scene = outdoors();
            scene.light.wsDirection =
                Vec3(std::cos(elevation) * std::sin(turn), -std::sin(elevation),
                     std::cos(elevation) * std::cos(turn));
            FitState followed;
            ShadowFit fit;
            // The viewer turns by a fifth of a degree in each frame.
            for (int frame = 0; frame <= 60; ++frame) {
                const double heading = 0.0035 * (frame - 60);
                scene.viewer.viewFromWorld =
                    lookAlong(Vec3::Zero(), Vec3(std::sin(heading), -0.1, -std::cos(heading)));
                fit = fitMap(scene.problem(), OptimalOptions{}, followed);
                ASSERT_TRUE(fit.hasMap()) << fit.reason;
            }
            FitState fresh;
            const ShadowFit anew = fitMap(scene.problem(), OptimalOptions{}, fresh);
            FitState other;
            (void)withContext(scene, other, [&](const WarpContext& context, RuleState memory) {
                WarpSearch search(context, {.most = 64}, memory);
                const double ratio =
                    search(search.spread(fit.liWarp)) / search(search.spread(anew.liWarp));
                sum += std::log(ratio);
                worst = std::max(worst, ratio);
                ++count;
                return Vec2(0.0, 0.0);
            });
        }
    EXPECT_LT(std::exp(sum / count), 1.02);
    EXPECT_LT(worst, 1.2);
}

TEST(Optimal, ACameraCutIsFollowedAtOnce) {
    const Scene scene = outdoors();
    Scene before = scene;
    before.viewer.viewFromWorld = lookAlong(Vec3::Zero(), Vec3(0.3, -0.2, 1.0));
    before.addBody({Vec3(2.0, -1.0, 9.0), Vec3(1.0, 1.0, 1.0)});
    FitState fresh;
    FitState used;
    (void)fitMap(before.problem(), OptimalOptions{}, used);
    const ShadowFit a = fitMap(scene.problem(), OptimalOptions{}, fresh);
    const ShadowFit b = fitMap(scene.problem(), OptimalOptions{}, used);
    EXPECT_EQ(a.liWarp, b.liWarp);
}
