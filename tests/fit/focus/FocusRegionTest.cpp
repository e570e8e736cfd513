#include "fit/focus/FocusRegion.h"

#include "fit/Oracle.h"
#include "fit/focus/ViewVolume.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

FocusRegion regionOf(const Scene& scene) {
    FocusScratch scratch;
    FocusRegion region;
    findFocusRegion(scene.problem(), LightImage(scene.light), scratch, region);
    return region;
}

/// The extent of the region's hull along a world direction across a directional light.
double extentAlong(const Scene& scene, const FocusRegion& region, const Vec3& ws) {
    const Vec2 d = LightImage(scene.light).lsFromDirection(ws).head<2>();
    return support(region.liHull, d);
}

/// Noon: a viewer at height 10 looks straight down at a flat ground of 20 x 20, and sees of it
/// 8 x 8; the light shines straight down too.
Scene noon() {
    Scene scene;
    scene.viewer.viewFromWorld =
        lookAlong(Vec3(0.0, 10.0, 0.0), -Vec3::UnitY(), Vec3(0.0, 0.0, -1.0));
    scene.viewer.clipFromView = orthographic(4.0, 4.0, 0.1, 100.0);
    scene.light.wsDirection = Vec3(0.0, -1.0, 0.0);
    scene.receivers.add({Vec3::Zero(), Vec3(10.0, 0.0, 10.0)});
    return scene;
}

Scene lampOverFloor() {
    Scene scene = noon();
    scene.light.kind = LightKind::Spot;
    scene.light.wsPosition = Vec3(0.0, 4.0, 0.0);
    scene.light.outerHalfAngle = std::numbers::pi / 8.0;
    scene.light.nearDistance = 0.5;
    return scene;
}

} // namespace

TEST(FocusRegion, IsTheCastersImageOnALargeGround) {
    Scene scene = noon();
    scene.casters.add({Vec3(1.0, 3.0, -0.5), Vec3(0.5, 1.0, 0.25)});
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::None);
    EXPECT_NEAR(extentAlong(scene, region, Vec3::UnitX()), 1.5, 1e-12);
    EXPECT_NEAR(extentAlong(scene, region, -Vec3::UnitX()), -0.5, 1e-12);
    EXPECT_NEAR(extentAlong(scene, region, Vec3::UnitZ()), -0.25, 1e-12);
    EXPECT_NEAR(extentAlong(scene, region, -Vec3::UnitZ()), 0.75, 1e-12);
    // Depths are distances along the light from the origin.
    EXPECT_NEAR(region.lsReceiverNear, 0.0, 1e-12);
    EXPECT_NEAR(region.lsReceiverFar, 0.0, 1e-12);
    EXPECT_NEAR(region.lsCasterNear, -4.0, 1e-12);
    EXPECT_NEAR(region.vsReceiverNear, 10.0, 1e-12);
    EXPECT_NEAR(region.vsReceiverFar, 10.0, 1e-12);
}

TEST(FocusRegion, IsWhatTheViewerSeesUnderALargeCaster) {
    Scene scene = noon();
    scene.casters.add({Vec3(0.0, 50.0, 0.0), Vec3(30.0, 1.0, 30.0)});
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::None);
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
        EXPECT_NEAR(extentAlong(scene, region, axis), 4.0, 1e-12);
}

TEST(FocusRegion, TakesACasterOutsideTheViewWhoseShadowIsInIt) {
    Scene scene = noon();
    scene.light.wsDirection = Vec3(-1.0, -1.0, 0.0);
    scene.casters.add({Vec3(9.0, 8.0, 0.0), Vec3(0.5, 0.5, 0.5)});
    EXPECT_EQ(regionOf(scene).reason, FitReason::None);
    // From the other side its shadow falls where nobody looks.
    scene.light.wsDirection = Vec3(1.0, -1.0, 0.0);
    EXPECT_EQ(regionOf(scene).reason, FitReason::NothingShadowed);
}

