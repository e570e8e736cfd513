/// Kozlov's post-projective space, taken literally.
#include "fit/technique/Psm.h"

#include "fit/Problems.h"

#include "fit/focus/LightImage.h"
#include "fit/geometry/Cone.h"
#include "fit/geometry/Polygon2.h"
#include "fit/rule/ViewDepth.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

constexpr double Fov = 80.0 * Degree;
constexpr double FirstDepth = 6.0;
constexpr double LastDepth = 30.0;

/// The viewer looks along -z at bodies that cast and receive, wholly in view, from depth 6 to 30.
Scene bodies(const Vec3& lightDirection) {
    Scene scene;
    scene.size = 10.0;
    scene.viewer.clipFromView = perspective(Fov, 1.0, 0.1, 500.0);
    scene.light.wsDirection = lightDirection;
    scene.addBody({Vec3(1.0, -1.0, -(FirstDepth + 0.5)), Vec3(0.5, 0.3, 0.5)});
    scene.addBody({Vec3(-3.0, 0.5, -15.0), Vec3(1.0, 2.0, 1.0)});
    scene.addBody({Vec3(5.0, -2.0, -(LastDepth - 2.0)), Vec3(2.0, 1.0, 2.0)});
    return scene;
}

Scene lamp(const Vec3& position) {
    Scene scene = bodies(Vec3(0.0, 0.0, -16.0) - position);
    scene.light.kind = LightKind::Spot;
    scene.light.wsPosition = position;
    scene.light.outerHalfAngle = 75.0 * Degree;
    return scene;
}

/// A viewer slid back by hand: the same opening, clip planes where they were in the world.
Mat4 slidBack(double slideBack, double nearest, double farthest) {
    return perspective(Fov, 1.0, nearest + slideBack, farthest + slideBack) *
           lookAlong(Vec3(0.0, 0.0, slideBack), -Vec3::UnitZ());
}

/// Denominators at world points, relative to the first one's.
std::vector<double> denominators(const ShadowFit& fit, const std::vector<Vec3>& points) {
    std::vector<double> result;
    for (const Vec3& p : points)
        result.push_back(clipOf(fit.clipFromWorld, p).w() /
                         clipOf(fit.clipFromWorld, points[0]).w());
    return result;
}

std::vector<Vec3> cornersOf(const BoxSet& set) {
    std::vector<Vec3> result;
    for (const Aabb& box : set.boxes())
        for (const Vec3& corner : corners(box))
            result.push_back(corner);
    return result;
}

/** How far the fit's map coordinates are from an affine function of the coordinates that a light
    camera in post-projective space gives, relative to the map; the camera stands at the light and
    looks along the axis of the smallest cone. */
double misfit(const Scene& scene, double slideBackFactor) {
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), PsmOptions{.slideBack = slideBackFactor}, state);
    EXPECT_EQ(fit.reason, FitReason::None);
    const double n = state.region.vsReceiverNear;
    const double f = state.region.vsReceiverFar;
    const Mat4 post = slidBack(slideBackFactor * std::sqrt(n * f), n, f);
    const Vec4 light = post * homogeneousLight(scene.light);
    const Vec3 position = light.head<3>() / light.w();

    // The region's rays: points of receivers whose images are its corners.
    const LightImage image(scene.light);
    std::vector<Vec3> directions;
    for (const Vec2& q : state.region.liHull)
        for (const Vec3& ws : cornersOf(scene.receivers))
            if ((image.project(image.lsFromPoint(ws)) - q).norm() < 1e-9)
                directions.push_back(
                    ((post * ws.homogeneous()).hnormalized() - position).normalized());
    EXPECT_GE(directions.size(), state.region.liHull.size());
    const Vec3 axis = smallestConeAxis(directions);
    const Mat4 camera =
        perspective(1.0, 1.0, 0.1, 10.0) * lookAlong(position, axis, axis.unitOrthogonal()) * post;

    const std::vector<Vec3> points = cornersOf(scene.receivers);
    const auto count = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixX3d from(count, 3);
    Eigen::MatrixX2d to(count, 2);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Vec4 clip = camera * points[static_cast<std::size_t>(i)].homogeneous();
        EXPECT_GT(clip.w(), 0.0);
        from.row(i) << clip.x() / clip.w(), clip.y() / clip.w(), 1.0;
        const Vec4 ours = clipOf(fit.clipFromWorld, points[static_cast<std::size_t>(i)]);
        to.row(i) << ours.x() / ours.w(), ours.y() / ours.w();
    }
    const auto affine = from.colPivHouseholderQr().solve(to).eval();
    return (from * affine - to).cwiseAbs().maxCoeff();
}

} // namespace

TEST(Psm, VirtualViewerIsTheSlidBackOne) {
    const Scene scene = bodies(Vec3(0.0, -1.0, 0.0));
    for (const double slideBack : {0.0, 3.0})
        EXPECT_LT(
            (virtualViewer(scene.viewer, slideBack, 4.0, 50.0) - slidBack(slideBack, 4.0, 50.0))
                .norm(),
            1e-12);
}

