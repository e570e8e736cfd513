#include "fit/Problems.h"

#include "fit/problem/TexelInPixels.h"
#include "fit/technique/Uniform.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// A map of a parallel light that looks along -z at a square of 8 x 8.
ShadowFit mapAlongZ(const Mat4& lightFromWorld = Mat4::Identity()) {
    ShadowFit fit;
    fit.reason = FitReason::None;
    fit.clipFromWorld = orthographic(4.0, 4.0, 1.0, 100.0) * lightFromWorld;
    return fit;
}

/// 16 x 12 units on 800 x 600 pixels, each 0.02 units, seen along `forward`.
ShadowViewer parallelViewer(const Vec3& forward = -Vec3::UnitZ()) {
    ShadowViewer viewer;
    viewer.viewFromWorld = lookAlong(Vec3::Zero(), forward);
    viewer.clipFromView = orthographic(8.0, 6.0, 1.0, 100.0);
    return viewer;
}

const Vec2 Picture(800.0, 600.0);
const Vec2 Map(100.0, 100.0); ///< texels of 0.08 units
const Vec3 Ahead(0.3, -0.2, -10.0);

/// The tangent plane's derivative, from steps along any two directions that span it.
Eigen::Matrix2d jacobian(const Mat4& clipFromWorld, const Vec2& size, const Vec3& ws, const Vec3& a,
                         const Vec3& b) {
    Eigen::Matrix2d result;
    result << derivative(clipFromWorld, size, ws, a), derivative(clipFromWorld, size, ws, b);
    return result;
}

} // namespace

TEST(TexelInPixels, FrontalPlaneIsTheRatioOfTexelToPixel) {
    const ShadowViewer viewer = parallelViewer();
    EXPECT_NEAR(*texelInPixels(mapAlongZ(), Map, viewer, Picture, Ahead, Vec3::UnitZ()), 4.0,
                1e-12);
    // The longer side counts, whichever it is, and however the map is turned.
    EXPECT_NEAR(*texelInPixels(mapAlongZ(), {100, 200}, viewer, Picture, Ahead, Vec3::UnitZ()), 4.0,
                1e-12);
    EXPECT_NEAR(*texelInPixels(mapAlongZ(), {800, 200}, viewer, Picture, Ahead, Vec3::UnitZ()), 2.0,
                1e-12);
    Mat4 roll = Mat4::Identity();
    roll.topLeftCorner<3, 3>() = Eigen::AngleAxisd(0.4, Vec3::UnitZ()).toRotationMatrix();
    EXPECT_NEAR(*texelInPixels(mapAlongZ(roll), {800, 200}, viewer, Picture, Ahead, Vec3::UnitZ()),
                2.0, 1e-12);
}

TEST(TexelInPixels, PerspectivePixelGrowsWithDepth) {
    ShadowViewer viewer;
    viewer.clipFromView = perspective(60.0 * Degree, 4.0 / 3.0, 0.1, 100.0);
    for (const double depth : {1.0, 10.0, 50.0}) {
        const double pixel = 2.0 * depth * std::tan(30.0 * Degree) / Picture.y();
        EXPECT_NEAR(*texelInPixels(mapAlongZ(), Map, viewer, Picture, Vec3(0.0, 0.0, -depth),
                                   Vec3::UnitZ()),
                    0.08 / pixel, 1e-9);
    }
}

TEST(TexelInPixels, ObliqueToTheLightGrowsByItsCosine) {
    for (const double degrees : {30.0, 60.0, 85.0}) {
        const double angle = degrees * Degree;
        const Vec3 normal(0.0, std::sin(angle), std::cos(angle));
        // Seen frontally, a texel is as long as on the surface.
        const Vec3 ws = -10.0 * normal;
        EXPECT_NEAR(*texelInPixels(mapAlongZ(), Map, parallelViewer(-normal), Picture, ws, normal),
                    4.0 / std::cos(angle), 1e-9);
    }
}

