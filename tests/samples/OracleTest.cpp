// The exact-shadow oracle against shadows that are known in closed form.

#include "OracleScenes.h"

#include "common/TruthComparison.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace Lixel::Samples {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double Pi = std::numbers::pi;
/// A sphere of latitude-longitude triangles, fronts outward.
void addSphere(TriangleScene& scene, const Vector3d& centre, double radius, int rings) {
    const auto point = [&](int ring, int segment) -> Vector3d {
        const double theta = Pi * ring / rings;
        const double phi = Pi * (segment % (2 * rings)) / rings;
        return centre + radius * Vector3d(std::sin(theta) * std::cos(phi), std::cos(theta),
                                          -std::sin(theta) * std::sin(phi));
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int segment = 0; segment < 2 * rings; ++segment) {
            const Vector3d a = point(ring, segment);
            const Vector3d b = point(ring + 1, segment);
            const Vector3d c = point(ring + 1, segment + 1);
            const Vector3d d = point(ring, segment + 1);
            if (ring + 1 < rings) scene.add(a, b, c, Caster);
            if (ring > 0) scene.add(a, c, d, Caster);
        }
    }
}

OracleLight spot(const Vector3d& position, const Vector3d& target, double outerAngle) {
    OracleLight light;
    light.kind = OracleLight::Kind::Spot;
    light.position = position;
    light.direction = (target - position).normalized();
    light.outerAngle = outerAngle;
    return light;
}

/// Signed distance (negative inside) from the rectangle low..high.
double outside(const Vector2d& p, const Vector2d& low, const Vector2d& high) {
    return (low - p).cwiseMax(p - high).maxCoeff();
}

TEST(ShadowOracle, SphereInDirectionalLightShadowsAnEllipse) {
    const Vector3d centre(0.0, 3.0, 0.0);
    const double radius = 2.0;
    constexpr int Rings = 64;
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    addSphere(scene, centre, radius, Rings);
    const ShadowOracle oracle(std::move(scene));

    for (const Vector3d& direction :
         {Vector3d(0.0, -1.0, 0.0), Vector3d(1.0, -1.0, 0.3), Vector3d(-0.5, -0.4, 0.6)}) {
        const OracleLight light = directional(direction);
        // The facets lie between the sphere and one smaller by the sagitta.
        const double sagitta = radius * (1.0 - std::pow(std::cos(0.5 * Pi / Rings), 2.0));
        expectGround(oracle, viewFrom({6.0, 9.0, 12.0}, {0.0, 0.0, 0.0}), light,
                     [&](const Vector3d& p) {
                         const double distance = (p - centre).cross(light.direction).norm();
                         return decide(distance - radius + 0.5 * sagitta, sagitta + 1e-6);
                     });
    }
}

