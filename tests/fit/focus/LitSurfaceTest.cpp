#include "fit/focus/LitSurface.h"

#include "fit/Problems.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

LightImage sunFrom(const Vec3& wsTowards) {
    return LightImage({.wsDirection = -wsTowards});
}

LightImage lampAt(const Vec3& wsPosition) {
    return LightImage({.kind = LightKind::Point, .wsPosition = wsPosition});
}

SelfShadowFree blockOf(const Aabb& box) {
    return {.around = {box, Transform3::Identity()}, .isBox = true};
}

/// What faces the light of a body, which must be known.
std::vector<Aabb> surfaceOf(const SelfShadowFree& body, const LightImage& image) {
    LitSurface surface;
    EXPECT_TRUE(surface.find(body, image));
    std::vector<Aabb> boxes;
    for (const Aabb& box : surface.boxes.boxes())
        boxes.push_back(box);
    return boxes;
}

/// How far it reaches along a direction.
double reachOf(const std::vector<Aabb>& surface, const Vec3& direction) {
    double reach = -std::numeric_limits<double>::infinity();
    for (const Aabb& box : surface)
        reach =
            std::max(reach, direction.dot(box.centre) + direction.cwiseAbs().dot(box.halfExtents));
    return reach;
}

bool holds(const std::vector<Aabb>& surface, const Vec3& point, double slack) {
    return std::ranges::any_of(surface, [&](const Aabb& box) {
        return ((point - box.centre).cwiseAbs() - box.halfExtents).maxCoeff() <= slack;
    });
}

/// A block of ground of 20 x 2 x 20 with its top at y = 0.
const Aabb Block{Vec3(0.0, -1.0, 0.0), Vec3(10.0, 1.0, 10.0)};

Eigen::AlignedBox3f boundsOf(const Aabb& box) {
    return {(box.centre - box.halfExtents).cast<float>(),
            (box.centre + box.halfExtents).cast<float>()};
}

} // namespace

TEST(LitSurface, OfABlockAtNoonIsItsTop) {
    const std::vector<Aabb> surface = surfaceOf(blockOf(Block), sunFrom(Vec3::UnitY()));
    EXPECT_FALSE(holds(surface, Vec3(0.0, -2.0, 0.0), 0.1));
    EXPECT_FALSE(holds(surface, Vec3(0.0, -1.0, 0.0), 0.1));
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitZ())})
        EXPECT_EQ(reachOf(surface, axis), 10.0);
}

TEST(LitSurface, OfABlockHasTheWallsThatFaceTheSun) {
    const std::vector<Aabb> surface = surfaceOf(blockOf(Block), sunFrom(Vec3(1.0, 1.0, -1.0)));
    EXPECT_EQ(surface.size(), 3U);
    EXPECT_TRUE(holds(surface, Vec3(10.0, -2.0, 10.0), 0.0));
    EXPECT_TRUE(holds(surface, Vec3(-10.0, -2.0, -10.0), 0.0));
    EXPECT_FALSE(holds(surface, Vec3(-10.0, -1.0, 5.0), 0.1));
    EXPECT_FALSE(holds(surface, Vec3(0.0, -2.0, 0.0), 0.1));
}

TEST(LitSurface, OfABlockIsWhatALampBesideItShinesOn) {
    // Below the top, and beside one wall.
    const std::vector<Aabb> surface = surfaceOf(blockOf(Block), lampAt(Vec3(30.0, -5.0, 0.0)));
    EXPECT_TRUE(holds(surface, Vec3(10.0, -1.0, 3.0), 0.0));
    EXPECT_TRUE(holds(surface, Vec3(0.0, -2.0, 0.0), 0.0));
    EXPECT_FALSE(holds(surface, Vec3(0.0, 0.0, 0.0), 0.1));
    // Inside of it, it shines on nothing that is drawn.
    EXPECT_TRUE(surfaceOf(blockOf(Block), lampAt(Block.centre)).empty());
}

TEST(LitSurface, OfAReliefIsItsCellsInsteadOfItsTop) {
    SelfShadowFree body = blockOf(Block);
    body.isBox = false;
    Relief relief{Vec3::UnitY(), 0.2, {}};
    const Aabb cell{Vec3(2.0, -1.5, 3.0), Vec3(1.0, 0.25, 1.0)};
    relief.cells.push_back({boundsOf(cell), decltype(ReliefCell::rise)::Zero()});
    body.relief = &relief;
    const std::vector<Aabb> noon = surfaceOf(body, sunFrom(Vec3::UnitY()));
    EXPECT_TRUE(holds(noon, Vec3(2.0, -1.3, 3.0), 1e-6));
    EXPECT_FALSE(holds(noon, Vec3(-5.0, 0.0, -5.0), 0.1));
    EXPECT_FALSE(holds(noon, Vec3(-5.0, -2.0, -5.0), 0.1));
    const std::vector<Aabb> morning = surfaceOf(body, sunFrom(Vec3(1.0, 1.0, 0.0)));
    EXPECT_TRUE(holds(morning, Vec3(10.0, -2.0, -7.0), 0.0));
    EXPECT_FALSE(holds(morning, Vec3(-10.0, -1.0, -7.0), 0.1));
}