TEST(FocusRegion, TakesACasterBehindTheViewer) {
    Scene scene = noon();
    scene.casters.add({Vec3(0.0, 20.0, 0.0), Vec3(0.5, 0.5, 0.5)});
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::None);
    EXPECT_NEAR(region.lsCasterNear, -20.5, 1e-12);
    EXPECT_NEAR(extentAlong(scene, region, Vec3::UnitX()), 0.5, 1e-12);
}

TEST(FocusRegion, LeavesOutWhatIsBehindEveryReceiver) {
    Scene scene = noon();
    scene.casters.add({Vec3(0.0, -2.0, 0.0), Vec3(0.5, 0.5, 0.5)});
    EXPECT_EQ(regionOf(scene).reason, FitReason::NothingShadowed);
    scene.casters.add({Vec3(3.0, 2.0, 0.0), Vec3(0.5, 0.5, 0.5)});
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::None);
    EXPECT_NEAR(extentAlong(scene, region, -Vec3::UnitX()), -2.5, 1e-12);
}

TEST(FocusRegion, SaysWhyThereIsNone) {
    Scene scene = noon();
    EXPECT_EQ(regionOf(scene).reason, FitReason::NothingShadowed);
    scene.casters.add({Vec3(0.0, 1.0, 0.0), Vec3(0.5, 0.5, 0.5)});
    EXPECT_EQ(regionOf(scene).reason, FitReason::None);
    scene.receivers.clear();
    EXPECT_EQ(regionOf(scene).reason, FitReason::NoReceivers);
    scene.receivers.add({Vec3(50.0, 0.0, 0.0), Vec3::Ones()});
    EXPECT_EQ(regionOf(scene).reason, FitReason::NoReceivers);
}

TEST(FocusRegion, EndsAtTheShadowDistance) {
    Scene scene = noon();
    scene.casters.add({Vec3(0.0, 1.0, 0.0), Vec3(0.5, 0.5, 0.5)});
    scene.viewer.shadowDistance = 9.9;
    EXPECT_EQ(regionOf(scene).reason, FitReason::NoReceivers);
    scene.viewer.shadowDistance = 10.1;
    EXPECT_EQ(regionOf(scene).reason, FitReason::None);
}

TEST(FocusRegion, OfAnUnboundedReceiverIsTheView) {
    Scene scene = noon();
    scene.receivers.clear();
    scene.receivers.addUnbounded();
    scene.casters.add({Vec3(0.0, 50.0, 0.0), Vec3(30.0, 1.0, 30.0)});
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::UnboundedBody);
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
        EXPECT_NEAR(extentAlong(scene, region, axis), 4.0, 1e-12);
    EXPECT_NEAR(region.vsReceiverNear, 0.1, 1e-12);
    EXPECT_NEAR(region.vsReceiverFar, 100.0, 1e-9);
    scene.viewer.shadowDistance = 30.0;
    EXPECT_NEAR(regionOf(scene).vsReceiverFar, 30.0, 1e-9);
}

