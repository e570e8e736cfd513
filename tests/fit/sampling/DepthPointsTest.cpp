// Surfaces out of a grid of depths, whose points and normals are known in closed form.
#include "fit/Problems.h"

#include "fit/sampling/DepthPoints.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <functional>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

/// A picture of 480 x 270 pixels, of which every ninth in each row and column is read.
constexpr std::size_t Columns = 53;
constexpr std::size_t Rows = 29;
constexpr double PixelsX = 480.0;
constexpr double PixelsY = 270.0;
constexpr double Step = 9.0;

/// What is seen along a ray from the origin: the multiple of its direction. Infinite for nothing.
using World = std::function<double(const Vec3& direction)>;

struct DrawnGrid {
    DepthGrid grid;
    std::vector<float> depths;
};

/// Draws a world as a renderer does that stores depths in 24 bits.
DrawnGrid draw(const World& world, const Mat4& clipFromWorld, bool isReversed = false) {
    DrawnGrid drawn;
    DepthGrid& grid = drawn.grid;
    grid.columns = Columns;
    grid.rows = Rows;
    grid.isReversed = isReversed;
    grid.isFloat = isReversed;
    grid.ndcFirst = {10.0 / PixelsX - 1.0, 10.0 / PixelsY - 1.0};
    grid.ndcStep = {2.0 * Step / PixelsX, 2.0 * Step / PixelsY};
    grid.ndcBeside = {2.0 / PixelsX, 2.0 / PixelsY};
    const Mat4 worldFromClip = clipFromWorld.inverse();
    const std::array<Vec2, DepthGrid::Sides> shifts = {Vec2(0, 0), Vec2(-1, 0), Vec2(1, 0),
                                                       Vec2(0, -1), Vec2(0, 1)};
    for (const Vec2& shift : shifts)
        for (std::size_t i = 0; i < Columns * Rows; ++i) {
            const Vec2 cell(static_cast<double>(i % Columns), static_cast<double>(i / Columns));
            const Vec2 ndc = grid.ndcFirst + grid.ndcStep.cwiseProduct(cell) +
                             grid.ndcBeside.cwiseProduct(shift);
            const Vec4 far = worldFromClip * Vec4(ndc.x(), ndc.y(), 0.5, 1.0);
            const Vec3 direction = (far.head<3>() / far.w()).normalized();
            const double distance = world(direction);
            double depth = grid.nothing();
            if (std::isfinite(distance)) {
                const Vec4 clip = clipFromWorld * Vec3(distance * direction).homogeneous();
                depth = (1.0 + (isReversed ? -1.0 : 1.0) * clip.z() / clip.w()) / 2.0;
            }
            constexpr double Unit = 16777215.0;
            drawn.depths.push_back(
                static_cast<float>(isReversed ? depth : std::round(depth * Unit) / Unit));
        }
    for (std::size_t side = 0; side < DepthGrid::Sides; ++side)
        grid.depths[side] = std::span(drawn.depths).subspan(side * Columns * Rows, Columns * Rows);
    return drawn;
}

SeenSurfaces surfacesOf(const World& world, const Mat4& clipFromWorld, bool isReversed = false) {
    const DrawnGrid drawn = draw(world, clipFromWorld, isReversed);
    SeenSurfaces seen;
    Lixel::surfacesOf(drawn.grid, clipFromWorld, seen);
    return seen;
}

World plane(const Vec3& normal, double offset) {
    return [=](const Vec3& direction) {
        const double t = -offset / normal.dot(direction);
        return t > 0.0 ? t : std::numeric_limits<double>::infinity();
    };
}

World sphere(const Vec3& centre, double radius) {
    return [=](const Vec3& direction) {
        const double along = direction.dot(centre);
        const double root = along * along - centre.squaredNorm() + radius * radius;
        return root < 0.0 ? std::numeric_limits<double>::infinity() : along - std::sqrt(root);
    };
}

World nearest(const World& a, const World& b) {
    return [=](const Vec3& direction) { return std::min(a(direction), b(direction)); };
}

constexpr double NearPlane = 0.5;
const Mat4 ClipFromWorld = perspective(1.0, PixelsX / PixelsY, NearPlane, 200.0);

/// How far a point may be from where it is: its depth is rounded by half of 2^-24, and to a float by
/// less than that, which is z^2 / near units of depth each; a ray is up to 1.5 times as long.
double rounding(const Vec3& ws, double nearPlane) {
    return 1.5 * ws.z() * ws.z() / nearPlane / 16777216.0;
}

} // namespace

TEST(DepthPoints, OfAPlaneLieOnIt) {
    // A ground 2 below, and a wall that is seen at an angle.
    for (const Vec3& normal : {Vec3(0.0, 1.0, 0.0), Vec3(0.8, 0.0, 0.6), Vec3(-0.48, 0.6, 0.64)}) {
        const SeenSurfaces seen = surfacesOf(plane(normal, 2.0), ClipFromWorld);
        ASSERT_GT(seen.points.size(), Columns * Rows / 4);
        for (const VisiblePoint& point : seen.points) {
            const double error = rounding(point.ws, NearPlane);
            EXPECT_NEAR(point.ws.dot(normal) + 2.0, 0.0, error);
            // What may be wrong of it is left out.
            EXPECT_GT(point.wsNormal.dot(normal), std::cos(0.3)) << point.ws.transpose();
            EXPECT_NEAR(point.wsNormal.norm(), 1.0, 1e-12);
            if (-point.ws.z() < 10.0) {
                EXPECT_GT(point.wsNormal.dot(normal), std::cos(0.01));
            }
        }
    }
}

