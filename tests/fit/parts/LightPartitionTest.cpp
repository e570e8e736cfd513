/** Who is served by which map, against definitions by other means. */
#include "fit/parts/LightPartition.h"

#include "fit/Oracle.h"
#include "fit/focus/ViewVolume.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// Whether a point keeps away from every border between parts, relative to its distance.
bool isClearOfBorders(const LightPartition& parts, const Vec3& ws) {
    for (const ShadowPart& part : parts.span())
        for (const HalfSpace& plane : part.bounds())
            if (std::abs(plane.distance(ws)) < 1e-9 * (ws.norm() + std::abs(plane.offset)))
                return false;
    return true;
}

/// Every point lies within the bounds of the part that serves it, and outside of all others'.
void expectPartition(const LightPartition& parts, const std::vector<Vec3>& points) {
    for (const Vec3& ws : points) {
        if (!isClearOfBorders(parts, ws)) continue;
        const std::size_t serving = parts.serving(ws);
        for (std::size_t i = 0; i < parts.count; ++i) {
            const auto bounds = parts.parts[i].bounds();
            const bool inside = std::ranges::all_of(
                bounds, [&](const HalfSpace& plane) { return plane.distance(ws) >= 0.0; });
            RC_ASSERT(inside == (i == serving));
        }
    }
}

std::vector<Vec3> pointsAround(const Scene& scene, Dice& dice) {
    std::vector<Vec3> points = visiblePoints(scene, dice, 20);
    const Vec3 eye = eyeOf(scene.viewer);
    for (int i = 0; i < 40; ++i)
        points.push_back(eye + scene.size * std::pow(10.0, dice.in(-2.0, 1.0)) * dice.cube());
    return points;
}

/// The plane of the view through which a ray that runs away from the light leaves it, found by
/// walking along the ray: the first that is met on the way out. -1 where there is none.
int exitByWalking(const ConvexVolume& view, const ShadowLight& light, const Vec3& ws) {
    const Vec3 along = -towardsLight(light, ws);
    int exit = -1;
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < view.planes().size(); ++i) {
        const HalfSpace& plane = view.planes()[i];
        const double fall = -plane.normal.dot(along);
        // Rays along a face do not leave through it.
        if (!(fall > 1e-6)) continue;
        const double distance = plane.distance(ws) / fall;
        if (distance >= first) continue;
        first = distance;
        exit = static_cast<int>(i);
    }
    return exit;
}

ShadowLight pointLight(const Scene& scene, Dice& dice, bool inView) {
    ShadowLight light;
    light.kind = LightKind::Point;
    light.nearDistance = 1e-3 * scene.size;
    light.wsPosition = eyeOf(scene.viewer) + scene.size * (inView ? 0.7 : 3.0) * dice.cube();
    return light;
}

} // namespace

/// Depths at which slices meet, ascending.
std::vector<double> anySplits(const Scene& scene, Dice& dice) {
    std::vector<double> splits;
    for (std::size_t i = 0; i < 1 + dice.below(5); ++i)
        splits.push_back(scene.size * std::pow(10.0, dice.in(-2.0, 1.0)));
    std::ranges::sort(splits);
    return splits;
}

TEST(LightPartition, TheWholeLightServesEverything) {
    const LightPartition parts = wholeLight(ShadowLight());
    ASSERT_EQ(parts.count, 1U);
    EXPECT_EQ(parts.serving(Vec3(1.0, 2.0, 3.0)), 0U);
    EXPECT_TRUE(parts.parts[0].bounds().empty());
}