RC_GTEST_PROP(FocusRegion, OfAnUnboundedReceiverHoldsThePointsOfTheView, ()) {
    Scene scene = *anyScene();
    Dice dice(*anySeed());
    RC_PRE(scene.light.kind == LightKind::Directional);
    scene.receivers.clear();
    scene.receivers.addUnbounded();
    scene.casters.addUnbounded();
    const bool endless =
        viewVolume(scene.viewer).planes().size() < (scene.viewer.shadowDistance > 0.0 ? 7U : 6U);
    const FocusRegion region = regionOf(scene);
    if (endless && scene.viewer.shadowDistance == 0.0) {
        RC_ASSERT(region.reason == FitReason::Unbounded);
        return;
    }
    RC_ASSERT(region.reason == FitReason::UnboundedBody);
    const LightImage image(scene.light);
    double extent = 0.0;
    for (const Vec2& q : region.liHull)
        extent = std::max(extent, q.cwiseAbs().maxCoeff());
    const Vec3 eye = eyeOf(scene.viewer);
    const Vec3 forward = forwardOf(scene.viewer);
    for (int i = 0; i < 200; ++i) {
        const double reach = scene.size * std::pow(10.0, dice.in(-3.0, 1.5));
        const Vec3 p = eye + reach * (dice.cube() + dice.in(0.0, 2.0) * forward);
        if (!sees(scene.viewer, p)) continue;
        const Vec2 q = image.project(image.lsFromPoint(p));
        for (std::size_t k = 0; k < region.liHull.size(); ++k) {
            const Vec2& a = region.liHull[k];
            const Vec2 edge = region.liHull[(k + 1) % region.liHull.size()] - a;
            RC_ASSERT(cross(edge, q - a) >= -1e-9 * extent * edge.norm());
        }
    }
}

TEST(FocusRegion, OfAnUnboundedReceiverWithoutAnEndIsUnboundedHoweverTheViewerLooks) {
    // The far corners of an infinite projection have w = 0 up to rounding.
    Dice dice(1);
    for (int i = 0; i < 1000; ++i) {
        Scene scene;
        scene.viewer.viewFromWorld = lookAlong(dice.cube(), dice.direction());
        scene.viewer.clipFromView = perspective(dice.in(0.2, 2.0), 1.5, 0.1, Infinity);
        scene.receivers.addUnbounded();
        scene.casters.add({Vec3::Zero(), Vec3::Constant(5.0)});
        ASSERT_EQ(regionOf(scene).reason, FitReason::Unbounded) << scene;
    }
}

TEST(FocusRegion, UnderAnUnboundedCasterIsTheReceivers) {
    Scene scene = noon();
    scene.casters.addUnbounded();
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::UnboundedBody);
    EXPECT_NEAR(extentAlong(scene, region, Vec3::UnitX()), 4.0, 1e-12);
}

TEST(FocusRegion, AnUnboundedCasterDoesNotHideTheDepthOfTheOthers) {
    // Without depth clamp the range is stretched over all casters that have a depth.
    Scene scene = noon();
    scene.casters.add({Vec3(0.0, 7.0, 0.0), Vec3(0.5, 0.5, 0.5)});
    EXPECT_NEAR(regionOf(scene).lsCasterNear, -7.5, 1e-12);
    scene.casters.addUnbounded();
    EXPECT_LE(regionOf(scene).lsCasterNear, -7.5 + 1e-12);
}

TEST(FocusRegion, OfASpotIsItsCone) {
    Scene scene = lampOverFloor();
    scene.casters.add({Vec3(0.0, 2.0, 0.0), Vec3(30.0, 0.1, 30.0)});
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::None);
    const double tangent = std::tan(scene.light.outerHalfAngle);
    double radius = 0.0;
    for (const Vec2& q : region.liHull)
        radius = std::max(radius, q.norm());
    EXPECT_GE(radius, tangent);
    EXPECT_LE(radius, tangent / std::cos(std::numbers::pi / 8.0) + 1e-12); // eight sides
    EXPECT_NEAR(region.lsReceiverFar, 4.0, 1e-12);
    EXPECT_NEAR(region.lsCasterNear, 1.9, 1e-12);
}

TEST(FocusRegion, OfASpotHasNoCasterNearerThanItsNearDistance) {
    Scene scene = lampOverFloor();
    scene.casters.add({Vec3(0.0, 3.8, 0.0), Vec3(0.5, 0.2, 0.5)});
    EXPECT_EQ(regionOf(scene).reason, FitReason::NothingShadowed);
    // One that reaches through the near plane counts from there on.
    scene.casters.clear();
    scene.casters.add({Vec3(0.0, 4.0, 0.0), Vec3(0.5, 1.0, 0.5)});
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::None);
    EXPECT_NEAR(region.lsCasterNear, 0.5, 1e-12);
}

