// A body's surface as few discs, and what view samples make of it.
#include "fit/Problems.h"

#include "fit/geometry/SurfaceCloud.h"
#include "fit/sampling/ViewSamples.h"

#include <gtest/gtest.h>

#include <limits>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// A rectangle from `a` along two sides, seen from the side of u x v.
void addRectangle(const Vec3& a, const Vec3& u, const Vec3& v, std::vector<Vec3>& positions,
                  Triangles& triangles) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), {a, a + u, a + u + v, a + v});
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
}

/// A floor at y = -1 and a wall at z = -20 of a room that reaches behind the viewer.
SurfaceCloud room() {
    std::vector<Vec3> positions;
    Triangles triangles;
    addRectangle({-5.0, -1.0, 20.0}, {10.0, 0.0, 0.0}, {0.0, 0.0, -40.0}, positions, triangles);
    addRectangle({-5.0, -1.0, -20.0}, {10.0, 0.0, 0.0}, {0.0, 6.0, 0.0}, positions, triangles);
    return makeSurfaceCloud(positions, triangles, 256);
}

std::vector<ViewSample> sample(const Scene& scene, std::span<const KnownSurface> surfaces) {
    ShadowProblem problem = scene.problem();
    problem.surfaces = surfaces;
    return samplesOf(problem, {.most = 1000, .enough = 1000});
}

/// The viewer in a room whose box ends far below and above what there is of it.
Scene inARoom() {
    Scene scene;
    scene.viewer.viewFromWorld = lookAlong(Vec3::Zero(), Vec3(0.0, -0.1, -1.0));
    scene.viewer.clipFromView = perspective(1.0, 1.5, 0.1, 100.0);
    scene.light.wsDirection = Vec3(0.0, -1.0, 0.2);
    scene.receivers.add({Vec3(0.0, 0.0, 0.0), Vec3(5.0, 30.0, 20.0)});
    scene.casters.add({Vec3(0.0, 5.0, 0.0), Vec3(5.0, 0.5, 20.0)});
    return scene;
}

} // namespace

TEST(SurfaceCloud, LiesOnTheTrianglesAndCoversThem) {
    std::vector<Vec3> positions;
    Triangles triangles;
    addRectangle({0.0, 2.0, 0.0}, {0.0, 0.0, 3.0}, {4.0, 0.0, 0.0}, positions, triangles);
    const SurfaceCloud cloud = makeSurfaceCloud(positions, triangles, 64);
    ASSERT_EQ(cloud.surfels.size(), 64U);
    double area = 0.0;
    for (const Surfel& disc : cloud.surfels) {
        EXPECT_NEAR(disc.centre.y(), 2.0, 1e-12);
        EXPECT_TRUE(disc.normal.isApprox(Vec3::UnitY()));
        EXPECT_GE(disc.centre.x(), 0.0);
        EXPECT_LE(disc.centre.x(), 4.0);
        area += 3.141592653589793 * disc.radius * disc.radius;
    }
    EXPECT_NEAR(area, 2.0 * 12.0, 1e-9);
    // Few places are not covered.
    int covered = 0;
    Dice dice(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p(dice.in(0.0, 4.0), 2.0, dice.in(0.0, 3.0));
        covered += std::ranges::any_of(cloud.surfels, [&](const Surfel& disc) {
            return (disc.centre - p).norm() <= disc.radius;
        });
    }
    EXPECT_GE(covered, 950);
}