TEST(LightPartition, SlicesAreByDepth) {
    const bool holds = rc::check([] {
        const Scene scene = *anyScene();
        Dice dice(*anySeed());
        const std::vector<double> splits = anySplits(scene, dice);
        const LightPartition parts = sliceView(scene.viewer, scene.light, splits);
        RC_ASSERT(parts.count == splits.size() + 1);
        const auto points = pointsAround(scene, dice);
        expectPartition(parts, points);
        for (const Vec3& ws : points) {
            const double depth = -(scene.viewer.viewFromWorld * ws.homogeneous()).z();
            if (!isClearOfBorders(parts, ws)) continue;
            const auto slice = std::ranges::upper_bound(splits, depth) - splits.begin();
            RC_ASSERT(parts.serving(ws) == static_cast<std::size_t>(slice));
        }
    });
    EXPECT_TRUE(holds);
}

TEST(LightPartition, PaddedSlicesReachFartherAndServeTheSame) {
    const bool holds = rc::check([] {
        const Scene scene = *anyScene();
        Dice dice(*anySeed());
        const std::vector<double> splits = anySplits(scene, dice);
        const double padding = scene.size * dice.in(0.0, 0.5);
        const LightPartition plain = sliceView(scene.viewer, scene.light, splits);
        const LightPartition padded = sliceView(scene.viewer, scene.light, splits, padding);
        const double rounding = 1e-9 * scene.size;
        for (const Vec3& ws : pointsAround(scene, dice)) {
            RC_ASSERT(padded.serving(ws) == plain.serving(ws));
            const double depth = -(scene.viewer.viewFromWorld * ws.homogeneous()).z();
            for (std::size_t i = 0; i < padded.count; ++i) {
                const double begin = i == 0 ? -1e300 : splits[i - 1] - padding;
                const double end = i == splits.size() ? 1e300 : splits[i] + padding;
                if (std::abs(depth - begin) < rounding || std::abs(depth - end) < rounding)
                    continue;
                const auto bounds = padded.parts[i].bounds();
                RC_ASSERT((begin < depth && depth < end) ==
                          std::ranges::all_of(bounds, [&](const HalfSpace& plane) {
                              return plane.distance(ws) >= 0.0;
                          }));
            }
        }
    });
    EXPECT_TRUE(holds);
}

TEST(LightPartition, StripsAreByTheLightImage) {
    const bool holds = rc::check([] {
        const Scene scene = *anyScene();
        Dice dice(*anySeed());
        const LightImage image(scene.light);
        const double angle = dice.in(0.0, 2.0 * std::numbers::pi);
        const Vec2 liDirection(std::cos(angle), std::sin(angle));
        const double liSize = image.directional() ? scene.size : 1.0;
        std::vector<double> splits;
        for (std::size_t i = 0; i < 1 + dice.below(5); ++i)
            splits.push_back(liSize * dice.in(-1.0, 1.0));
        std::ranges::sort(splits);
        const LightPartition parts = stripLight(scene.light, image, liDirection, splits);
        RC_ASSERT(parts.count == splits.size() + 1);
        std::vector<Vec3> points = pointsAround(scene, dice);
        // What is behind a lamp has no image.
        std::erase_if(points, [&](const Vec3& ws) {
            return !image.directional() && !(-image.lsFromPoint(ws).z() > 0.0);
        });
        expectPartition(parts, points);
        for (const Vec3& ws : points) {
            if (!isClearOfBorders(parts, ws)) continue;
            const double at = liDirection.dot(image.project(image.lsFromPoint(ws)));
            const auto strip = std::ranges::upper_bound(splits, at) - splits.begin();
            RC_ASSERT(parts.serving(ws) == static_cast<std::size_t>(strip));
        }
    });
    EXPECT_TRUE(holds);
}

TEST(LightPartition, SevenSplitsAreTheMost) {
    const std::vector<double> splits{1, 2, 3, 4, 5, 6, 7, 8, 9};
    const LightPartition parts = sliceView(ShadowViewer(), ShadowLight(), splits);
    EXPECT_EQ(parts.count, LightPartition::Capacity);
    for (const ShadowPart& part : parts.span())
        EXPECT_EQ(part.boundCount, part.wsBounds.size()) << "one with each of the others";
}