TEST(FocusRegion, OfASpotHasNothingBesideItsConeOrBeyondItsRange) {
    Scene scene = lampOverFloor();
    scene.casters.add({Vec3(3.0, 2.0, 0.0), Vec3(0.25, 0.25, 0.25)});
    EXPECT_EQ(regionOf(scene).reason, FitReason::NothingShadowed);
    scene.casters.add({Vec3(0.0, 2.0, 0.0), Vec3(0.25, 0.25, 0.25)});
    EXPECT_EQ(regionOf(scene).reason, FitReason::None);
    scene.light.range = 3.9;
    EXPECT_EQ(regionOf(scene).reason, FitReason::NoReceivers);
}

TEST(FocusRegion, HoldsABodyBesideALineThatCastsAlongItsBorder) {
    // The line comes first, and its image is a polygon of rounding on the border of the receivers.
    Scene scene;
    scene.size = 5e3;
    scene.viewer.viewFromWorld.topLeftCorner<3, 3>() << -0.1385568425472079, 0.29049670237345321,
        -0.94679124800216519, -0.64227566291838656, 0.70134758788926699, 0.30918203988047926,
        0.7538461210393641, 0.65094026367406133, 0.089402454786477681;
    scene.viewer.clipFromView << 1.1914353266876982, 0.0, 1.334646599073507, 0.0, //
        0.0, 0.6740667647980052, -0.87262736100341187, 0.0,                       //
        0.0, 0.0, -1.000088590805174, -7.3279424559926225,                        //
        0.0, 0.0, -1.0, 0.0;
    scene.light.kind = LightKind::Spot;
    scene.light.wsDirection = Vec3(-6820.9866684114222, -7413.3825750920187, 1602.1324147516239);
    scene.light.wsPosition = Vec3(3051.7560632146015, 4158.6812567217121, -2049.1446886840122);
    scene.light.outerHalfAngle = 0.98984880350339477;
    scene.light.nearDistance = 6.7595851571676615;
    const Aabb box{Vec3(-4103.8497894817983, -8394.5596417151901, -5748.133791502848),
                   Vec3(50.522745836979311, 166.31314334005643, 32.426895622342798)};
    const Aabb line{Vec3(-2329.522890698609, -513.13003209740623, -2559.2161451829925),
                    Vec3(0.0, 0.0, 1026.3303115827391)};
    scene.addBody(box);
    scene.addBody(line);
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::None);
    const LightImage image(scene.light);
    const ConvexVolume seen = viewVolume(scene.viewer);
    for (const Vec3& corner : corners(box)) {
        const auto isSeen = [&](const HalfSpace& plane) { return plane.distance(corner) >= 0.0; };
        if (!std::all_of(seen.planes().begin(), seen.planes().end(), isSeen)) continue;
        const Vec2 q = image.project(image.lsFromPoint(corner));
        for (std::size_t i = 0; i < region.liHull.size(); ++i) {
            const Vec2& a = region.liHull[i];
            const Vec2 edge = region.liHull[(i + 1) % region.liHull.size()] - a;
            EXPECT_GE(cross(edge, q - a), -1e-12) << corner.transpose();
        }
    }
}

RC_GTEST_PROP(FocusRegion, IsAConvexPolygonAroundItsCentre, ()) {
    const Scene scene = *anyScene();
    const FocusRegion region = regionOf(scene);
    if (!hasMap(region.reason)) return;
    RC_ASSERT(!region.liHull.empty());
    double extent = 0.0;
    for (const Vec2& q : region.liHull)
        extent = std::max(extent, q.cwiseAbs().maxCoeff());
    // Vertices are exact to some units in their last place; an edge may be as short as that.
    const double rounding = 1e-13 * extent * extent;
    const std::size_t n = region.liHull.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2& a = region.liHull[i];
        const Vec2 edge = region.liHull[(i + 1) % n] - a;
        RC_ASSERT(cross(edge, region.liCentre - a) >= -rounding);
        for (const Vec2& q : region.liHull)
            RC_ASSERT(cross(edge, q - a) >= -rounding);
    }
    RC_ASSERT(region.lsReceiverNear <= region.lsReceiverFar);
    RC_ASSERT(region.vsReceiverNear <= region.vsReceiverFar);
}

