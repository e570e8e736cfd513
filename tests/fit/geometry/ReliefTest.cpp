#include "fit/geometry/Relief.h"

#include "fit/Problems.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

using namespace Lixel;

namespace {

using Triangle = std::array<Vec3, 3>;

/// Rounded to float, as positions of meshes are.
Vec3 rounded(const Vec3& point) {
    return point.cast<float>().cast<double>();
}

/// Triangles, and rays that meet them.
struct GroundMesh {
    std::vector<Triangle> triangles;

    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        triangles.push_back({rounded(a), rounded(b), rounded(c)});
    }
    void addQuad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        add(a, b, c);
        add(a, c, d);
    }

    std::optional<Relief> relief() const {
        Eigen::AlignedBox3d bounds;
        for (const Triangle& triangle : triangles)
            for (const Vec3& point : triangle)
                bounds.extend(point);
        ReliefBuilder builder;
        builder.reset(bounds);
        for (const auto& [a, b, c] : triangles)
            builder.add(a, b, c);
        return builder.relief();
    }

    Vec3 normal(std::size_t index) const {
        const auto& [a, b, c] = triangles[index];
        return Vec3(b - a).cross(Vec3(c - a)).normalized();
    }

    /// Whether a ray from a point of one triangle meets another that has no vertex in common.
    /// @param end the greatest multiple of the direction
    bool isShadowed(std::size_t index, const Vec3& point, const Vec3& direction,
                    double end = std::numeric_limits<double>::infinity()) const {
        const Triangle& own = triangles[index];
        for (const Triangle& triangle : triangles) {
            bool touches = false;
            for (const Vec3& vertex : triangle)
                touches = touches || vertex == own[0] || vertex == own[1] || vertex == own[2];
            if (touches) continue;
            Mat3 columns;
            columns << -direction, triangle[1] - triangle[0], triangle[2] - triangle[0];
            const Vec3 at = columns.inverse() * (point - triangle[0]);
            if (at.x() > 0.0 && at.x() < end && at.y() >= 0.0 && at.z() >= 0.0 &&
                at.y() + at.z() <= 1.0)
                return true;
        }
        return false;
    }
};

using Height = std::function<double(double x, double z)>;

/// A sheet of squares over [-1, 1] x [-1, 1], the y axis up.
GroundMesh sheetOf(const Height& height, int squares = 10) {
    GroundMesh sheet;
    const auto at = [&](int x, int z) {
        const double px = 2.0 * x / squares - 1.0;
        const double pz = 2.0 * z / squares - 1.0;
        return Vec3(px, height(px, pz), pz);
    };
    for (int z = 0; z < squares; ++z)
        for (int x = 0; x < squares; ++x)
            sheet.addQuad(at(x, z), at(x, z + 1), at(x + 1, z + 1), at(x + 1, z));
    return sheet;
}

/// The same as a block with walls down to y, and an underside.
GroundMesh blockOf(const Height& height, double underside, int squares = 10) {
    GroundMesh block = sheetOf(height, squares);
    const auto wall = [&](double x0, double z0, double x1, double z1) {
        for (int i = 0; i < squares; ++i) {
            const double s = static_cast<double>(i) / squares;
            const double t = static_cast<double>(i + 1) / squares;
            const auto at = [&](double share) {
                // As the sheet's own points are made.
                const double px =
                    2.0 * std::round((x0 + share * (x1 - x0) + 1.0) / 2.0 * squares) / squares -
                    1.0;
                const double pz =
                    2.0 * std::round((z0 + share * (z1 - z0) + 1.0) / 2.0 * squares) / squares -
                    1.0;
                return Vec3(px, height(px, pz), pz);
            };
            const auto below = [&](const Vec3& p) { return Vec3(p.x(), underside, p.z()); };
            block.addQuad(at(s), below(at(s)), below(at(t)), at(t));
            block.add(below(at(s)), Vec3(0.0, underside, 0.0), below(at(t)));
        }
    };
    wall(-1, 1, 1, 1);
    wall(1, 1, 1, -1);
    wall(1, -1, -1, -1);
    wall(-1, -1, -1, 1);
    return block;
}