TEST(DepthPoints, OfNothingAreNone) {
    const World nothing = [](const Vec3&) { return std::numeric_limits<double>::infinity(); };
    const SeenSurfaces seen = surfacesOf(nothing, ClipFromWorld);
    EXPECT_TRUE(seen.points.empty());
    ASSERT_EQ(seen.empty.size(), Columns * Rows);
    for (const Vec4& ws : seen.empty) {
        const Vec4 clip = ClipFromWorld * ws;
        EXPECT_NEAR(clip.z() / clip.w(), 1.0, 1e-9);
    }
    // Without a far plane it is at infinity.
    Mat4 endless = ClipFromWorld;
    endless(2, 2) = -1.0;
    endless(2, 3) = -2.0 * NearPlane;
    for (const Vec4& ws : surfacesOf(nothing, endless).empty)
        EXPECT_NEAR(ws.w() / ws.norm(), 0.0, 1e-9);
}

TEST(DepthPoints, OfASphereHaveItsNormals) {
    const Vec3 centre(0.5, -0.3, -8.0);
    const double radius = 3.0;
    const SeenSurfaces seen = surfacesOf(sphere(centre, radius), ClipFromWorld);
    ASSERT_GT(seen.points.size(), 100U);
    std::size_t steep = 0;
    for (const VisiblePoint& point : seen.points) {
        EXPECT_NEAR((point.ws - centre).norm(), radius, rounding(point.ws, NearPlane));
        const Vec3 normal = (point.ws - centre) / radius;
        const double facing = -normal.dot(point.ws.normalized());
        // At the rim neighbours are on it or not, and half of what is beside bends away.
        if (facing < 0.3) {
            ++steep;
            continue;
        }
        EXPECT_GT(point.wsNormal.dot(normal), std::cos(0.02));
    }
    EXPECT_LT(steep, seen.points.size() / 6);
}

TEST(DepthPoints, AtAnEdgeAreThoseOfTheirSide) {
    // A wall that ends before a wall behind: nothing between them.
    const World front = [](const Vec3& direction) {
        const double t = -4.0 / direction.z();
        return t > 0.0 && t * direction.x() < 0.31 ? t : std::numeric_limits<double>::infinity();
    };
    const SeenSurfaces seen = surfacesOf(nearest(front, plane(Vec3::UnitZ(), 9.0)), ClipFromWorld);
    EXPECT_EQ(seen.points.size(), Columns * Rows);
    for (const VisiblePoint& point : seen.points) {
        EXPECT_NEAR(point.ws.z(), point.ws.z() > -6.0 ? -4.0 : -9.0, rounding(point.ws, NearPlane));
        EXPECT_GT(point.wsNormal.z(), std::cos(0.01));
    }
}

TEST(DepthPoints, OfWhatIsThinnerThanNeighboursAreLeftOut) {
    // Posts of half a pixel in the middle of each ninth column, before a wall.
    const double half = 0.25 * 2.0 / PixelsX;
    const World posts = [=](const Vec3& direction) {
        const double x =
            (ClipFromWorld(0, 0) * direction.x() / -direction.z() + 1.0) * PixelsX / 2.0;
        const double beside = std::remainder(x - 5.0, Step);
        return std::abs(beside) < half * PixelsX / 2.0 ? -4.0 / direction.z()
                                                       : std::numeric_limits<double>::infinity();
    };
    const SeenSurfaces seen = surfacesOf(nearest(posts, plane(Vec3::UnitZ(), 9.0)), ClipFromWorld);
    EXPECT_TRUE(seen.points.empty());
    EXPECT_TRUE(seen.empty.empty());
}

TEST(DepthPoints, OfAReversedDepthBufferAreTheSame) {
    const Vec3 normal(0.0, 1.0, 0.0);
    const SeenSurfaces plain = surfacesOf(plane(normal, 2.0), ClipFromWorld);
    const SeenSurfaces reversed = surfacesOf(plane(normal, 2.0), ClipFromWorld, true);
    // Its floats tell far depths better.
    EXPECT_GE(reversed.points.size(), plain.points.size());
    for (const VisiblePoint& point : reversed.points) {
        EXPECT_NEAR(point.ws.y(), -2.0, 1e-5);
        EXPECT_GT(point.wsNormal.y(), std::cos(0.3));
    }
    EXPECT_FALSE(reversed.empty.empty());
}

RC_GTEST_PROP(DepthPoints, TurnWithTheViewer, ()) {
    Dice dice(*anySeed());
    const Mat3 turn = Eigen::AngleAxisd(dice.in(-3.0, 3.0), dice.direction()).toRotationMatrix();
    Mat4 viewFromWorld = Mat4::Identity();
    viewFromWorld.topLeftCorner<3, 3>() = turn;
    const Vec3 normal = Vec3(dice.in(-0.5, 0.5), dice.in(-0.5, 0.5), 1.0).normalized();
    const Vec3 wsNormal = turn.transpose() * normal;
    const SeenSurfaces seen =
        surfacesOf(plane(wsNormal, dice.in(1.0, 20.0)), Mat4(ClipFromWorld * viewFromWorld));
    RC_ASSERT(seen.points.size() > Columns * Rows / 4);
    for (const VisiblePoint& point : seen.points)
        RC_ASSERT(point.wsNormal.dot(wsNormal) > std::cos(0.3));
}