TEST(ShadowOracle, BoxInDirectionalLightShadowsASweptRectangle) {
    const Vector3d low(-1.0, 1.0, -2.0);
    const Vector3d high(1.5, 2.0, 0.5);
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    addBox(scene, low, high);
    const ShadowOracle oracle(std::move(scene));
    const OracleLight light = directional({0.4, -1.0, 0.7});
    const Vector2d slope(light.direction.x() / light.direction.y(),
                         light.direction.z() / light.direction.y());

    expectGround(oracle, viewFrom({5.0, 8.0, 9.0}, {0.0, 0.0, 1.0}), light, [&](const Vector3d& p) {
        // Going up from p, the light's ray is inside the box for the heights in which x and z are.
        double enter = low.y();
        double leave = high.y();
        for (int axis = 0; axis < 2; ++axis) {
            const double start = axis == 0 ? p.x() : p.z();
            const double a = ((axis == 0 ? low.x() : low.z()) - start) / slope(axis);
            const double b = ((axis == 0 ? high.x() : high.z()) - start) / slope(axis);
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        return decide(enter - leave, 1e-4);
    });
}

TEST(ShadowOracle, BoxUnderASpotShadowsTheFanOfItsTop) {
    // Seen from above its middle, a flat box hides the perspective image of its nearer (top) face.
    const Vector3d low(-1.0, 2.0, -0.5);
    const Vector3d high(1.0, 2.5, 0.5);
    const Vector3d lamp(0.0, 5.0, 0.0);
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    addBox(scene, low, high);
    const ShadowOracle oracle(std::move(scene));
    const double grow = lamp.y() / (lamp.y() - high.y());
    constexpr double Cone = 2.2;
    const double coneRadius = lamp.y() * std::tan(0.5 * Cone);

    const OracleView view = viewFrom({4.0, 12.0, 10.0}, {0.0, 0.0, 0.0});
    const OracleLight light = spot(lamp, {0.0, 0.0, 0.0}, Cone);
    expectGround(oracle, view, light, [&](const Vector3d& p) {
        if (Vector2d(p.x(), p.z()).norm() > coneRadius - 1e-3) return -1;
        return decide(outside({p.x(), p.z()}, grow * Vector2d(low.x(), low.z()),
                              grow * Vector2d(high.x(), high.z())),
                      1e-4);
    });
}

TEST(ShadowOracle, SphereUnderASpotShadowsACone) {
    const Vector3d centre(0.5, 2.0, -0.5);
    const double radius = 0.8;
    constexpr int Rings = 64;
    const Vector3d lamp(-3.0, 7.0, 2.0);
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    addSphere(scene, centre, radius, Rings);
    const ShadowOracle oracle(std::move(scene));
    const double sagitta = radius * (1.0 - std::pow(std::cos(0.5 * Pi / Rings), 2.0));
    const OracleView view = viewFrom({4.0, 8.0, 8.0}, {1.5, 0.0, -1.5});
    const OracleLight light = spot(lamp, centre, 2.6);
    expectGround(oracle, view, light, [&](const Vector3d& p) {
        const Vector3d towards = (p - lamp).normalized();
        if (towards.dot(light.direction) < std::cos(0.5 * light.outerAngle) + 1e-3) return -1;
        const double distance = (centre - lamp).cross(towards).norm();
        return decide(distance - radius + 0.5 * sagitta, sagitta + 1e-6);
    });
}

TEST(ShadowOracle, OutsideTheOuterConeIsUnlit) {
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    const ShadowOracle oracle(std::move(scene));
    const OracleView view = viewFrom({0.0, 20.0, 0.0}, {0.0, 0.0, 0.0});
    const ShadowTruth truth =
        oracle.classify(view, spot({0.0, 4.0, 0.0}, Vector3d::Zero(), Pi / 2));
    for (int row = 0; row < view.height; ++row) {
        for (int column = 0; column < view.width; ++column) {
            const double distance = groundPoint(view, column, row)->norm();
            if (std::abs(distance - 4.0) > 1e-6) {
                EXPECT_EQ(truth.at(column, row),
                          distance < 4.0 ? PixelClass::Lit : PixelClass::Unlit);
            }
        }
    }
}

TEST(ShadowOracle, BeyondAttenuationRangeIsUnlit) {
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    const ShadowOracle oracle(std::move(scene));
    OracleLight light;
    light.kind = OracleLight::Kind::Point;
    light.position = {0.0, 3.0, 0.0};
    light.range = 5.0;
    const OracleView view = viewFrom({0.0, 20.0, 0.0}, {0.0, 0.0, 0.0});
    const ShadowTruth truth = oracle.classify(view, light);
    const double disc = Pi * 16.0; // 3, 4, 5
    const double pixel = std::pow(2.0 * 20.0 * std::tan(0.5) / view.height, 2.0);
    EXPECT_NEAR(static_cast<double>(count(truth, PixelClass::Lit)) * pixel, disc, 0.02 * disc);
    EXPECT_EQ(count(truth, PixelClass::Lit) + count(truth, PixelClass::Unlit), truth.pixels.size());
}

TEST(ShadowOracle, WhatIsBeyondALampDoesNotShadow) {
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    addBox(scene, {-9.0, 3.1, -9.0}, {9.0, 3.5, 9.0});
    const ShadowOracle oracle(std::move(scene));
    const OracleView view = viewFrom({0.0, 2.0, 4.0}, {0.0, 0.0, 0.0});
    OracleLight lamp = spot({0.0, 3.0, 0.0}, Vector3d::Zero(), Pi);
    for (const auto kind : {OracleLight::Kind::Spot, OracleLight::Kind::Point}) {
        lamp.kind = kind;
        const ShadowTruth truth = oracle.classify(view, lamp);
        EXPECT_EQ(count(truth, PixelClass::Shadowed), 0U);
        EXPECT_GT(count(truth, PixelClass::Lit), 5000U);
    }
}

TEST(ShadowOracle, LightFromBelowLeavesTheGroundUnlit) {
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    const ShadowOracle oracle(std::move(scene));
    const OracleView view = viewFrom({0.0, 5.0, 5.0}, {0.0, 0.0, 0.0});
    const ShadowTruth truth = oracle.classify(view, directional({0.2, 1.0, 0.0}));
    EXPECT_EQ(count(truth, PixelClass::Unlit), truth.pixels.size());
}

TEST(ShadowOracle, GrazingPixelsAreReportedApart) {
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    addBox(scene, {-1.0, 0.0, -1.0}, {1.0, 0.2, 1.0});
    const ShadowOracle oracle(std::move(scene));
    const OracleView view = viewFrom({0.0, 12.0, 0.0}, {0.0, 0.0, 0.0});
    const double justBelow = std::asin(GrazingCosine - 1e-4);
    const double justAbove = std::asin(GrazingCosine + 1e-4);
    for (const double elevation : {justBelow, justAbove}) {
        const ShadowTruth truth =
            oracle.classify(view, directional({std::cos(elevation), -std::sin(elevation), 0.0}));
        const bool grazes = elevation == justBelow;
        EXPECT_EQ(count(truth, PixelClass::GrazingLit) > 1000U, grazes);
        EXPECT_EQ(count(truth, PixelClass::GrazingShadowed) > 100U, grazes);
        EXPECT_EQ(count(truth, PixelClass::Lit) > 1000U, !grazes);
        EXPECT_EQ(count(truth, PixelClass::Shadowed) > 100U, !grazes);
    }
}

TEST(ShadowOracle, BackFacesAreNotDrawnButBlockLight) {
    // Two one-sided sheets that face up, above the ground: from below only the light meets them.
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    addGround(scene, {0.0, 4.0, 0.0}, 1.0, Caster);
    const ShadowOracle oracle(scene);
    const OracleLight fromAbove = directional({0.0, -1.0, 0.0});

    // The viewer, under the sheet and looking up at it, sees the sky.
    const ShadowTruth up = oracle.classify(viewFrom({0.0, 2.0, 0.0}, {0.0, 4.0, 0.0}), fromAbove);
    EXPECT_EQ(count(up, PixelClass::Background), up.pixels.size());

    // Looking down, the sheet's shadow is around the viewer's foot; light from below is blocked by
    // the sheet's back just so, seen on a ceiling.
    const OracleView down = viewFrom({0.0, 3.5, 0.0}, Vector3d::Zero());
    const ShadowTruth below = oracle.classify(down, fromAbove);
    const double side = 2.0 / (2.0 * 3.5 * std::tan(0.5) / down.height);
    EXPECT_NEAR(static_cast<double>(count(below, PixelClass::Shadowed)), side * side, 3.0 * side);

    TriangleScene ceiling;
    ceiling.add({-9.0, 8.0, -9.0}, {9.0, 8.0, -9.0}, {0.0, 8.0, 9.0}, Receiver);
    addGround(ceiling, {0.0, 4.0, 0.0}, 1.0, Caster);
    const ShadowOracle room(std::move(ceiling));
    const ShadowTruth above =
        room.classify(viewFrom({0.0, 5.0, 0.0}, {0.0, 8.0, 0.0}), directional({0.0, 1.0, 0.0}));
    EXPECT_GT(count(above, PixelClass::Shadowed), 100U);
    EXPECT_GT(count(above, PixelClass::Lit), 100U);
}

TEST(ShadowOracle, DoubleSidedTrianglesAreDrawnFromBehind) {
    TriangleScene scene;
    Triangle sheet = Caster;
    sheet.drawnFromBack = true;
    addGround(scene, {0.0, 4.0, 0.0}, 9.0, sheet);
    const ShadowOracle oracle(std::move(scene));
    const OracleView view = viewFrom({0.0, 2.0, 0.0}, {0.0, 4.0, 0.0});
    // Its underside faces away from light above and towards light below.
    EXPECT_EQ(count(oracle.classify(view, directional({0, -1, 0})), PixelClass::Unlit),
              static_cast<std::size_t>(view.width * view.height));
    EXPECT_EQ(count(oracle.classify(view, directional({0, 1, 0})), PixelClass::Lit),
              static_cast<std::size_t>(view.width * view.height));
}

TEST(ShadowOracle, ShadowDistanceIsViewSpaceDepth) {
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 400.0);
    const ShadowOracle oracle(std::move(scene));
    OracleView view = viewFrom({0.0, 2.0, 0.0}, {0.0, 1.0, -10.0});
    view.shadowDistance = 25.0;
    const ShadowTruth truth = oracle.classify(view, directional({0.3, -1.0, 0.0}));
    for (int row = 0; row < view.height; ++row) {
        for (int column = 0; column < view.width; ++column) {
            const PixelClass pixel = truth.at(column, row);
            if (pixel == PixelClass::Background) continue;
            const Vector3d ground = *groundPoint(view, column, row);
            const double depth = -(view.vsFromWs * ground.homogeneous()).z();
            EXPECT_EQ(pixel, depth > 25.0 ? PixelClass::BeyondShadowDistance : PixelClass::Lit);
        }
    }
    EXPECT_GT(count(truth, PixelClass::BeyondShadowDistance), 100U);
}

