#include "fit/geometry/BoxQuery.h"

#include "fit/Problems.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

BoxSet anyBoxes(Dice& dice) {
    BoxSet boxes;
    const std::size_t count = dice.below(40);
    for (std::size_t i = 0; i < count; ++i) {
        Vec3 half = 0.5 * dice.cube().cwiseAbs();
        if (dice.chance(0.2)) half.setZero();
        boxes.add({dice.cube(), half});
    }
    return boxes;
}

std::vector<HalfSpace> anyPlanes(Dice& dice) {
    std::vector<HalfSpace> planes(dice.below(20));
    for (HalfSpace& plane : planes)
        plane = {std::pow(10.0, dice.in(-3.0, 3.0)) * dice.direction(), 0.0};
    for (HalfSpace& plane : planes)
        plane.offset = plane.normal.norm() * dice.in(-0.3, 1.0);
    return planes;
}

/// The values of the plane's distance over the box: least and greatest.
Vec2 over(const HalfSpace& plane, const Aabb& box) {
    const double reach = plane.normal.cwiseAbs().dot(box.halfExtents);
    return Vec2(-reach, reach).array() + plane.distance(box.centre);
}

} // namespace

RC_GTEST_PROP(LargestBoxes, AreTheFirstInOrderOfSize, ()) {
    Dice dice(*anySeed());
    BoxSet boxes = anyBoxes(dice);
    if (boxes.size() > 0 && dice.chance(0.5)) boxes.add(boxes.box(0)); // two of one size
    std::vector<std::size_t> expected(boxes.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        expected[i] = i;
    std::ranges::stable_sort(expected, std::greater(),
                             [&](std::size_t i) { return boxes.box(i).halfExtents.sum(); });
    std::array<std::size_t, 6> room{};
    const std::size_t wanted = 1 + dice.below(room.size());
    const std::size_t count = largestBoxes(boxes, std::span(room).first(wanted));
    RC_ASSERT(count == std::min(wanted, expected.size()));
    for (std::size_t i = 0; i < count; ++i)
        RC_ASSERT(room[i] == expected[i]);
    RC_ASSERT(largestBox(boxes) == (expected.empty() ? 0 : expected[0]));
}

RC_GTEST_PROP(FarBoxes, AreTheFarthestOfFew, ()) {
    Dice dice(*anySeed());
    const BoxSet boxes = anyBoxes(dice);
    const std::array<Vec3, 2> directions = {dice.direction(), dice.direction()};
    std::array<std::size_t, 2> farthest{};
    farBoxes(boxes, directions, farthest);
    for (std::size_t i = 0; i < directions.size(); ++i)
        for (const Aabb& box : boxes.boxes())
            RC_ASSERT(directions[i].dot(boxes.box(farthest[i]).centre) >=
                      directions[i].dot(box.centre) - 1e-12);
}

TEST(FarBoxes, AreSomeOfMany) {
    BoxSet boxes;
    for (int i = 0; i < 5000; ++i)
        boxes.add({Vec3(0.1 * i, 0.0, 0.0), Vec3::Ones()});
    const std::array<Vec3, 2> directions = {Vec3::UnitX(), -Vec3::UnitX()};
    std::array<std::size_t, 2> farthest{};
    farBoxes(boxes, directions, farthest);
    EXPECT_GT(farthest[0], 4900U);
    EXPECT_EQ(farthest[1], 0U);
}

RC_GTEST_PROP(KeepReaching, DropsWhatAPlaneSeparates, ()) {
    Dice dice(*anySeed());
    const BoxSet boxes = anyBoxes(dice);
    const std::vector<HalfSpace> planes = anyPlanes(dice);
    BoxSet scratch;
    BoxSet kept;
    kept.addUnbounded();
    keepReaching(boxes, planes, scratch, kept);
    RC_ASSERT(kept.unbounded() == 0U);
    std::size_t next = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Aabb box = boxes.box(i);
        const bool reaches = std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
            return over(plane, box).y() >= 0.0;
        });
        if (!reaches) continue;
        RC_ASSERT(next < kept.size());
        RC_ASSERT(kept.origin(next) == i);
        RC_ASSERT(kept.box(next).centre == box.centre);
        RC_ASSERT(kept.box(next).halfExtents == box.halfExtents);
        ++next;
    }
    RC_ASSERT(next == kept.size());
}

TEST(KeepReaching, KeepsWhatTouchesButForRounding) {
    BoxSet boxes;
    boxes.add({Vec3(1000.0 * (1.0 - 1e-15), 0.0, 0.0), Vec3::Zero()});
    boxes.add({Vec3(1000.0 * (1.0 - 1e-9), 0.0, 0.0), Vec3::Zero()});
    BoxSet scratch;
    BoxSet kept;
    const HalfSpace plane{Vec3::UnitX(), -1000.0};
    keepReaching(boxes, {&plane, 1}, scratch, kept);
    EXPECT_EQ(kept.size(), 1U);
    // Exactly on a plane through the origin, where all terms vanish.
    boxes.clear();
    boxes.add({Vec3::Zero(), Vec3::Zero()});
    for (const Vec3& normal : {Vec3(1, 1, 1), Vec3(-1, -1, -1), Vec3(1, -1, 0)})
        for (const double offset : {0.0, -0.0}) {
            const HalfSpace through{normal, offset};
            keepReaching(boxes, {&through, 1}, scratch, kept);
            EXPECT_EQ(kept.size(), 1U) << normal.transpose();
        }
}

RC_GTEST_PROP(LanesInside, AreTheBoxesOnTheInnerSideOfAllPlanes, ()) {
    Dice dice(*anySeed());
    const BoxSet boxes = anyBoxes(dice);
    const std::vector<HalfSpace> planes = anyPlanes(dice);
    std::size_t index = 0;
    for (const Aabb& box : boxes.boxes()) {
        const unsigned lanes = lanesInside(boxes.blocks()[index / BoxSet::BlockSize], planes);
        const bool inside = std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
            return over(plane, box).x() >= 0.0;
        });
        RC_ASSERT(((lanes >> index % BoxSet::BlockSize) & 1U) == (inside ? 1U : 0U));
        ++index;
    }
}

TEST(LanesInside, OfNoPlanesAreAllAndOfAnEmptyHalfSpaceNone) {
    BoxSet boxes;
    boxes.add({Vec3::Zero(), Vec3::Ones()});
    EXPECT_EQ(lanesInside(boxes.blocks()[0], {}), 0xffU);
    const HalfSpace nothing{Vec3::UnitX(), -Infinity};
    EXPECT_EQ(lanesInside(boxes.blocks()[0], {&nothing, 1}), 0U);
}

TEST(LargestBox, IsTheOneWithTheGreatestSumOfSides) {
    BoxSet boxes;
    EXPECT_EQ(largestBox(boxes), 0U);
    for (int i = 0; i < 11; ++i)
        boxes.add({Vec3::Zero(), Vec3(i == 9 ? 5.0 : 1.0, i == 3 ? 4.0 : 1.0, 1.0)});
    EXPECT_EQ(largestBox(boxes), 9U);
}