TEST(SurfaceCloud, SpreadsItsDiscsByArea) {
    std::vector<Vec3> positions;
    Triangles triangles;
    addRectangle({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, positions, triangles);
    addRectangle({9.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, positions, triangles);
    const SurfaceCloud cloud = makeSurfaceCloud(positions, triangles, 100);
    EXPECT_EQ(std::ranges::count_if(cloud.surfels,
                                    [](const Surfel& disc) { return disc.centre.x() < 5.0; }),
              25);
}

TEST(SurfaceCloud, LeavesOutWhatIsNoTriangle) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vec3> positions{
        {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {nan, 0.0, 0.0}, {2.0, 0.0, 0.0}};
    // One with a NaN, one without area, one with an index beyond.
    EXPECT_TRUE(makeSurfaceCloud(positions, Triangles{{0, 1, 3}, {0, 1, 4}, {0, 1, 99}}, 8)
                    .surfels.empty());
    EXPECT_TRUE(makeSurfaceCloud({}, {}, 8).surfels.empty());
    const SurfaceCloud cloud =
        makeSurfaceCloud(positions, Triangles{{0, 1, 3}, {0, 1, 2}, {0, 1, 99}}, 8);
    ASSERT_EQ(cloud.surfels.size(), 8U);
    for (const Surfel& disc : cloud.surfels)
        EXPECT_TRUE(disc.centre.allFinite() && disc.centre.x() + disc.centre.y() <= 1.0 + 1e-12);
}

/// Triangles that no disc falls to need not be looked at twice.
TEST(SurfaceCloud, IsTheSameWhereTrianglesArePassedOver) {
    std::vector<Vec3> positions;
    Triangles triangles;
    Dice dice(5);
    for (int i = 0; i < 300; ++i)
        addRectangle(dice.cube(), dice.cube(), dice.chance(0.2) ? Vec3(Vec3::Zero()) : dice.cube(),
                     positions, triangles);
    const SurfaceCloud whole = makeSurfaceCloud(positions, triangles, 64);
    SurfaceCloudBuilder builder(64);
    std::vector<double> sums;
    for (const auto& [a, b, c] : triangles) {
        builder.measure(positions[a], positions[b], positions[c]);
        sums.push_back(builder.measured());
    }
    int skipped = 0;
    for (std::size_t i = 0; i < triangles.size();) {
        const std::size_t end = std::min(i + 1 + dice.below(4), triangles.size());
        if (builder.skip(sums[end - 1])) {
            ++skipped;
            i = end;
        }
        for (; i < end; ++i)
            builder.spread(positions[triangles[i][0]], positions[triangles[i][1]],
                           positions[triangles[i][2]]);
    }
    EXPECT_GT(skipped, 100);
    const SurfaceCloud& cloud = builder.cloud();
    ASSERT_EQ(cloud.surfels.size(), whole.surfels.size());
    for (std::size_t i = 0; i < cloud.surfels.size(); ++i) {
        EXPECT_EQ(cloud.surfels[i].centre, whole.surfels[i].centre);
        EXPECT_EQ(cloud.surfels[i].normal, whole.surfels[i].normal);
        EXPECT_EQ(cloud.surfels[i].radius, whole.surfels[i].radius);
    }
}

TEST(SurfaceCloud, TellsWhereARoomsSurfaceIsFromWithin) {
    const Scene scene = inARoom();
    const SurfaceCloud cloud = room();
    const std::vector<KnownSurface> surfaces{{.receiver = 0, .cloud = &cloud}};
    const LightImage image(scene.light);
    const auto onFloor = [&](const std::vector<ViewSample>& samples) {
        // A floor's derivative is that of the plane y = -1: every sample's must be, here.
        std::size_t count = 0;
        const Mat4 clip = scene.viewer.clipFromView * scene.viewer.viewFromWorld;
        for (const ViewSample& s : samples) {
            // The point of the floor on the sample's light ray.
            const Vec3 q = image.lsFromWs().transpose() * Vec3(s.liPoint.x(), s.liPoint.y(), 0.0);
            const Vec3 d = scene.light.wsDirection;
            const Vec3 p = q + d * ((-1.0 - q.y()) / d.y());
            const Vec4 c = clip * p.homogeneous();
            if (c.w() <= 0.0) continue;
            // Its motion per unit of device x, kept on the floor.
            Mat3 rows;
            rows.row(0) = (clip.row(0) - c.x() / c.w() * clip.row(3)).head<3>() / c.w();
            rows.row(1) = (clip.row(1) - c.y() / c.w() * clip.row(3)).head<3>() / c.w();
            rows.row(2) = Vec3::UnitY().transpose();
            const Vec3 step = rows.inverse().col(0);
            const Vec2 expected = image.lsFromDirection(step).head<2>();
            if ((expected - s.ndcFromLi.inverse().col(0)).norm() < 1e-6 * expected.norm()) ++count;
        }
        return count;
    };
    const auto known = sample(scene, surfaces);
    ASSERT_GT(known.size(), 50U);
    EXPECT_EQ(onFloor(known), known.size());   // the wall faces away from this light
    EXPECT_EQ(onFloor(sample(scene, {})), 0U); // the box knows of no floor at y = -1
}

TEST(SurfaceCloud, MovesWithItsBody) {
    const Scene scene = inARoom();
    const SurfaceCloud cloud = room();
    // Made at half the size, turned and elsewhere, then put where it was.
    Transform3 wsFromOwn = Transform3::Identity();
    wsFromOwn.translate(Vec3(3.0, -2.0, 1.0))
        .rotate(Eigen::AngleAxisd(0.7, Vec3::UnitZ()))
        .scale(2.0);
    SurfaceCloud own;
    const Transform3 ownFromWs = wsFromOwn.inverse();
    for (const Surfel& disc : cloud.surfels)
        own.surfels.push_back({ownFromWs * disc.centre,
                               (ownFromWs.linear() * disc.normal).normalized(), disc.radius / 2.0});
    const std::vector<KnownSurface> plain{{.receiver = 0, .cloud = &cloud}};
    const std::vector<KnownSurface> moved{{.receiver = 0, .cloud = &own, .wsFromCloud = wsFromOwn}};
    const auto a = sample(scene, plain);
    const auto b = sample(scene, moved);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_LT((a[i].liPoint - b[i].liPoint).norm(), 1e-6);
}