TEST(ShadowOracle, NearAndFarPlaneBoundWhatIsSeen) {
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 400.0);
    const ShadowOracle oracle(std::move(scene));
    const OracleLight light = directional({0.0, -1.0, 0.0});
    const Vector3d eye(0.0, 10.0, 0.0);
    EXPECT_EQ(count(oracle.classify(viewFrom(eye, {0, 0, 0}, 9.9), light), PixelClass::Background),
              160U * 120U);
    EXPECT_EQ(count(oracle.classify(viewFrom(eye, {0, 0, 0}, 10.1), light), PixelClass::Lit),
              160U * 120U);
    OracleView nearBeyond = viewFrom(eye, {0, 0, 0});
    nearBeyond.clipFromVs = perspective(1.0, 160.0 / 120.0, 10.1, 100.0);
    EXPECT_EQ(count(oracle.classify(nearBeyond, light), PixelClass::Background), 160U * 120U);
}

TEST(ShadowOracle, WhatDoesNotReceiveIsNoReceiverAndWhatDoesNotCastIsTransparentToLight) {
    TriangleScene scene;
    addGround(scene, Vector3d::Zero(), 40.0);
    Triangle ghost;
    ghost.casts = false;
    ghost.receives = false;
    addBox(scene, {-1.0, 0.0, -1.0}, {1.0, 2.0, 1.0}, ghost);
    const ShadowOracle oracle(std::move(scene));
    const ShadowTruth truth =
        oracle.classify(viewFrom({4.0, 6.0, 6.0}, {0.0, 0.0, 0.0}), directional({0.5, -1.0, 0.2}));
    EXPECT_GT(count(truth, PixelClass::NotReceiver), 100U);
    EXPECT_EQ(count(truth, PixelClass::Shadowed), 0U);
}

