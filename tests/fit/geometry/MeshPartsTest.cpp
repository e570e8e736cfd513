// Parts of a mesh: bounds of its triangles by where they are.
#include "fit/geometry/MeshParts.h"

#include "fit/Problems.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

using Triangle = std::array<Vec3, 3>;
using Parts = std::vector<Eigen::AlignedBox3f>;

Parts partsOf(const std::vector<Triangle>& triangles, std::size_t most) {
    Eigen::AlignedBox3d bounds;
    for (const Triangle& triangle : triangles)
        for (const Vec3& corner : triangle)
            if (corner.allFinite()) bounds.extend(corner);
    MeshPartsBuilder builder(most);
    builder.reset(bounds);
    for (const auto& [a, b, c] : triangles)
        builder.add(a, b, c);
    return builder.parts();
}

/// A square of 2 x 2 with so many quads to a side, in a plane.
std::vector<Triangle> square(int quads) {
    std::vector<Triangle> triangles;
    const auto at = [quads](int x, int y) {
        return Vec3(2.0 * x / quads - 1.0, 0.0, 2.0 * y / quads - 1.0);
    };
    for (int y = 0; y < quads; ++y)
        for (int x = 0; x < quads; ++x) {
            triangles.push_back({at(x, y), at(x, y + 1), at(x + 1, y)});
            triangles.push_back({at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)});
        }
    return triangles;
}

std::vector<Triangle> randomTriangles(Dice& dice, std::size_t count) {
    const double size = std::pow(10.0, dice.in(-3.0, 0.0));
    std::vector<Triangle> triangles(count);
    for (Triangle& triangle : triangles) {
        const Vec3 middle = dice.cube();
        for (Vec3& corner : triangle)
            corner = (middle + size * dice.cube()).cast<float>().cast<double>();
    }
    return triangles;
}

} // namespace

RC_GTEST_PROP(MeshParts, HoldEachTriangleAsAWhole, ()) {
    Dice dice(*anySeed());
    const std::vector<Triangle> triangles = randomTriangles(dice, 1 + dice.below(500));
    const std::size_t most = 8 + dice.below(100);
    const Parts parts = partsOf(triangles, most);
    RC_ASSERT(!parts.empty());
    RC_ASSERT(parts.size() <= most);
    for (const Triangle& triangle : triangles)
        RC_ASSERT(std::ranges::any_of(parts, [&](const Eigen::AlignedBox3f& part) {
            return std::ranges::all_of(
                triangle, [&](const Vec3& corner) { return part.contains(corner.cast<float>()); });
        }));
    // And are no larger than what is in them: each side of each is a corner's.
    for (const Eigen::AlignedBox3f& part : parts)
        for (int axis = 0; axis < 3; ++axis)
            for (const float side : {part.min()[axis], part.max()[axis]})
                RC_ASSERT(std::ranges::any_of(triangles, [&](const Triangle& triangle) {
                    return std::ranges::any_of(triangle, [&](const Vec3& corner) {
                        return static_cast<float>(corner[axis]) == side;
                    });
                }));
}

RC_GTEST_PROP(MeshParts, DoNotDependOnTheOrderNorTheScale, ()) {
    Dice dice(*anySeed());
    std::vector<Triangle> triangles = randomTriangles(dice, 1 + dice.below(300));
    const std::size_t most = 8 + dice.below(100);
    const Parts parts = partsOf(triangles, most);
    for (std::size_t i = triangles.size(); i > 1; --i)
        std::swap(triangles[i - 1], triangles[dice.below(i)]);
    for (Triangle& triangle : triangles)
        for (Vec3& corner : triangle)
            corner *= 1024.0;
    const Parts others = partsOf(triangles, most);
    RC_ASSERT(others.size() == parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        RC_ASSERT((others[i].min() / 1024.0F) == parts[i].min());
        RC_ASSERT((others[i].max() / 1024.0F) == parts[i].max());
    }
}

TEST(MeshParts, OfASquareAreAtLeastAQuarterOfTheMost) {
    for (const int quads : {64, 100, 200})
        for (const std::size_t most : {64, 100, 256, 1000}) {
            const Parts parts = partsOf(square(quads), most);
            EXPECT_LE(parts.size(), most);
            EXPECT_GE(parts.size(), most / 4) << quads << " quads, " << most << " parts";
            // Together about as large as the square.
            double area = 0.0;
            for (const Eigen::AlignedBox3f& part : parts)
                area += static_cast<double>(part.sizes().x() * part.sizes().z());
            EXPECT_LT(area, 4.0 * 2.0);
            EXPECT_GE(area, 4.0 * (1.0 - 1e-5));
        }
}

TEST(MeshParts, OfFewTrianglesAreThese) {
    EXPECT_TRUE(partsOf({}, 64).empty());
    const Triangle one{Vec3(1.0, 2.0, 3.0), Vec3(2.0, 2.0, 3.0), Vec3(1.0, 4.0, 5.0)};
    const Parts parts = partsOf({one}, 64);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].min(), Eigen::Vector3f(1.0F, 2.0F, 3.0F));
    EXPECT_EQ(parts[0].max(), Eigen::Vector3f(2.0F, 4.0F, 5.0F));
    EXPECT_EQ(partsOf(square(2), 64).size(), 8U);
    // All at one point.
    const Vec3 point(1.0, 1.0, 1.0);
    EXPECT_EQ(partsOf({{point, point, point}, {point, point, point}}, 64).size(), 1U);
}

TEST(MeshParts, LeaveOutWhatIsNotFinite) {
    constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
    constexpr double Infinity = std::numeric_limits<double>::infinity();
    const Triangle good{Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)};
    Triangle bad = good;
    for (const double value : {NaN, Infinity, -Infinity}) {
        bad[1].y() = value;
        const Parts parts = partsOf({good, bad}, 64);
        ASSERT_EQ(parts.size(), 1U);
        EXPECT_EQ(parts[0].max(), Eigen::Vector3f(1.0F, 1.0F, 0.0F));
    }
}