double hills(double x, double z) {
    return 0.1 * std::sin(4.0 * x + 1.0) * std::cos(3.0 * z);
}

} // namespace

TEST(Relief, IsASheetOfHills) {
    const GroundMesh sheet = sheetOf(hills);
    const auto relief = sheet.relief();
    ASSERT_TRUE(relief);
    EXPECT_EQ(relief->axis, Vec3::UnitY());
    double leastCosine = 1.0;
    for (std::size_t i = 0; i < sheet.triangles.size(); ++i)
        leastCosine = std::min(leastCosine, sheet.normal(i).y());
    EXPECT_NEAR(relief->steepness, std::sqrt(1.0 - leastCosine * leastCosine), 1e-12);
    EXPECT_TRUE(relief->isBelow(Vec3(0.1, 3.0, 0.2)));
    EXPECT_FALSE(relief->isBelow(Vec3(1.0, 0.0, 0.2)));
    EXPECT_FALSE(relief->isBelow(Vec3(0.0, -1.0, 0.0)));
    EXPECT_FALSE(relief->isBelow(Vec3(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0)));
}

TEST(Relief, IsABlockOfHills) {
    const auto relief = blockOf(hills, -0.5).relief();
    ASSERT_TRUE(relief);
    EXPECT_EQ(relief->axis, Vec3::UnitY());
    EXPECT_NEAR(relief->steepness, sheetOf(hills).relief()->steepness, 1e-12);
}

TEST(Relief, HasAPlateauAtItsLowest) {
    const auto basin = [](double x, double z) { return std::max(0.3 * (x + z), 0.0); };
    EXPECT_TRUE(sheetOf(basin).relief());
}

TEST(Relief, LiesAlongAnyAxis) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            Mat3 turn;
            turn.col(1) = sign * Vec3::Unit(axis);
            turn.col(0) = Vec3::Unit((axis + 1) % 3);
            turn.col(2) = turn.col(0).cross(turn.col(1));
            GroundMesh turned = blockOf(hills, -0.5);
            for (Triangle& triangle : turned.triangles)
                for (Vec3& point : triangle)
                    point = turn * point;
            const auto relief = turned.relief();
            ASSERT_TRUE(relief);
            EXPECT_EQ(relief->axis, Vec3(sign * Vec3::Unit(axis)));
        }
}

TEST(Relief, IsNothingSteep) {
    EXPECT_FALSE(sheetOf([](double x, double) { return 4.0 * std::abs(x); }).relief());
    EXPECT_TRUE(sheetOf([](double x, double) { return 3.0 * std::abs(x); }).relief());
}

TEST(Relief, IsNotSeenFromBelow) {
    GroundMesh sheet = sheetOf(hills);
    for (auto& [a, b, c] : sheet.triangles)
        std::swap(b, c);
    const auto relief = sheet.relief();
    ASSERT_TRUE(relief);
    EXPECT_EQ(relief->axis, Vec3(-Vec3::UnitY()));
}

TEST(Relief, HasNothingAboveIt) {
    // A second sheet, a tile that was lifted out of it, and a box that stands on it.
    GroundMesh two = sheetOf(hills);
    const GroundMesh above = sheetOf([](double x, double z) { return 0.5 + hills(x, z); });
    two.triangles.insert(two.triangles.end(), above.triangles.begin(), above.triangles.end());
    EXPECT_FALSE(two.relief());

    GroundMesh lifted = sheetOf(hills);
    for (std::size_t i = 90; i < 92; ++i)
        for (Vec3& point : lifted.triangles[i])
            point = rounded(point + Vec3(0.0, 0.4, 0.0));
    EXPECT_FALSE(lifted.relief());

    GroundMesh crowned = sheetOf(hills);
    crowned.addQuad({0, 0, 0}, {0, 1, 0}, {0, 1, 0.1}, {0, 0, 0.1});
    EXPECT_FALSE(crowned.relief());
}

TEST(Relief, HasNoHoles) {
    GroundMesh holed = sheetOf(hills);
    holed.triangles.erase(holed.triangles.begin() + 90);
    EXPECT_FALSE(holed.relief());
    GroundMesh cracked = sheetOf(hills);
    cracked.triangles[90][0].y() += 0.01;
    EXPECT_FALSE(cracked.relief());
}