TEST(LightPartition, ACubesFacesAreByTheGreatestCoordinate) {
    const bool holds = rc::check([] {
        const Scene scene = *anyScene();
        Dice dice(*anySeed());
        const ShadowLight light = pointLight(scene, dice, true);
        const LightPartition parts = cubeAround(light);
        RC_ASSERT(parts.count == 6U);
        const auto points = pointsAround(scene, dice);
        expectPartition(parts, points);
        for (const Vec3& ws : points) {
            const Vec3 away = ws - light.wsPosition;
            if (!isClearOfBorders(parts, ws)) continue;
            Eigen::Index axis = 0;
            away.cwiseAbs().maxCoeff(&axis);
            const ShadowLight& face = parts.parts[parts.serving(ws)].light;
            RC_ASSERT(face.wsDirection[axis] * away[axis] > 0.0);
            // In the spot's cone, and not nearer to it than its near distance allows.
            RC_ASSERT(away.dot(face.wsDirection) >=
                      std::cos(face.outerHalfAngle) * away.norm() * (1.0 - 1e-12));
            RC_ASSERT(away.dot(face.wsDirection) * light.nearDistance >=
                      face.nearDistance * away.norm() * (1.0 - 1e-12));
        }
    });
    EXPECT_TRUE(holds);
}

TEST(LightPartition, FacesOfTheViewAreWhereRaysLeaveIt) {
    std::size_t checked = 0;
    std::array<std::size_t, 8> counts{};
    const bool holds = rc::check([&] {
        const Scene scene = *anyScene();
        Dice dice(*anySeed());
        const bool directional = dice.chance(0.5);
        const ShadowLight light =
            directional ? scene.light : pointLight(scene, dice, dice.chance(0.5));
        AimScratch scratch;
        const LightPartition parts = facesOfView(scene.viewer, light, scratch);
        RC_ASSERT(parts.count >= 1U);
        const ConvexVolume view = viewVolume(scene.viewer);
        if (directional && light.kind == LightKind::Directional) ++counts.at(parts.count);
        const auto points = pointsAround(scene, dice);
        expectPartition(parts, points);
        for (const Vec3& ws : points) {
            if (!sees(scene.viewer, ws) || !isClearOfBorders(parts, ws)) continue;
            const int exit = exitByWalking(view, light, ws);
            if (exit < 0) continue;                          // a view without end
            if (parts.parts[0].wsExit.isZero(0.0)) continue; // a cube instead
            const HalfSpace& plane = view.planes()[static_cast<std::size_t>(exit)];
            const ShadowPart& part = parts.parts[parts.serving(ws)];
            RC_LOG() << "point " << ws.transpose() << " leaves through " << plane.normal.transpose()
                     << ", serving " << part.wsExit.transpose() << "\n";
            RC_ASSERT((part.wsExit.head<3>() - plane.normal).norm() < 1e-9);
            if (light.kind == LightKind::Point) {
                const Vec3 away = (ws - part.light.wsPosition).normalized();
                RC_ASSERT(away.dot(part.light.wsDirection.normalized()) >=
                          std::cos(part.light.outerHalfAngle) * (1.0 - 1e-9));
            }
            ++checked;
        }
    });
    EXPECT_TRUE(holds);
    EXPECT_GT(checked, 1000U);
    // "Three to five" for a directional light, and fewer without a far plane.
    EXPECT_GT(counts[3], 0U);
    EXPECT_GT(counts[4], 0U);
    EXPECT_GT(counts[5], 0U);
    EXPECT_EQ(counts[6], 0U);
    EXPECT_EQ(counts[7], 0U);
}

TEST(LightPartition, ALightInTheViewNeedsAllSixFaces) {
    ShadowViewer viewer;
    viewer.clipFromView = perspective(60.0 * Degree, 1.5, 0.1, 100.0);
    ShadowLight light;
    light.kind = LightKind::Point;
    light.wsPosition = Vec3(1.0, 0.5, -20.0);
    AimScratch scratch;
    EXPECT_EQ(facesOfView(viewer, light, scratch).count, 6U);
}