TEST(TexelInPixels, ObliqueToTheViewerKeepsItsLongSide) {
    for (const double degrees : {30.0, 60.0, 85.0, 90.0}) {
        const Vec3 forward(0.0, -std::sin(degrees * Degree), -std::cos(degrees * Degree));
        EXPECT_NEAR(*texelInPixels(mapAlongZ(), Map, parallelViewer(forward), Picture,
                                   10.0 * forward, Vec3::UnitZ()),
                    4.0, 1e-9);
    }
}

TEST(TexelInPixels, EdgeOnToTheLightHasNoBound) {
    const Vec3 forward = Vec3(0.0, -1.0, -1.0).normalized();
    EXPECT_GT(*texelInPixels(mapAlongZ(), Map, parallelViewer(forward), Picture, 10.0 * forward,
                             Vec3::UnitY()),
              1e12);
    EXPECT_GT(*texelInPixels(mapAlongZ(), Map, parallelViewer(), Picture, Ahead, Vec3::UnitX()),
              1e12);
}

TEST(TexelInPixels, BesideTheMapItIsThatOfALargerMap) {
    EXPECT_NEAR(*texelInPixels(mapAlongZ(), Map, parallelViewer(), Picture, Vec3(70.0, 0.0, -10.0),
                               Vec3::UnitZ()),
                4.0, 1e-12);
}

TEST(TexelInPixels, NoneWhereThereIsNoSuchExtent) {
    const auto at = [](const Vec3& ws, const Vec3& normal) {
        ShadowViewer viewer;
        viewer.clipFromView = perspective(60.0 * Degree, 1.0, 0.1, 100.0);
        return texelInPixels(mapAlongZ(), Map, viewer, Picture, ws, normal);
    };
    EXPECT_TRUE(at(Ahead, Vec3::UnitZ()));
    EXPECT_FALSE(at(-Ahead, Vec3::UnitZ())) << "behind the viewer";
    EXPECT_FALSE(at(Vec3(1.0, 1.0, 0.0), Vec3::UnitZ())) << "beside the viewer's eye";
    EXPECT_FALSE(at(Ahead, Vec3::Zero()));
    EXPECT_FALSE(at(Ahead, Vec3(0.0, NaN, 1.0)));
    EXPECT_FALSE(at(Ahead, Vec3(0.0, Infinity, 1.0)));
    EXPECT_FALSE(at(Vec3(0.0, NaN, -1.0), Vec3::UnitZ()));
    EXPECT_FALSE(at(Vec3(0.0, Infinity, -1.0), Vec3::UnitZ()));

    ShadowFit lamp = mapAlongZ();
    lamp.clipFromWorld = perspective(60.0 * Degree, 1.0, 0.1, 100.0);
    EXPECT_TRUE(texelInPixels(lamp, Map, parallelViewer(), Picture, Ahead, Vec3::UnitZ()));
    EXPECT_FALSE(texelInPixels(lamp, Map, parallelViewer(), Picture, -Ahead, Vec3::UnitZ()))
        << "behind the lamp";
    EXPECT_FALSE(texelInPixels(ShadowFit{}, Map, parallelViewer(), Picture, Ahead, Vec3::UnitZ()))
        << "no map";
    lamp.clipFromWorld.setZero();
    EXPECT_FALSE(texelInPixels(lamp, Map, parallelViewer(), Picture, Ahead, Vec3::UnitZ()));
}