TEST(ShadowOracle, ClosedConvexBodiesDoNotShadowTheirOwnLitSide) {
    TriangleScene scene;
    addSphere(scene, {0.0, 0.0, 0.0}, 1.0, 200);
    const ShadowOracle oracle(std::move(scene));
    for (const Vector3d& direction :
         {Vector3d(0.0, -1.0, 0.0), Vector3d(1.0, -0.2, -0.4), Vector3d(0.1, 0.0, 1.0)}) {
        const ShadowTruth truth =
            oracle.classify(viewFrom({1.0, 1.2, 1.4}, Vector3d::Zero()), directional(direction));
        EXPECT_EQ(count(truth, PixelClass::Shadowed), 0U);
        EXPECT_EQ(count(truth, PixelClass::GrazingShadowed), 0U);
    }
}

TEST(ShadowOracle, AMillionUnitsFromTheOriginNothingChanges) {
    // Positions there are multiples of 1/16 for a float; relative to the origin they are exact.
    const OracleLight light = directional({0.4, -1.0, 0.7});
    const Vector3d eye(5.0, 8.0, 9.0);
    const auto truthAt = [&](const Vector3d& offset) {
        TriangleScene scene;
        scene.wsOrigin = offset;
        addGround(scene, offset, 40.0);
        addBox(scene, offset + Vector3d(-1.0, 1.0, -2.0), offset + Vector3d(1.5, 2.0, 0.5));
        // Stored relative to the origin, as collectTriangles does.
        for (Vector3d& position : scene.positions)
            position -= offset;
        return ShadowOracle(std::move(scene)).classify(viewFrom(eye, {0.0, 0.0, 1.0}), light);
    };
    const ShadowTruth here = truthAt(Vector3d::Zero());
    const ShadowTruth there = truthAt({1e6, -1e6, 1e6});
    EXPECT_GT(count(here, PixelClass::Shadowed), 100U);
    EXPECT_EQ(here.pixels, there.pixels);
}