namespace {

/// What is at noon, with the ground as a caster that is known to be convex, unless told otherwise.
Scene noonOnConvexGround(bool known = true) {
    Scene scene = noon();
    scene.casters.add(scene.receivers.box(0));
    if (known) scene.setConvex(0, 0);
    return scene;
}

} // namespace

TEST(FocusRegion, HoldsNothingOfAConvexGroundAlone) {
    EXPECT_EQ(regionOf(noonOnConvexGround()).reason, FitReason::NothingShadowed);
    EXPECT_EQ(regionOf(noonOnConvexGround(false)).reason, FitReason::None);
}

TEST(FocusRegion, IsUnderALightAboveItsSlopesAlone) {
    for (const double steepness : {0.5, 0.999}) {
        Scene scene = noonOnConvexGround();
        const Relief relief{Vec3::UnitY(), steepness, {}};
        scene.turnedCasters.convex.front().relief = relief;
        scene.turnedReceivers.convex.front().relief = relief;
        EXPECT_EQ(regionOf(scene).reason,
                  steepness < 0.9 ? FitReason::NothingShadowed : FitReason::None);
    }
}

TEST(FocusRegion, HoldsWhatSlopesThatFaceAwayShadowOfAGround) {
    // A low sun, two cells of a ground, and slopes in one of them.
    Scene scene = noonOnConvexGround();
    scene.light.wsDirection = Vec3(1.0, -0.5, 0.2);
    const Aabb ground = scene.receivers.box(0);
    const Aabb hill{ground.centre + Vec3(-1.0, 0.5, 0.5), Vec3(0.5, 0.5, 0.25)};
    const auto boundsOf = [](const Aabb& box) {
        return Eigen::AlignedBox3f((box.centre - box.halfExtents).cast<float>(),
                                   (box.centre + box.halfExtents).cast<float>());
    };
    Relief relief{Vec3::UnitY(), 0.9, {}};
    relief.cells.push_back({boundsOf(ground), decltype(ReliefCell::rise)::Constant(0.1F)});
    relief.cells.push_back({boundsOf(hill), decltype(ReliefCell::rise)::Constant(2.0F)});
    scene.turnedCasters.convex.front().relief = relief;
    scene.turnedReceivers.convex.front().relief = relief;
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::None);
    // As of a body that stands there.
    Scene other = noonOnConvexGround();
    other.light = scene.light;
    other.casters.add(hill);
    const FocusRegion expected = regionOf(other);
    for (const Vec3& direction :
         {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX()), Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ())})
        EXPECT_NEAR(extentAlong(scene, region, direction), extentAlong(other, expected, direction),
                    1e-9);
    EXPECT_NEAR(region.lsCasterNear, expected.lsCasterNear, 1e-9);
    // Where most of it may face away, the ground is a caster as any other.
    scene.turnedCasters.convex.front().relief->cells.front().rise.setConstant(2.0F);
    EXPECT_GT(extentAlong(scene, regionOf(scene), Vec3::UnitX()),
              extentAlong(scene, region, Vec3::UnitX()) + 0.5);
}