TEST(Psm, MapIsTheLightCamerasInPostProjectiveSpace) {
    for (const double slideBack : {0.0, 0.25, 1.0}) {
        EXPECT_LT(misfit(bodies(Vec3(0.3, -1.0, -0.4)), slideBack), 1e-9); // sun behind the viewer
        EXPECT_LT(misfit(bodies(Vec3(0.3, -1.0, 0.4)), slideBack), 1e-9);  // and in front
        EXPECT_LT(misfit(bodies(Vec3(0.6, -0.5, 0.9)), slideBack), 1e-9);
        EXPECT_LT(misfit(lamp(Vec3(3.0, 12.0, -10.0)), slideBack), 1e-9);
        EXPECT_LT(misfit(lamp(Vec3(4.0, 14.0, 12.0)), slideBack), 1e-9); // behind the viewer
    }
}

TEST(Psm, InverseLightHasTheSameWarp) {
    // §14.2.1: a light behind the viewer needs the inverse projection, which changes depths alone.
    // Of two opposite suns over bodies that cast and receive one is behind the viewer; their rays
    // are the same, and so must the denominators be.
    for (const Vec3& direction :
         {Vec3(0.3, -1.0, -0.4), Vec3(1.0, 0.2, -0.7), Vec3(-0.5, -0.3, -0.6)}) {
        const Scene behind = bodies(direction);
        const Scene inFront = bodies(-direction);
        FitState state;
        const auto a = denominators(fitMap(behind.problem(), PsmOptions{}, state),
                                    cornersOf(behind.receivers));
        FitState other;
        const auto b = denominators(fitMap(inFront.problem(), PsmOptions{}, other),
                                    cornersOf(behind.receivers));
        for (std::size_t i = 0; i < a.size(); ++i)
            EXPECT_NEAR(a[i], b[i], 1e-9 * a[i]);
    }
}

TEST(Psm, WarpIsSteadyWhereTheLightPassesTheViewer) {
    // Through the direction across the view, where the post-projective light is at infinity.
    Vec2 before = Vec2::Zero();
    for (const double step : {-1e-3, -1e-7, -1e-12, 0.0, 1e-12, 1e-7, 1e-3}) {
        const Scene scene = bodies(Vec3(0.3, -1.0, step));
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), PsmOptions{}, state);
        const Vec2 warp = fit.liWarp;
        if (step > -1e-3) {
            EXPECT_NEAR(warp.norm(), before.norm(), 0.01 * before.norm()) << step;
        }
        before = warp;
    }
}

TEST(Psm, RowWIsTheDepthFromTheVirtualViewerUnderASideLight) {
    for (const double slideBack : {0.0, 0.25, 1.0}) {
        const Scene scene = bodies(Vec3(0.2, -1.0, 0.0));
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), PsmOptions{.slideBack = slideBack}, state);
        const double back = slideBack * std::sqrt(FirstDepth * LastDepth);
        EXPECT_NEAR(state.region.vsReceiverNear, FirstDepth, 1e-9);
        EXPECT_NEAR(state.region.vsReceiverFar, LastDepth, 1e-9);
        const auto w = [&](double depth) {
            return clipOf(fit.clipFromWorld, Vec3(1.0, 2.0, -depth)).w();
        };
        EXPECT_NEAR(w(LastDepth) / w(FirstDepth), (LastDepth + back) / (FirstDepth + back), 1e-9);
    }
}

TEST(Psm, RegionIsInFrontOfTheLightCamera) {
    // The cone is narrower than 180°: w > 0 all over the region, if only just.
    const bool holds = rc::check([] {
        const Scene scene = *anyScene();
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), PsmOptions{}, state);
        if (!fit.hasMap()) return;
        for (const Vec2& q : state.region.liHull)
            RC_ASSERT(1.0 + fit.liWarp.dot(q - fit.liCentre) > 0.0);
    });
    EXPECT_TRUE(holds);
}

TEST(Psm, LampAtTheEyeSeesTheViewersPicture) {
    Scene scene = lamp(Vec3::Zero());
    scene.light.wsDirection = Vec3(0.3, -0.2, -1.0);
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), PsmOptions{.slideBack = 0.0}, state);
    ASSERT_EQ(fit.reason, FitReason::None);
    const std::vector<Vec3> points = cornersOf(scene.receivers);
    const auto w = denominators(fit, points);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(w[i], points[i].z() / points[0].z(), 1e-9);
}

TEST(Psm, MinersLampIsUniform) {
    const Scene scene = bodies(Vec3(0.0, 0.0, -1.0));
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), PsmOptions{}, state);
    EXPECT_EQ(fit.reason, FitReason::LightAlongView);
    EXPECT_EQ(fit.liWarp, Vec2::Zero());
}

TEST(Psm, OrthographicViewerHasAUniformMap) {
    Scene scene = outdoors();
    scene.viewer.clipFromView = orthographic(20.0, 20.0, 0.1, 100.0);
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), PsmOptions{}, state);
    EXPECT_EQ(fit.reason, FitReason::None);
    EXPECT_EQ(fit.liWarp, Vec2::Zero());
}
