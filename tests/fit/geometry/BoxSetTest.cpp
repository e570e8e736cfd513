#include "fit/geometry/BoxSet.h"

#include "fit/Constants.h"

#include <gtest/gtest.h>

using namespace Lixel;
using namespace Lixel::Test;

TEST(BoxSet, CountsBadBoxesInsteadOfStoringThem) {
    BoxSet set;
    EXPECT_TRUE(set.empty());
    set.add({Vec3(1.0, 2.0, 3.0), Vec3(1.0, 0.0, 1.0)});
    set.add({Vec3(NaN, 0.0, 0.0), Vec3::Ones()});
    set.add({Vec3::Zero(), Vec3(1.0, NaN, 1.0)});
    set.add({Vec3::Zero(), Vec3(1.0, -1.0, 1.0)});
    set.add({Vec3::Zero(), Vec3(Infinity, 1.0, 1.0)});
    set.add({Vec3(0.0, -Infinity, 0.0), Vec3::Ones()});
    set.addUnbounded();
    EXPECT_EQ(set.size(), 1U);
    EXPECT_EQ(set.invalid(), 3U);
    EXPECT_EQ(set.unbounded(), 3U);
    EXPECT_FALSE(set.empty());
    set.clear();
    EXPECT_TRUE(set.empty());
    EXPECT_EQ(set.invalid(), 0U);
}

TEST(BoxSet, GivesBackItsBoxesInOrder) {
    // Two full blocks and a part of a third; again after what it held before.
    BoxSet set;
    for (const std::size_t count : {2 * BoxSet::BlockSize + 3, BoxSet::BlockSize + 1}) {
        set.clear();
        std::vector<Aabb> boxes;
        for (std::size_t i = 0; i < count; ++i) {
            const auto x = static_cast<double>(i);
            boxes.push_back({Vec3(x, 2.0 * x, -x), Vec3(x, 1.0, 3.0)});
            set.add(boxes.back());
        }
        ASSERT_EQ(set.size(), count);
        std::size_t i = 0;
        for (const Aabb& box : set.boxes()) {
            EXPECT_EQ(box.centre, boxes[i].centre);
            EXPECT_EQ(set.box(i).halfExtents, boxes[i].halfExtents);
            ++i;
        }
        EXPECT_EQ(i, count);
        // What is not a box is zero, in each lane of the last block.
        ASSERT_EQ(set.blocks().size(), count / BoxSet::BlockSize + 1);
        for (std::size_t lane = count % BoxSet::BlockSize; lane < BoxSet::BlockSize; ++lane)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(set.blocks().back().centre[axis][lane], 0.0);
                EXPECT_EQ(set.blocks().back().halfExtents[axis][lane], 0.0);
            }
    }
}

TEST(BoxSet, KnowsHowFarItsBoxesReach) {
    BoxSet set;
    EXPECT_EQ(set.extent(), 0.0);
    set.add({Vec3(1.0, -7.0, 3.0), Vec3(1.0, 2.0, 1.0)});
    set.add({Vec3::Zero(), Vec3::Ones()});
    EXPECT_EQ(set.extent(), 9.0);
    BoxSet other;
    other.copy(set, 0, 0b10);
    EXPECT_GE(other.extent(), 1.0);
    ASSERT_EQ(other.size(), 1U);
    EXPECT_EQ(other.box(0).halfExtents, Vec3::Ones());
    set.clear();
    EXPECT_EQ(set.extent(), 0.0);
}

TEST(BoxSet, IsNotEmptyWithAnUnboundedBodyAlone) {
    BoxSet set;
    set.addUnbounded();
    EXPECT_FALSE(set.empty());
}