TEST(LitSurface, IsUnknownOfOtherBodies) {
    const LightImage image = sunFrom(Vec3(1.0, 2.0, 3.0));
    LitSurface surface;
    SelfShadowFree body = blockOf(Block);
    body.isBox = false;
    EXPECT_FALSE(surface.find(body, image)) << "convex, no more";
    const Relief steepest{Vec3::UnitY(), 0.2, {}};
    body.relief = &steepest;
    EXPECT_FALSE(surface.find(body, image)) << "no cells";
    body = blockOf(Block);
    body.around.box.halfExtents.y() = 0.0;
    EXPECT_FALSE(surface.find(body, image)) << "a sheet";
    body = blockOf(Block);
    body.around.wsFromBody.linear().col(1).setZero();
    EXPECT_FALSE(surface.find(body, image)) << "flattened";
    body = blockOf(Block);
    body.around.wsFromBody.translation().x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(surface.find(body, image)) << "nowhere";
}

TEST(LitSurface, LeavesLittleByLittleWhereASideTurnsAway) {
    // The sun goes around the block, past all its walls.
    constexpr double Step = 1e-3;
    const std::array<Vec3, 4> outward{Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitZ()};
    std::array<double, 4> before{};
    std::array<double, 4> greatest{};
    std::array<double, 4> least{1.0, 1.0, 1.0, 1.0};
    for (double angle = 0.0; angle < 6.3; angle += Step) {
        const Vec3 towards(std::cos(angle), 0.5, std::sin(angle));
        LitSurface surface;
        ASSERT_TRUE(surface.find(blockOf(Block), sunFrom(towards)));
        for (std::size_t wall = 0; wall < 4; ++wall) {
            const Vec3 middle = Block.centre + 10.0 * outward[wall];
            double left = 0.0;
            for (const Aabb& box : surface.boxes.boxes())
                if (box.centre == middle) left = 1.0;
            for (std::size_t i = 0; i < surface.leavingCount; ++i)
                if (surface.leaving[i].side.centre == middle) left = surface.leaving[i].left;
            if (outward[wall].dot(towards) > 0.0) {
                EXPECT_EQ(left, 1.0);
            }
            if (angle > 0.0) {
                EXPECT_NEAR(left, before[wall], 10.0 * Step);
            }
            before[wall] = left;
            greatest[wall] = std::max(greatest[wall], left);
            least[wall] = std::min(least[wall], left);
        }
    }
    for (std::size_t wall = 0; wall < 4; ++wall) {
        EXPECT_EQ(greatest[wall], 1.0);
        EXPECT_EQ(least[wall], 0.0);
    }
}

RC_GTEST_PROP(LitSurface, HoldsWhateverFacesTheLight, ()) {
    Dice dice(*anySeed());
    SelfShadowFree body = blockOf({dice.cube(), Vec3(dice.in(0.1, 1.0), dice.in(0.1, 1.0), 1.0)});
    // Turned, stretched and sheared.
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        body.around.wsFromBody.linear().col(axis) += 0.3 * dice.cube();
    body.around.wsFromBody.translation() = 5.0 * dice.cube();
    const bool isSun = dice.chance(0.5);
    const Vec3 light = isSun ? dice.direction() : Vec3(4.0 * dice.cube());
    const std::vector<Aabb> surface = surfaceOf(body, isSun ? sunFrom(light) : lampAt(light));
    const Transform3& wsFromBody = body.around.wsFromBody;
    const Mat3 normals = wsFromBody.linear().inverse().transpose();
    for (int i = 0; i < 100; ++i) {
        Vec3 at = dice.cube();
        const auto axis = static_cast<Eigen::Index>(dice.below(3));
        at[axis] = dice.chance(0.5) ? 1.0 : -1.0;
        const Vec3 ws =
            wsFromBody * (body.around.box.centre + at.cwiseProduct(body.around.box.halfExtents));
        const Vec3 normal = normals * (at[axis] * Vec3::Unit(axis));
        if (normal.dot(isSun ? light : Vec3(light - ws)) > 0.0)
            RC_ASSERT(holds(surface, ws, 1e-12));
    }
}