TEST(Relief, HasNoWallsAboveItsBorder) {
    // A tray: its walls are in the sides of its box, face outward, and are higher than its ground.
    GroundMesh tray = sheetOf([](double, double) { return 0.0; });
    tray.addQuad({1, 0, -1}, {1, 0.5, -1}, {1, 0.5, 1}, {1, 0, 1});
    tray.addQuad({-1, 0, 1}, {-1, 0.5, 1}, {-1, 0.5, -1}, {-1, 0, -1});
    EXPECT_GT(tray.normal(tray.triangles.size() - 3).x(), 0.9);
    EXPECT_LT(tray.normal(tray.triangles.size() - 1).x(), -0.9);
    EXPECT_FALSE(tray.relief());
    // A block whose wall on one side goes on upwards, and one where the walls face inward.
    GroundMesh walled = blockOf(hills, -0.5);
    walled.addQuad({1, hills(1, -1), -1}, {1, 0.5, -1}, {1, 0.5, 1}, {1, hills(1, 1), 1});
    EXPECT_GT(walled.normal(walled.triangles.size() - 1).x(), 0.9);
    EXPECT_FALSE(walled.relief());
    GroundMesh inward = sheetOf([](double, double) { return 0.0; });
    inward.addQuad({1, 0, 1}, {1, 0.5, 1}, {1, 0.5, -1}, {1, 0, -1});
    EXPECT_FALSE(inward.relief());
}

TEST(Relief, IsNoWindingStair) {
    // All of it faces up, and it lies over itself.
    GroundMesh stair;
    constexpr int Steps = 60;
    const auto at = [](int step, double radius) {
        const double angle = 0.2 * step;
        return Vec3(radius * std::cos(angle), 0.02 * step, -radius * std::sin(angle));
    };
    for (int i = 0; i < Steps; ++i)
        stair.addQuad(at(i, 0.2), at(i, 1.0), at(i + 1, 1.0), at(i + 1, 0.2));
    EXPECT_GT(stair.normal(5).y(), 0.5);
    EXPECT_FALSE(stair.relief());
}

TEST(Relief, IsNothingWithoutExtent) {
    EXPECT_FALSE(GroundMesh().relief());
    EXPECT_FALSE(sheetOf([](double, double) { return 0.0; }).relief()); // flat: known as such
    GroundMesh broken = sheetOf(hills);
    broken.triangles[3][1].x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(broken.relief());
}

namespace {

/// Hills without order, as a sheet or as a block.
GroundMesh anyHills(std::uint32_t seed, std::mt19937& engine, double most) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    std::array<double, 4> waves;
    for (double& wave : waves)
        wave = between(-5.0, 5.0);
    const double size = between(0.02, most);
    const auto height = [&](double x, double z) {
        return size * std::sin(waves[0] * x + waves[1] * z) + size * std::cos(waves[2] * x * z) +
               0.1 * waves[3] * x;
    };
    return seed % 2 == 0 ? sheetOf(height, 6) : blockOf(height, -4.0, 6);
}

/// A point within a triangle, away from its border.
Vec3 pointWithin(const Triangle& triangle, std::mt19937& engine) {
    const double s = std::uniform_real_distribution<double>(0.1, 0.6)(engine);
    const double t = std::uniform_real_distribution<double>(0.1, 0.9 - s)(engine);
    return triangle[0] + s * (triangle[1] - triangle[0]) + t * (triangle[2] - triangle[0]);
}

bool meets(const Eigen::AlignedBox3f& box, const Vec3& from, const Vec3& direction) {
    double begin = 0.0;
    double end = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double first = (static_cast<double>(box.min()[axis]) - from[axis]) / direction[axis];
        const double last = (static_cast<double>(box.max()[axis]) - from[axis]) / direction[axis];
        begin = std::max(begin, std::min(first, last));
        end = std::min(end, std::max(first, last));
    }
    return begin <= end + 1e-9;
}

} // namespace

