#include "fit/Types.h"

#include <gtest/gtest.h>

using namespace Lixel;

namespace {
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
} // namespace

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
    EXPECT_EQ(set.boxes().size(), 1U);
    EXPECT_EQ(set.invalid(), 3U);
    EXPECT_EQ(set.unbounded(), 3U);
    EXPECT_FALSE(set.empty());
    set.clear();
    EXPECT_TRUE(set.empty());
    EXPECT_EQ(set.invalid(), 0U);
}

TEST(BoxSet, IsNotEmptyWithAnUnboundedBodyAlone) {
    BoxSet set;
    set.addUnbounded();
    EXPECT_FALSE(set.empty());
}
