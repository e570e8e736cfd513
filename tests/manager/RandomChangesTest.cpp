// Whatever an application changes, the scene manager under test shows, tells and answers what the
// reference does.
#include "Operation.h"
#include "Walk.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace Lixel::Tests {
namespace {

constexpr std::size_t Steps = 250;

/// For a long search by hand, the environment's LIXEL_WALKS asks for more.
std::uint64_t walksOfATest() {
    const char* walks = std::getenv("LIXEL_WALKS");
    return walks != nullptr ? std::strtoull(walks, nullptr, 10) : 20;
}

Walk walkOf(std::uint64_t seed) {
    const Candidate tested = candidate();
    return {referenceOf(tested.rule), tested.manager, seed, allSteps(Steps), tested.answersAlike};
}

/// By the seed of its first walk.
class RandomChanges : public testing::TestWithParam<std::uint64_t> {};

INSTANTIATE_TEST_SUITE_P(From, RandomChanges, testing::Range<std::uint64_t>(0, 8000, 1000),
                         [](const auto& test) { return std::to_string(test.param); });

TEST_P(RandomChanges, AllIsAsInTheReference) {
    std::size_t sights = 0;
    std::size_t queued = 0;
    for (std::uint64_t seed = GetParam(); seed < GetParam() + walksOfATest(); ++seed) {
        const WalkEnd end = go(walkOf(seed));
        ASSERT_EQ(end.difference, "") << story(walkOf(seed));
        sights += end.sights;
        queued += end.queued;
    }
    // Walks through empty scenes would compare nothing.
    EXPECT_GT(sights, walksOfATest() * Steps);
    EXPECT_GT(queued, 3 * sights);
}

TEST(RandomChange, EachIsMadeAndQueriesAreAnswered) {
    std::map<std::string, std::size_t> done;
    std::size_t answers = 0;
    for (std::uint64_t seed = 0; seed < walksOfATest(); ++seed) {
        const WalkEnd end = go(walkOf(seed));
        for (const auto& [name, times] : end.done)
            done[name] += times;
        answers += end.answers;
    }
    for (const Operation& operation : allOperations())
        EXPECT_GE(done[operation.name], 5U) << operation.name;
    if (candidate().answersAlike) {
        EXPECT_GT(answers, 1000U);
    }
}

} // namespace
} // namespace Lixel::Tests
