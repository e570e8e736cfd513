#include "fit/geometry/ConvexSurface.h"

#include "fit/Problems.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

struct Surface {
    std::vector<Vec3> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    bool isConvex() const { return isConvexSurface(positions, triangles); }

    void addQuad(const std::array<Vec3, 4>& corners) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        positions.insert(positions.end(), corners.begin(), corners.end());
        triangles.push_back({first, first + 1, first + 2});
        triangles.push_back({first, first + 2, first + 3});
    }
    /// Each face has corners of its own.
    void addBox(const Vec3& lower, const Vec3& upper) {
        const auto corner = [&](int i) {
            return Vec3((i & 1) != 0 ? upper.x() : lower.x(), (i & 2) != 0 ? upper.y() : lower.y(),
                        (i & 4) != 0 ? upper.z() : lower.z());
        };
        for (const auto& [a, b, c, d] : {std::array{0, 2, 3, 1},
                                         {4, 5, 7, 6},
                                         {0, 1, 5, 4},
                                         {2, 6, 7, 3},
                                         {0, 4, 6, 2},
                                         {1, 3, 7, 5}})
            addQuad({corner(a), corner(b), corner(c), corner(d)});
    }
};

Surface cube() {
    Surface surface;
    surface.addBox(Vec3::Zero(), Vec3::Ones());
    return surface;
}

/// As OGRE makes its own: a seam of two columns of vertices, and rings of them at the poles, where
/// sines in float are not quite 0.
Surface sphere(int rings, int segments) {
    constexpr auto Pi = std::numbers::pi_v<float>;
    Surface surface;
    for (int ring = 0; ring <= rings; ++ring) {
        const float polar = static_cast<float>(ring) * Pi / static_cast<float>(rings);
        for (int segment = 0; segment <= segments; ++segment) {
            const float around =
                static_cast<float>(segment) * 2.0F * Pi / static_cast<float>(segments);
            surface.positions.push_back({static_cast<double>(std::sin(polar) * std::sin(around)),
                                         static_cast<double>(std::cos(polar)),
                                         static_cast<double>(std::sin(polar) * std::cos(around))});
        }
    }
    const auto at = [&](int ring, int segment) {
        return static_cast<std::uint32_t>(ring * (segments + 1) + segment);
    };
    for (int ring = 0; ring < rings; ++ring)
        for (int segment = 0; segment < segments; ++segment) {
            surface.triangles.push_back(
                {at(ring, segment), at(ring + 1, segment), at(ring + 1, segment + 1)});
            surface.triangles.push_back(
                {at(ring, segment), at(ring + 1, segment + 1), at(ring, segment + 1)});
        }
    return surface;
}

} // namespace

TEST(ConvexSurface, IsACube) {
    EXPECT_TRUE(cube().isConvex());
}

TEST(ConvexSurface, IsASphereOfFloats) {
    EXPECT_TRUE(sphere(16, 16).isConvex());
    EXPECT_TRUE(sphere(24, 48).isConvex());
}

TEST(ConvexSurface, IsNotInsideOut) {
    Surface room = cube();
    for (auto& triangle : room.triangles)
        std::swap(triangle[0], triangle[1]);
    EXPECT_FALSE(room.isConvex());
}

TEST(ConvexSurface, IsNotOpen) {
    Surface box = cube();
    box.triangles.pop_back();
    EXPECT_FALSE(box.isConvex());
}

TEST(ConvexSurface, HasEachTriangleOnce) {
    Surface twice = cube();
    twice.triangles.push_back(twice.triangles[0]);
    EXPECT_FALSE(twice.isConvex());
}

TEST(ConvexSurface, IsNotTwoCubes) {
    Surface two = cube();
    two.addBox(Vec3(3.0, 0.0, 0.0), Vec3(4.0, 1.0, 1.0));
    EXPECT_FALSE(two.isConvex());
    // One in the other, either way out.
    Surface nested = cube();
    nested.addBox(Vec3::Constant(0.25), Vec3::Constant(0.75));
    EXPECT_FALSE(nested.isConvex());
}

TEST(ConvexSurface, IsNotAU) {
    // Three cubes, without the walls between them.
    Surface u;
    u.addBox(Vec3(0.0, 0.0, 0.0), Vec3(3.0, 1.0, 1.0));
    u.addBox(Vec3(0.0, 1.0, 0.0), Vec3(1.0, 2.0, 1.0));
    u.addBox(Vec3(2.0, 1.0, 0.0), Vec3(3.0, 2.0, 1.0));
    EXPECT_FALSE(u.isConvex());
}

TEST(ConvexSurface, HasNoDent) {
    Surface dented = sphere(16, 16);
    ASSERT_TRUE(dented.isConvex());
    dented.positions[5 * 17 + 4] *= 0.95;
    EXPECT_FALSE(dented.isConvex());
}

TEST(ConvexSurface, IsNotFlat) {
    Surface sheet;
    sheet.addQuad({Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 0, 0)});
    EXPECT_FALSE(sheet.isConvex());
    EXPECT_FALSE(Surface().isConvex());
}

TEST(ConvexSurface, IsNoneOfBadNumbers) {
    Surface beyond = cube();
    beyond.triangles[0][0] = 99;
    EXPECT_FALSE(beyond.isConvex());
    Surface nothing = cube();
    nothing.positions[0].x() = NAN;
    EXPECT_FALSE(nothing.isConvex());
}

/// Moved, turned and scaled without a mirror, with triangles in any order.
RC_GTEST_PROP(ConvexSurface, IsSoWhereverItIs, ()) {
    Dice dice(*anySeed());
    Surface surface = dice.chance(0.5) ? cube() : sphere(6, 7);
    const Mat3 turn = Eigen::AngleAxisd(dice.in(-3.0, 3.0), dice.direction()).toRotationMatrix();
    const double scale = std::pow(10.0, dice.in(-3.0, 3.0));
    const Vec3 offset = scale * dice.cube();
    for (Vec3& position : surface.positions)
        position = (scale * (turn * position) + offset).cast<float>().cast<double>();
    for (std::size_t i = surface.triangles.size(); i-- > 1;)
        std::swap(surface.triangles[i], surface.triangles[dice.below(i + 1)]);
    RC_ASSERT(surface.isConvex());
    const std::size_t gone = dice.below(surface.triangles.size());
    const auto& [a, b, c] = surface.triangles[gone];
    const double area = Vec3(surface.positions[b] - surface.positions[a])
                            .cross(Vec3(surface.positions[c] - surface.positions[a]))
                            .norm();
    if (area < 1e-3 * scale * scale) return; // at a pole
    surface.triangles.erase(surface.triangles.begin() + static_cast<std::ptrdiff_t>(gone));
    RC_ASSERT(!surface.isConvex());
}