/// What it is for: where it says so, no light ray meets it again.
RC_GTEST_PROP(Relief, ShadowsNothingOfItselfUnderLightsAboveItsSlopes, (std::uint32_t seed)) {
    std::mt19937 engine(seed);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    const GroundMesh surface = anyHills(seed, engine, 0.25);
    const auto relief = surface.relief();
    RC_PRE(relief.has_value());
    int lit = 0;
    for (int i = 0; i < 50; ++i) {
        const Vec3 direction(between(-1, 1), between(0, 1), between(-1, 1));
        if (!relief->isBelow(direction)) continue;
        ++lit;
        for (std::size_t k = 0; k < surface.triangles.size(); ++k) {
            if (!(surface.normal(k).dot(direction) > 1e-6 * direction.norm())) continue;
            RC_ASSERT(!surface.isShadowed(k, pointWithin(surface.triangles[k], engine), direction));
        }
    }
    RC_CLASSIFY(lit > 0, "with lights");
}

/// And where it does not, cells that may face away are between the light and what is shadowed.
RC_GTEST_PROP(Relief, ShadowsItselfWithCellsThatFaceAwayAlone, (std::uint32_t seed)) {
    std::mt19937 engine(seed);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    const GroundMesh surface = anyHills(seed, engine, 0.4);
    const auto relief = surface.relief();
    RC_PRE(relief.has_value());
    int shadowed = 0;
    int spared = 0;
    for (int i = 0; i < 50; ++i) {
        const bool isLamp = i % 2 == 0;
        Vec4 light(between(-1, 1), between(-0.2, 1), between(-1, 1), isLamp ? 1.0 : 0.0);
        if (isLamp) light.head<3>() *= 3.0;
        std::vector<Eigen::AlignedBox3f> away;
        for (const ReliefCell& cell : relief->cells)
            if (!relief->isLit(cell, light)) away.push_back(cell.bounds);
        if (away.size() < relief->cells.size()) ++spared;
        for (std::size_t k = 0; k < surface.triangles.size(); ++k) {
            const Vec3 point = pointWithin(surface.triangles[k], engine);
            const Vec3 direction = light.head<3>() - light.w() * point;
            if (!(surface.normal(k).dot(direction) > 1e-6 * direction.norm())) continue;
            const double end = isLamp ? 1.0 : std::numeric_limits<double>::infinity();
            if (!surface.isShadowed(k, point, direction, end)) continue;
            ++shadowed;
            RC_ASSERT(std::ranges::any_of(
                away, [&](const auto& box) { return meets(box, point, direction); }));
        }
    }
    RC_CLASSIFY(shadowed > 0, "with shadows");
    RC_CLASSIFY(spared > 0, "with lit cells");
}

TEST(Relief, HasSlopesThatFaceAwayWhereTheyAre) {
    // One hill in a corner of a plain.
    const auto relief =
        sheetOf(
            [](double x, double z) {
                return 0.3 * std::exp(-20.0 * ((x + 0.6) * (x + 0.6) + (z + 0.6) * (z + 0.6)));
            },
            40)
            .relief();
    ASSERT_TRUE(relief);
    const auto facingAway = [&](const Vec4& light) {
        Eigen::AlignedBox3f bounds;
        std::size_t count = 0;
        for (const ReliefCell& cell : relief->cells)
            if (!relief->isLit(cell, light)) {
                bounds.extend(cell.bounds);
                ++count;
            }
        EXPECT_LE(count, 9U);
        return bounds;
    };
    EXPECT_EQ(relief->cells.size(), 64U);
    // From the east: what faces west.
    const Eigen::AlignedBox3f west = facingAway(Vec4(1.0, 0.2, 0.0, 0.0));
    EXPECT_FALSE(west.isEmpty());
    EXPECT_LT(west.max().x(), -0.4);
    const Eigen::AlignedBox3f east = facingAway(Vec4(-3.0, 0.5, -0.6, 1.0));
    EXPECT_FALSE(east.isEmpty());
    EXPECT_GT(east.min().x(), -0.8);
    EXPECT_TRUE(facingAway(Vec4(0.1, 1.0, 0.2, 0.0)).isEmpty());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(relief->isLit(relief->cells.front(), Vec4(0.0, nan, 0.0, 0.0)));
}
