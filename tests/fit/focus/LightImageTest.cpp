#include "fit/focus/LightImage.h"

#include "fit/Problems.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

void expectBasis(const Vec3& direction) {
    const LightImage image(ShadowLight{.wsDirection = direction});
    const Mat3& m = image.lsFromWs();
    EXPECT_LT((m * m.transpose() - Mat3::Identity()).norm(), 1e-14) << direction.transpose();
    EXPECT_NEAR(m.determinant(), 1.0, 1e-14) << direction.transpose();
    // Looks along -z.
    EXPECT_LT((m * direction.stableNormalized() + Vec3::UnitZ()).norm(), 1e-14)
        << direction.transpose();
}

ShadowLight spotAt(const Vec3& position, const Vec3& direction) {
    return {.kind = LightKind::Spot, .wsDirection = direction, .wsPosition = position};
}

} // namespace

TEST(LightImage, BasisIsOrthonormalAlongEveryAxis) {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            Vec3 direction = Vec3::Zero();
            direction[axis] = sign;
            expectBasis(direction);
            direction[(axis + 1) % 3] = -0.0;
            direction[(axis + 2) % 3] = -0.0;
            expectBasis(direction);
        }
}

TEST(LightImage, BasisIsOrthonormalBesideTheAxesAndForAnyLength) {
    for (const double tiny : {1e-300, 1e-160, 1e-17, 1e-9, 1e-3})
        for (const double sign : {1.0, -1.0}) {
            expectBasis(Vec3(tiny, 0.0, sign));
            expectBasis(Vec3(0.0, -tiny, sign));
            expectBasis(Vec3(1.0, sign, sign * tiny));
        }
    expectBasis(Vec3(1e200, -3e200, 1e199));
    expectBasis(Vec3(1e-200, -3e-200, 1e-199));
}

RC_GTEST_PROP(LightImage, BasisIsOrthonormalForAnyDirection, ()) {
    Dice dice(*anySeed());
    const LightImage image(ShadowLight{.wsDirection = dice.direction()});
    const Mat3& m = image.lsFromWs();
    RC_ASSERT((m * m.transpose() - Mat3::Identity()).norm() < 1e-14);
    RC_ASSERT(std::abs(m.determinant() - 1.0) < 1e-14);
}

RC_GTEST_PROP(LightImage, ARayOfTheSunIsOnePoint, ()) {
    Dice dice(*anySeed());
    const Vec3 direction = dice.direction();
    const LightImage image(ShadowLight{.wsDirection = direction});
    const Vec3 x = 10.0 * dice.cube();
    const Vec3 y = x + dice.in(-100.0, 100.0) * direction;
    RC_ASSERT((image.project(image.lsFromPoint(x)) - image.project(image.lsFromPoint(y))).norm() <
              1e-12);
    RC_ASSERT(image.oriented(image.lsFromPoint(x)).z() == 1.0);
    RC_ASSERT(image.orientedDirection(image.lsFromDirection(direction)).norm() < 1e-14);
}

RC_GTEST_PROP(LightImage, ARayOfASpotIsOnePoint, ()) {
    Dice dice(*anySeed());
    const Vec3 position = 10.0 * dice.cube();
    const Vec3 axis = dice.direction();
    const LightImage image(spotAt(position, axis));
    Vec3 ray = dice.direction();
    if (ray.dot(axis) < 0.0) ray = -ray;
    RC_PRE(ray.dot(axis) > 0.05);
    const Vec3 x = position + dice.in(0.1, 1.0) * ray;
    const Vec3 y = position + dice.in(1.0, 50.0) * ray;
    RC_ASSERT((image.project(image.lsFromPoint(x)) - image.project(image.lsFromPoint(y))).norm() <
              1e-11);
    const Vec3 oriented = image.oriented(image.lsFromPoint(x));
    RC_ASSERT(oriented.z() > 0.0);
    RC_ASSERT((oriented.hnormalized() - image.project(image.lsFromPoint(x))).norm() < 1e-13);
    // Behind the light the oriented ray has the opposite sign.
    const Vec3 behind = image.oriented(image.lsFromPoint(2.0 * position - x));
    RC_ASSERT((behind + oriented).norm() < 1e-12);
}

RC_GTEST_PROP(LightImage, OrientedCoordinatesAreAffineInThePoint, ()) {
    Dice dice(*anySeed());
    const LightImage image(dice.chance(0.5) ? ShadowLight{.wsDirection = dice.direction()}
                                            : spotAt(dice.cube(), dice.direction()));
    const Vec3 x = dice.cube();
    const Vec3 d = dice.cube();
    const Vec3 step = image.orientedDirection(image.lsFromDirection(d));
    RC_ASSERT((image.oriented(image.lsFromPoint(x + 3.0 * d)) -
               image.oriented(image.lsFromPoint(x)) - 3.0 * step)
                  .norm() < 1e-13);
}

TEST(LightImage, PointsOnRaysHaveTheRaysAsTheirImages) {
    Dice dice(6);
    for (const LightKind kind : {LightKind::Directional, LightKind::Spot}) {
        ShadowLight light;
        light.kind = kind;
        light.wsDirection = dice.direction();
        light.wsPosition = 10.0 * dice.cube();
        const LightImage image(light);
        // Λ by its rows, for homogeneous points.
        Eigen::Matrix<double, 3, 4> lambda;
        lambda.leftCols<3>() = image.lsFromWs();
        lambda.col(3) = -image.lsFromWs() * image.wsEye();
        if (image.directional())
            lambda.row(2) = Vec4::UnitW().transpose();
        else
            lambda.row(2) *= -1.0;
        const Vec3 ws = dice.cube();
        EXPECT_LT(
            (lambda * Vec4(ws.x(), ws.y(), ws.z(), 1.0) - image.oriented(image.lsFromPoint(ws)))
                .norm(),
            1e-12);
        EXPECT_LT((lambda * image.wsFromOriented() - Mat3::Identity()).norm(), 1e-12);
        EXPECT_LT((lambda * image.wsLight()).norm(), 1e-12);
        // Towards the sun, or where the lamp is.
        EXPECT_GT(image.wsLight().head<3>().dot(image.directional() ? Vec3(-light.wsDirection)
                                                                    : light.wsPosition),
                  0.0);
    }
}
