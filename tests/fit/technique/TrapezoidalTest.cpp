/// Martin and Tan's construction, line by line.
#include "fit/technique/Trapezoidal.h"

#include "fit/Problems.h"

#include "fit/focus/LightImage.h"

#include <gtest/gtest.h>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

constexpr double BeamEnd = 40.0;
constexpr double HalfFov = 30.0 * Degree;

/// The viewer at the origin looks along -z at a thin beam that reaches from behind it to depth 40.
Scene beam(const Vec3& lightDirection) {
    Scene scene;
    scene.size = BeamEnd;
    scene.viewer.clipFromView = perspective(2.0 * HalfFov, 1.0, 0.1, 100.0);
    scene.light.wsDirection = lightDirection;
    scene.addBody({Vec3(0.0, 0.0, -10.0), Vec3(0.01, 0.01, BeamEnd - 10.0)});
    return scene;
}

/// The position of the depth in the trapezoid, 0 at its top line and 1 at its base line, after the
/// warp; distances in the light image.
double placeOf(const ShadowFit& fit, const Vec2& direction, double top, double height, double s) {
    const auto warped = [&](double at) {
        const double q = at - direction.dot(fit.liCentre);
        return q / (1.0 + fit.liWarp.dot(direction) * q);
    };
    return (warped(s) - warped(top)) / (warped(top + height) - warped(top));
}

} // namespace

TEST(Trapezoidal, FocusPointLiesOnTheEightyPercentLine) {
    for (const double degrees : {40.0, 70.0, 90.0, 120.0})
        for (const TrapezoidalOptions& options :
             {TrapezoidalOptions{}, TrapezoidalOptions{.focusDistance = 0.1, .focusShare = 0.5}}) {
            const double angle = degrees * Degree;
            const double sine = std::sin(angle);
            const Scene scene = beam(Vec3(0.0, -sine, -std::cos(angle)));
            FitState state;
            const ShadowFit fit = fitMap(scene.problem(), options, state);
            ASSERT_EQ(fit.reason, FitReason::None) << degrees;
            const LightImage image(scene.light);
            const Vec2 direction =
                image.lsFromDirection(Vec3(0.0, 0.0, -1.0)).head<2>().normalized();
            EXPECT_NEAR(cross(direction, fit.liWarp), 0.0, 1e-12);
            // The frustum's corners stand across the centre line by the half height times cos γ.
            const double farDepth = state.region.vsReceiverFar;
            const double width = farDepth * std::tan(HalfFov) * std::abs(std::cos(angle));
            const double top = std::min(0.0, sine * farDepth - width);
            const double height = sine * farDepth + width - top;
            const double focus = options.focusDistance * sine * farDepth;
            if (focus - top >= options.focusShare * height) {
                EXPECT_EQ(fit.liWarp, Vec2::Zero());
                continue;
            }
            EXPECT_NEAR(placeOf(fit, direction, top, height, focus), options.focusShare, 1e-9)
                << degrees << "°";
        }
}

TEST(Trapezoidal, ApexIsAtThePapersEta) {
    // η = (λ d' + λ d' ξ) / (λ - 2 d' - λ ξ), ξ = -0.6 on the 80 % line; γ = 90°, so that the
    // frustum's image starts at the viewer and ends at its far depth.
    const Scene scene = beam(Vec3(0.0, -1.0, 0.0));
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), TrapezoidalOptions{}, state);
    const double lambda = state.region.vsReceiverFar;
    const double d = TrapezoidalOptions{}.focusDistance * lambda;
    const double xi = -0.6;
    const double eta = (lambda * d + lambda * d * xi) / (lambda - 2.0 * d - lambda * xi);
    for (const double depth : {1.0, 10.0, 35.0}) {
        const double w = clipOf(fit.clipFromWorld, Vec3(0.0, 0.0, -depth)).w();
        const double w0 = clipOf(fit.clipFromWorld, Vec3::Zero()).w();
        EXPECT_NEAR(w / w0, (eta + depth) / eta, 1e-9);
    }
}

TEST(Trapezoidal, ShareThatIsThereAlreadyNeedsNoWarp) {
    const Scene scene = beam(Vec3(0.0, -1.0, 0.0));
    FitState state;
    const ShadowFit fit = fitMap(
        scene.problem(), TrapezoidalOptions{.focusDistance = 0.85, .focusShare = 0.8}, state);
    EXPECT_EQ(fit.reason, FitReason::None);
    EXPECT_EQ(fit.liWarp, Vec2::Zero());
}

TEST(Trapezoidal, FrustumHoldsTheRegion) {
    // No point of the region is in front of the top line, so the shared clamp has nothing to do.
    const bool holds = rc::check([] {
        const Scene scene = *anyScene();
        FitState state;
        const ShadowFit fit = fitMap(scene.problem(), TrapezoidalOptions{}, state);
        RC_ASSERT(fit.reason != FitReason::WarpClamped || isLostInRounding(scene, state));
    });
    EXPECT_TRUE(holds);
}

TEST(Trapezoidal, MinersLampIsUniform) {
    const Scene scene = beam(Vec3(0.0, 0.0, -1.0));
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), TrapezoidalOptions{}, state);
    EXPECT_EQ(fit.reason, FitReason::LightAlongView);
    EXPECT_EQ(fit.liWarp, Vec2::Zero());
}

TEST(Trapezoidal, OrthographicViewerHasAUniformMap) {
    Scene scene = outdoors();
    scene.viewer.clipFromView = orthographic(20.0, 20.0, 0.1, 100.0);
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), TrapezoidalOptions{}, state);
    EXPECT_EQ(fit.reason, FitReason::None);
    EXPECT_EQ(fit.liWarp, Vec2::Zero());
}