TEST(ShadowOracle, PositionsFarFromTheGivenOriginKeepTheirDigits) {
    // Nobody moved the origin: the oracle centres the scene itself before it rounds to floats.
    const Vector3d offset(1e6, -1e6, 1e6);
    const auto truthAt = [&](const Vector3d& centre) {
        TriangleScene scene;
        addGround(scene, centre, 40.0);
        addBox(scene, centre + Vector3d(-1.0, 1.0, -2.0), centre + Vector3d(1.5, 2.0, 0.5));
        return ShadowOracle(std::move(scene))
            .classify(viewFrom(centre + Vector3d(5.0, 8.0, 9.0), centre + Vector3d(0.0, 0.0, 1.0)),
                      directional({0.4, -1.0, 0.7}));
    };
    const ShadowTruth here = truthAt(Vector3d::Zero());
    const ShadowTruth there = truthAt(offset);
    std::size_t different = 0;
    for (std::size_t i = 0; i < here.pixels.size(); ++i)
        different += here.pixels[i] != there.pixels[i] ? 1 : 0;
    EXPECT_LE(different, 2U);
}

TEST(ShadowOracle, BadInputIsRefusedByName) {
    TriangleScene broken;
    broken.add({0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0});
    EXPECT_THROW(ShadowOracle{broken}, std::invalid_argument);
    broken.positions[2].setZero();
    broken.triangles[0].vertices[1] = 7;
    EXPECT_THROW(ShadowOracle{broken}, std::invalid_argument);

    const ShadowOracle empty{TriangleScene{}};
    OracleView view = viewFrom({0, 1, 0}, {0, 0, -1});
    const ShadowTruth truth = empty.classify(view, directional({0, -1, 0}));
    EXPECT_EQ(count(truth, PixelClass::Background), truth.pixels.size());
    OracleLight dark;
    dark.direction.setZero();
    EXPECT_THROW(empty.classify(view, dark), std::invalid_argument);
    view.clipFromVs.setZero();
    EXPECT_THROW(empty.classify(view, directional({0, -1, 0})), std::invalid_argument);
    view = viewFrom({0, 1, 0}, {0, 0, -1});
    view.width = 0;
    EXPECT_THROW(empty.classify(view, directional({0, -1, 0})), std::invalid_argument);
}

TEST(TruthComparison, CountsAcneLeaksAndGrazingApart) {
    using enum PixelClass;
    const ShadowTruth truth{5,
                            2,
                            {Lit, Lit, Shadowed, Shadowed, Shadowed, GrazingLit, GrazingShadowed,
                             Unlit, Background, BeyondShadowDistance}};
    const std::vector<std::uint8_t> visibility{255, 127, 0, 128, 255, 0, 0, 0, 255, 0};
    const ClassificationError error = compareWithTruth(truth, visibility);
    EXPECT_EQ(error.counted(), 5U);
    EXPECT_EQ(error.acnePixels, 1U);
    EXPECT_EQ(error.leakPixels, 2U);
    EXPECT_DOUBLE_EQ(error.acne, 20.0);
    EXPECT_DOUBLE_EQ(error.leak, 40.0);
    EXPECT_DOUBLE_EQ(error.error, 60.0);
    EXPECT_EQ(error.grazing, 2U);
    EXPECT_DOUBLE_EQ(error.grazingError, 50.0);

    const std::vector<std::uint8_t> picture = paintComparison(truth, visibility);
    ASSERT_EQ(picture.size(), 30U);
    EXPECT_GT(picture[3], 200);        // acne is red
    EXPECT_GT(picture[9 + 2], 200);    // a leak is blue
    EXPECT_EQ(picture[0], picture[1]); // what is right is grey
    EXPECT_EQ(paintTruth(truth).size(), 30U);
}

TEST(TruthComparison, NothingToCountIsNoError) {
    const ShadowTruth truth{1, 1, {PixelClass::Background}};
    EXPECT_DOUBLE_EQ(compareWithTruth(truth, std::vector<std::uint8_t>{0}).error, 0.0);
    EXPECT_THROW(compareWithTruth(truth, std::vector<std::uint8_t>{}), std::invalid_argument);
}

} // namespace
} // namespace Lixel::Samples