TEST(LightPartition, AnAimedSpotHoldsAllThatAPointLightShadows) {
    std::size_t aimed = 0;
    std::size_t shadowed = 0;
    const bool holds = rc::check([&] {
        Scene scene = *anyScene();
        Dice dice(*anySeed());
        scene.light = pointLight(scene, dice, dice.chance(0.5));
        if (dice.chance(0.3)) scene.light.range = scene.size * dice.in(0.5, 3.0);
        AimScratch scratch;
        const LightPartition parts = aimedSpot(scene.problem(), scratch);
        if (parts.count == 0) return;
        ++aimed;
        RC_ASSERT(parts.count == 1U);
        const ShadowLight& spot = parts.parts[0].light;
        RC_ASSERT(spot.kind == LightKind::Spot);
        RC_ASSERT(spot.outerHalfAngle <= WidestAim);
        for (const ShadowedPoint& point : shadowedPoints(scene, dice, 20)) {
            const Vec3 away = (point.wsReceiver - spot.wsPosition).normalized();
            RC_ASSERT(away.dot(spot.wsDirection) >= std::cos(spot.outerHalfAngle));
            ++shadowed;
        }
    });
    EXPECT_TRUE(holds);
    EXPECT_GT(aimed, 100U);
    EXPECT_GT(shadowed, 100U);
}

TEST(LightPartition, AimingAmongThousandsOfCastersGivesUpAtOnce) {
    // All around the light: as a smallest cone of them all this takes hours.
    Scene scene;
    scene.viewer.clipFromView = perspective(90.0 * Degree, 1.5, 0.1, 500.0);
    scene.light.kind = LightKind::Point;
    scene.light.wsPosition = Vec3(0.0, 0.0, -95.0);
    Dice dice(5);
    for (int i = 0; i < 5000; ++i)
        scene.addBody({100.0 * dice.direction(), Vec3::Ones()});
    AimScratch scratch;
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(aimedSpot(scene.problem(), scratch).count, 0U);
    // Milliseconds; what it must not be is cubic.
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
    scene.light.wsPosition.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(aimedSpot(scene.problem(), scratch).count, 0U);
}

TEST(LightPartition, WhereNoSpotWillDoTheWidestIsAimedAtWhatIsSeen) {
    // A lamp in a room whose walls cast.
    Scene scene;
    scene.viewer.viewFromWorld = lookAlong(Vec3(0.0, 0.0, 4.0), -Vec3::UnitZ());
    scene.viewer.clipFromView = perspective(90.0 * Degree, 1.5, 0.1, 50.0);
    scene.addBody({Vec3::Zero(), Vec3(6.0, 3.0, 6.0)});
    scene.light.kind = LightKind::Point;
    AimScratch scratch;
    ASSERT_EQ(aimedSpot(scene.problem(), scratch).count, 0U);
    std::optional<Vec3> wsAxis;
    const LightPartition parts = widestPart(scene.problem(), scratch, wsAxis);
    ASSERT_EQ(parts.count, 1U);
    EXPECT_FALSE(parts.servesAll);
    const ShadowLight& spot = parts.parts[0].light;
    EXPECT_EQ(spot.outerHalfAngle, WidestAim);
    EXPECT_GT(spot.wsDirection.dot(-Vec3::UnitZ()), 0.99);
    EXPECT_EQ(wsAxis, spot.wsDirection);

    // What is given as seen decides instead of the rays.
    const std::array seen{VisiblePoint{Vec3(6.0, 0.0, 0.0), -Vec3::UnitX()},
                          VisiblePoint{Vec3(0.0, -3.0, 0.0), Vec3::UnitY()},
                          // lit from behind, and out of range
                          VisiblePoint{Vec3(0.0, 0.0, 6.0), Vec3::UnitZ()},
                          VisiblePoint{Vec3(0.0, 0.0, 60.0), -Vec3::UnitZ()}};
    scene.light.range = 50.0;
    ShadowProblem problem = scene.problem();
    problem.visiblePoints = seen;
    const Vec3 axis = widestPart(problem, scratch, wsAxis).parts[0].light.wsDirection;
    EXPECT_LT((axis - Vec3(1.0, -1.0, 0.0).normalized()).norm(), 1e-12);

    // The axis stays while the mean is within 15 degrees of it.
    for (const double degrees : {10.0, -14.0, 16.0}) {
        const Vec3 mean = Eigen::AngleAxisd(degrees * Degree, Vec3::UnitZ()) * axis;
        const std::array one{VisiblePoint{5.0 * mean, -mean}};
        problem.visiblePoints = one;
        const Vec3 kept = widestPart(problem, scratch, wsAxis).parts[0].light.wsDirection;
        if (std::abs(degrees) < 15.0)
            EXPECT_EQ(kept, axis);
        else
            EXPECT_LT((kept - mean).norm(), 1e-12);
    }

    // Nothing that has bounds is seen: as before, or else as the viewer looks.
    scene.receivers.clear();
    scene.receivers.addUnbounded();
    const Vec3 before = *wsAxis;
    EXPECT_EQ(widestPart(scene.problem(), scratch, wsAxis).parts[0].light.wsDirection, before);
    wsAxis.reset();
    EXPECT_EQ(widestPart(scene.problem(), scratch, wsAxis).parts[0].light.wsDirection,
              -Vec3::UnitZ());
}

