// Fits to the texels of an earlier map.
#include "fit/Oracle.h"
#include "fit/Trials.h"

#include "fit/core/Fit.h"
#include "fit/geometry/Polygon2.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// Texels that the earlier map keeps free beyond its filter's radius, for its window to move in.
constexpr double Room = 30.0;

constexpr std::size_t RaysPerFrame = 60;

/// From the same map's point of view, the origin is elsewhere: x relative to it is x + shift.
ShadowFit aboutAnotherOrigin(ShadowFit fit, const Vec3& wsShift) {
    fit.clipFromWorld.col(3) -= fit.clipFromWorld.leftCols<3>() * wsShift;
    return fit;
}

/// The viewer a few frames later.
Scene later(Scene scene, Dice& dice) {
    Eigen::Affine3d move = Eigen::Affine3d::Identity();
    move.translate(0.01 * scene.size * dice.cube());
    move.rotate(Eigen::AngleAxisd(dice.in(0.0, 0.03), dice.direction()));
    scene.viewer.viewFromWorld = move.matrix() * scene.viewer.viewFromWorld;
    return scene;
}

class KeptTexels : public testing::TestWithParam<Trial> {
protected:
    /// Checks `property(scene, earlier, fit, shadowed points)` where the earlier map's texels do for
    /// a scene of some frames later.
    template <typename Property>
    void forAnyLaterFrame(const Property& property) {
        std::size_t maps = 0;
        std::size_t kept = 0;
        const bool holds = rc::check([&] {
            Scene scene = *anyScene();
            Dice dice = anyDice();
            ShadowProblem roomy = scene.problem();
            roomy.filterRadius += Room;
            FitState state;
            const ShadowFit earlier = GetParam().fit(roomy, state);
            scene = later(scene, dice);
            const Vec3 wsShift = scene.size * dice.cube();
            FitState fresh;
            if (!earlier.hasMap() || !GetParam().fit(scene.problem(), fresh).hasMap()) return;
            ++maps;
            FitState other;
            const std::optional<ShadowFit> fit =
                fitToTexels(scene.problem(), other, aboutAnotherOrigin(earlier, wsShift), wsShift);
            if (!fit) return;
            ++kept;
            RC_ASSERT(fit->hasMap());
            property(scene, earlier, *fit, shadowedPoints(scene, dice, RaysPerFrame));
        });
        EXPECT_TRUE(holds);
        // A stable map keeps a texel alone to move in.
        EXPECT_GT(kept, maps / 5);
    }
};

INSTANTIATE_TEST_SUITE_P(Techniques, KeptTexels, testing::ValuesIn(trialsThatServeAll()), ByName{});

TEST_P(KeptTexels, LieOnTheSameRays) {
    forAnyLaterFrame([](const Scene& scene, const ShadowFit& earlier, const ShadowFit& fit,
                        const std::vector<ShadowedPoint>& points) {
        std::optional<Vec2> moved;
        for (const ShadowedPoint& point : points) {
            if (!(clipOf(earlier.clipFromWorld, point.wsReceiver).w() > 0.0)) continue;
            const Vec2 before = texelOf(earlier.clipFromWorld, scene, point.wsReceiver);
            // Far outside of the earlier map, its texels are as fine as rounding.
            if (before.cwiseAbs().maxCoeff() > 1e5) continue;
            const Vec2 by = texelOf(fit.clipFromWorld, scene, point.wsReceiver) - before;
            RC_LOG() << "moved by " << by.transpose() << " texels\n";
            RC_ASSERT((by - by.array().round().matrix()).norm() < 1e-3);
            // All alike.
            if (moved) RC_ASSERT((by - *moved).norm() < 1e-3);
            moved = by;
        }
    });
}

TEST_P(KeptTexels, ShowWhatIsShadowedWithinTheBorder) {
    forAnyLaterFrame([](const Scene& scene, const ShadowFit&, const ShadowFit& fit,
                        const std::vector<ShadowedPoint>& points) {
        const Mat4 rounded = roundedToFloat(fit.clipFromWorld);
        for (const ShadowedPoint& point : points) {
            RC_ASSERT(clipOf(rounded, point.wsReceiver).w() > 0.0);
            RC_ASSERT(insideBorder(texelOf(rounded, scene, point.wsReceiver), scene) >=
                      scene.filterRadius + 1.0);
            const double z = fit.clipFromWorld.row(2).dot(point.wsReceiver.homogeneous());
            const double depth = fit.depthScale * z + fit.depthOffset;
            RC_ASSERT(depth > 0.0 && depth < 1.0);
        }
    });
}

TEST_P(KeptTexels, AWindowIsAllThatAMapHasRoomFor) {
    std::size_t maps = 0;
    std::size_t cut = 0;
    EXPECT_TRUE(rc::check([&] {
        const Scene scene = *anyScene();
        FitState state;
        ShadowFit fit = GetParam().fit(scene.problem(), state);
        if (!fit.hasMap()) return;
        const Polygon2 hull = state.region.liHull;
        focusOnWindow(fit, state);
        const std::span<const Vec2> window = fit.liFocus.span();
        const Vec2 half = Vec2(scene.mapWidth, scene.mapHeight) / 2.0;
        ++maps;
        // Four corners, unless the map reaches its horizon.
        cut += window.size() != 4 ? 1 : 0;
        for (std::size_t i = 0; i < window.size(); ++i) {
            const Vec2 edge = window[(i + 1) % window.size()] - window[i];
            for (const Vec2& q : hull)
                RC_ASSERT(cross(edge, q - window[i]) >= 0.0);
            const Vec3 ws =
                fit.wsEye + fit.lsFromWs.transpose() *
                                Vec3(window[i].x(), window[i].y(), fit.directional ? 0.0 : -1.0);
            RC_ASSERT(clipOf(fit.clipFromWorld, ws).w() > 0.0);
            const double inside = insideBorder(texelOf(fit.clipFromWorld, scene, ws), scene);
            RC_ASSERT(inside > -2e-3 * half.maxCoeff());
            if (window.size() == 4) RC_ASSERT(inside < 1e-6 * half.maxCoeff());
        }
    }));
    EXPECT_LT(cut, maps / 4);
}

TEST(KeptTexels, AreGivenUpWhereTheyAreTooFewOrElsewhere) {
    const Scene scene = outdoors();
    FitState state;
    const ShadowFit earlier = trialNamed("Uniform").fit(scene.problem(), state);
    ASSERT_TRUE(earlier.hasMap());
    const auto fitTo = [&](const ShadowFit& map, const Scene& now) {
        FitState other;
        return fitToTexels(now.problem(), other, map, Vec3::Zero());
    };
    ShadowFit smaller = earlier;
    smaller.clipFromWorld.topRows<2>() *= 1.02;
    EXPECT_FALSE(fitTo(smaller, scene));
    ShadowFit larger = earlier;
    larger.clipFromWorld.topRows<2>() *= 0.98;
    EXPECT_TRUE(fitTo(larger, scene));
    ShadowFit mirrored = larger;
    mirrored.clipFromWorld.row(0) *= -1.0;
    EXPECT_FALSE(fitTo(mirrored, scene));
    EXPECT_FALSE(fitTo(ShadowFit{}, scene));
    // A warp whose horizon runs through what is seen.
    ShadowFit warped = larger;
    warped.clipFromWorld.row(3) += 1.5 * warped.clipFromWorld.row(0);
    EXPECT_FALSE(fitTo(warped, scene));
    Scene empty = scene;
    empty.casters.clear();
    EXPECT_FALSE(fitTo(larger, empty));
}

} // namespace