// Against steps of texel and pixel along two other directions of the plane; and whether matrices'
// and normals' lengths, or the side, matter.
RC_GTEST_PROP(TexelInPixels, IsOneOverTheLeastStretch, ()) {
    const Scene scene = *anyScene();
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), UniformOptions{}, state);
    RC_PRE(fit.hasMap());
    const Mat4 viewClip = scene.viewer.clipFromView * scene.viewer.viewFromWorld;
    const Vec2 mapSize(scene.mapWidth, scene.mapHeight);
    Dice dice(*anySeed());
    for (int i = 0; i < 20; ++i) {
        const Vec3 ws = eyeOf(scene.viewer) +
                        scene.size * dice.in(0.1, 2.0) * (forwardOf(scene.viewer) + dice.cube());
        const Vec3 normal = dice.direction();
        const auto m = texelInPixels(fit, mapSize, scene.viewer, Picture, ws, normal);
        const bool inFront =
            clipOf(fit.clipFromWorld, ws).w() > 0.0 && clipOf(viewClip, ws).w() > 0.0;
        RC_ASSERT(m.has_value() == inFront);
        if (!m) continue;
        const Vec3 a = normal.cross(dice.direction()).normalized();
        const Vec3 b = (normal.cross(a) + dice.in(-0.5, 0.5) * a) * dice.in(0.5, 2.0);
        const Eigen::Matrix2d texel = jacobian(fit.clipFromWorld, mapSize, ws, a, b);
        const Eigen::Matrix2d pixel = jacobian(viewClip, Picture, ws, a, b);
        const double least = (texel * pixel.inverse()).jacobiSvd().singularValues()[1];
        // As exact as such a matrix is: edge-on ones have few digits left.
        const double condition =
            texel.jacobiSvd().singularValues()[0] / texel.jacobiSvd().singularValues()[1] *
            (pixel.jacobiSvd().singularValues()[0] / pixel.jacobiSvd().singularValues()[1]);
        RC_ASSERT(std::abs(*m * least - 1.0) <= 1e-12 * condition);

        ShadowFit scaledFit = fit;
        scaledFit.clipFromWorld *= 3.0;
        ShadowViewer scaledViewer = scene.viewer;
        scaledViewer.clipFromView *= 0.1;
        const auto same =
            texelInPixels(scaledFit, mapSize, scaledViewer, Picture, ws, -1e5 * normal);
        RC_ASSERT(same.has_value());
        RC_ASSERT(std::abs(*same / *m - 1.0) <= 1e-12 * condition);
    }
}

// Against finite differences of the map's and the picture's coordinates alone.
RC_GTEST_PROP(TexelInPixels, BoundsWhatAStepOfATexelMoves, ()) {
    const Scene scene = *anyScene();
    FitState state;
    const ShadowFit fit = fitMap(scene.problem(), UniformOptions{}, state);
    RC_PRE(fit.hasMap());
    const Mat4 viewClip = scene.viewer.clipFromView * scene.viewer.viewFromWorld;
    const Vec2 mapSize(scene.mapWidth, scene.mapHeight);
    Dice dice(*anySeed());
    const Vec3 ws = eyeOf(scene.viewer) +
                    scene.size * dice.in(0.5, 2.0) * (forwardOf(scene.viewer) + 0.3 * dice.cube());
    const double lsDepth = -fit.lsFromWs.row(2).dot(ws - fit.wsEye);
    RC_PRE(fit.directional || lsDepth > 0.1 * scene.size);
    const Vec3 normal = dice.direction();
    const auto m = texelInPixels(fit, mapSize, scene.viewer, mapSize, ws, normal);
    RC_PRE(m.has_value());
    RC_PRE(std::isfinite(*m));
    const Vec3 a = normal.unitOrthogonal();
    const Vec3 b = normal.cross(a);
    const double step = 1e-5 * scene.size;
    double greatest = 0.0;
    double mostTexels = 0.0;
    double leastTexels = Infinity;
    constexpr int Directions = 720;
    for (int i = 0; i < Directions; ++i) {
        const double angle = i * std::numbers::pi / Directions;
        const Vec3 d = step * (std::cos(angle) * a + std::sin(angle) * b);
        const double texels =
            (texelOf(fit.clipFromWorld, scene, ws + d) - texelOf(fit.clipFromWorld, scene, ws - d))
                .norm();
        const double pixels =
            (texelOf(viewClip, scene, ws + d) - texelOf(viewClip, scene, ws - d)).norm();
        greatest = std::max(greatest, pixels / texels);
        mostTexels = std::max(mostTexels, texels);
        leastTexels = std::min(leastTexels, texels);
    }
    RC_ASSERT(greatest <= *m * (1.0 + 1e-3));
    // And one of the directions comes near it, unless it is a needle between two of them.
    constexpr double Needle = 30.0;
    if (mostTexels < Needle * leastTexels) RC_ASSERT(greatest >= *m * (1.0 - 1e-2));
}