namespace {

/// A viewer at height 2 over a ground whose top is at y = 0, an oblique sun from behind, and a post
/// on its left that shadows what is not seen of the top, but of what is below.
Scene postBesideTheView(const Aabb& ground) {
    Scene scene;
    scene.viewer.viewFromWorld = lookAlong(Vec3(0.0, 2.0, 0.0), -Vec3::UnitZ());
    scene.viewer.clipFromView = perspective(1.0, 1.0, 0.1, 100.0);
    scene.light.wsDirection = Vec3(0.3, -1.0, -1.0);
    scene.addBody(ground);
    scene.setConvex(0, 0);
    scene.casters.add({Vec3(-4.0, 1.0, -2.5), Vec3(0.5, 1.0, 0.5)});
    scene.casters.add({Vec3(0.0, 0.5, -10.0), Vec3(0.5, 0.5, 0.5)});
    return scene;
}

/// Expects two scenes of one light to have the same region.
void expectSameRegion(const Scene& scene, const Scene& expected) {
    const FocusRegion region = regionOf(scene);
    const FocusRegion wanted = regionOf(expected);
    ASSERT_EQ(region.reason, FitReason::None);
    for (const Vec3& direction :
         {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX()), Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ())})
        EXPECT_NEAR(extentAlong(scene, region, direction), extentAlong(expected, wanted, direction),
                    1e-5);
    EXPECT_NEAR(region.lsReceiverFar, wanted.lsReceiverFar, 1e-5);
    EXPECT_NEAR(region.vsReceiverNear, wanted.vsReceiverNear, 1e-5);
}

} // namespace

TEST(FocusRegion, HoldsNothingOfTheSoilUnderAGround) {
    const Aabb block{Vec3(0.0, -2.0, 0.0), Vec3(200.0, 2.0, 200.0)};
    const Scene sheet = postBesideTheView({Vec3::Zero(), Vec3(200.0, 0.0, 200.0)});
    Scene scene = postBesideTheView(block);
    EXPECT_GT(extentAlong(scene, regionOf(scene), -Vec3::UnitX()),
              extentAlong(sheet, regionOf(sheet), -Vec3::UnitX()) + 1.0);
    scene.turnedReceivers.convex.front().isBox = true;
    expectSameRegion(scene, sheet);
}

TEST(FocusRegion, HoldsNothingOfTheAirOverAValley) {
    // Its only hill is behind the viewer.
    const Scene sheet = postBesideTheView({Vec3::Zero(), Vec3(200.0, 0.0, 200.0)});
    Scene scene = postBesideTheView({Vec3(0.0, 1.0, 0.0), Vec3(200.0, 1.5, 200.0)});
    Relief relief{Vec3::UnitY(), 0.01, {}};
    relief.cells.push_back(
        {{Eigen::Vector3f(-200.0F, 0.0F, -200.0F), Eigen::Vector3f(200.0F, 0.0F, 50.0F)},
         decltype(ReliefCell::rise)::Zero()});
    relief.cells.push_back(
        {{Eigen::Vector3f(-200.0F, 0.0F, 50.0F), Eigen::Vector3f(200.0F, 2.5F, 200.0F)},
         decltype(ReliefCell::rise)::Constant(0.01F)});
    scene.turnedCasters.convex.front().relief = relief;
    EXPECT_GT(extentAlong(scene, regionOf(scene), -Vec3::UnitX()),
              extentAlong(sheet, regionOf(sheet), -Vec3::UnitX()) + 1.0);
    scene.turnedReceivers.convex.front().relief = relief;
    expectSameRegion(scene, sheet);
}

TEST(FocusRegion, IsOfNoReceiverWhereAllThatIsSeenFacesAway) {
    // From below a block of ground, not as far as its top.
    Scene scene = postBesideTheView({Vec3(0.0, -2.0, 0.0), Vec3(200.0, 2.0, 200.0)});
    scene.viewer.viewFromWorld = lookAlong(Vec3(0.0, -6.0, 0.0), Vec3(0.0, 1.0, -2.0));
    scene.viewer.clipFromView = perspective(0.5, 1.0, 0.1, 6.0);
    scene.casters.add({Vec3(-1.5, 0.5, -0.5), Vec3(0.5, 0.5, 0.5)});
    EXPECT_EQ(regionOf(scene).reason, FitReason::None);
    scene.turnedReceivers.convex.front().isBox = true;
    EXPECT_EQ(regionOf(scene).reason, FitReason::NoReceivers);
}