TEST(LightPartition, AWidestPartThatServesAllIsTheAimedSpot) {
    Scene scene;
    scene.viewer.clipFromView = perspective(60.0 * Degree, 1.5, 0.1, 100.0);
    scene.addBody({Vec3(0.0, 0.0, -20.0), Vec3(4.0, 0.5, 4.0)});
    scene.light.kind = LightKind::Point;
    scene.light.wsPosition = Vec3(0.0, 6.0, -20.0);
    AimScratch scratch;
    std::optional<Vec3> wsAxis;
    const LightPartition parts = widestPart(scene.problem(), scratch, wsAxis);
    EXPECT_TRUE(parts.servesAll);
    EXPECT_FALSE(wsAxis.has_value());
    EXPECT_EQ(parts.parts[0].light.outerHalfAngle,
              aimedSpot(scene.problem(), scratch).parts[0].light.outerHalfAngle);
}

TEST(LightPartition, ALampOverATableIsAimedAtItThoughTheRoomIsAllAround) {
    // The viewer stands in a room that only receives; the table below the lamp is all that casts.
    Scene scene;
    scene.viewer.viewFromWorld = lookAlong(Vec3(0.0, 0.0, 4.0), -Vec3::UnitZ());
    scene.viewer.clipFromView = perspective(90.0 * Degree, 1.5, 0.1, 50.0);
    scene.receivers.add({Vec3::Zero(), Vec3(6.0, 3.0, 6.0)});
    scene.addBody({Vec3(0.0, -1.0, 0.0), Vec3(1.0, 0.05, 0.7)});
    scene.light.kind = LightKind::Point;
    scene.light.wsPosition = Vec3(0.0, 1.5, 0.0);
    AimScratch scratch;
    const LightPartition parts = aimedSpot(scene.problem(), scratch);
    ASSERT_EQ(parts.count, 1U);
    EXPECT_GT(parts.parts[0].light.wsDirection.dot(-Vec3::UnitY()), 0.999);
    EXPECT_LT(parts.parts[0].light.outerHalfAngle, 30.0 * Degree);

    // With the room as a caster there is no such cone.
    scene.addBody({Vec3::Zero(), Vec3(6.0, 3.0, 6.0)});
    EXPECT_EQ(aimedSpot(scene.problem(), scratch).count, 0U);
}
