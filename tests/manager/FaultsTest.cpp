// The walks find the faults that a flat scene manager may have.
#include "OwnBoxesManager.h"
#include "Walk.h"

#include <gtest/gtest.h>

namespace Lixel::Tests {
namespace {

/// With as many walks as the test of the scene manager, each of a few steps more.
std::uint64_t walksUntilFound(Fault fault) {
    constexpr std::uint64_t Walks = 24;
    for (std::uint64_t seed = 0; seed < Walks; ++seed)
        if (!go({OwnBoxesManager, faultyManager(fault), seed, allSteps(120)}).difference.empty())
            return seed + 1;
    return 0;
}

class Faults : public testing::TestWithParam<Fault> {};

INSTANTIATE_TEST_SUITE_P(Fault, Faults, testing::ValuesIn(AllFaults),
                         [](const auto& test) { return testing::PrintToString(test.param); });

TEST_P(Faults, AreFound) {
    EXPECT_GT(walksUntilFound(GetParam()), 0U);
}

TEST(Faults, NoneIsFoundWhereNoneIs) {
    for (std::uint64_t seed = 0; seed < 4; ++seed)
        EXPECT_EQ(go({OwnBoxesManager, OwnBoxesManager, seed, allSteps(120)}).difference, "");
}

} // namespace
} // namespace Lixel::Tests