TEST(FocusRegion, IsAnotherCastersImageOnAConvexGround) {
    Scene scene = noonOnConvexGround();
    scene.casters.add({Vec3(1.0, 3.0, -0.5), Vec3(0.5, 1.0, 0.25)});
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::None);
    EXPECT_NEAR(extentAlong(scene, region, Vec3::UnitX()), 1.5, 1e-12);
    EXPECT_NEAR(extentAlong(scene, region, -Vec3::UnitX()), -0.5, 1e-12);
    EXPECT_NEAR(extentAlong(scene, region, -Vec3::UnitZ()), 0.75, 1e-12);
    EXPECT_NEAR(region.lsCasterNear, -4.0, 1e-12);
}

TEST(FocusRegion, HoldsWhatAConvexGroundShadowsOfOthers) {
    Scene scene = noonOnConvexGround();
    scene.receivers.add({Vec3(-2.0, 1.0, 1.0), Vec3(0.5, 0.5, 0.5)});  // above it
    scene.receivers.add({Vec3(2.0, -1.0, 1.0), Vec3(0.5, 0.5, 0.25)}); // below
    scene.receivers.add({Vec3(3.0, 0.0, -1.0), Vec3(0.5, 0.5, 0.5)});  // half of either
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::None);
    EXPECT_NEAR(extentAlong(scene, region, -Vec3::UnitX()), -1.5, 1e-12);
    EXPECT_NEAR(extentAlong(scene, region, Vec3::UnitX()), 3.5, 1e-12);
    EXPECT_NEAR(extentAlong(scene, region, Vec3::UnitZ()), 1.25, 1e-12);
    EXPECT_NEAR(extentAlong(scene, region, -Vec3::UnitZ()), 1.5, 1e-12);
    EXPECT_NEAR(region.lsCasterNear, 0.0, 1e-12);
}

TEST(FocusRegion, HoldsWhatConvexBodiesShadowOfEachOther) {
    Scene scene = noonOnConvexGround();
    scene.addConvexBody({Vec3(1.0, 2.0, 0.0), Vec3(0.5, 0.5, 0.5)});
    scene.addConvexBody({Vec3(1.0, 4.0, 0.0), Vec3(0.25, 0.5, 1.0)});
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::None);
    EXPECT_NEAR(extentAlong(scene, region, -Vec3::UnitX()), -0.5, 1e-12);
    EXPECT_NEAR(extentAlong(scene, region, Vec3::UnitX()), 1.5, 1e-12);
    EXPECT_NEAR(extentAlong(scene, region, Vec3::UnitZ()), 1.0, 1e-12);
}

TEST(FocusRegion, TakesAReceiverWithoutBoundsForShadowedByAConvexGround) {
    Scene scene = noonOnConvexGround();
    scene.receivers.addUnbounded();
    const FocusRegion region = regionOf(scene);
    EXPECT_EQ(region.reason, FitReason::UnboundedBody);
    EXPECT_NEAR(extentAlong(scene, region, Vec3::UnitX()), 4.0, 1e-12);
}

TEST(FocusRegion, HoldsNothingOfAConvexBoxAroundALamp) {
    Scene scene = lampOverFloor();
    scene.addConvexBody({scene.light.wsPosition, Vec3(1.0, 1.0, 1.0)});
    // The lamp's box shadows the floor wherever the lamp shines.
    Scene alone = lampOverFloor();
    alone.casters.add({scene.light.wsPosition, Vec3(1.0, 1.0, 1.0)});
    const FocusRegion region = regionOf(scene);
    ASSERT_EQ(region.reason, FitReason::None);
    EXPECT_NEAR(steinerPoint(region.liHull).x(), steinerPoint(regionOf(alone).liHull).x(), 1e-12);
}
