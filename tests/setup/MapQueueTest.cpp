// How a frame's budget is divided among maps.

#include <Lixel/setup/MapQueue.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace Lixel::Tests {
namespace {

constexpr unsigned Oldest = 16;

MapBudget mapsAFrame(std::size_t maps) {
    MapBudget budget;
    budget.maps = maps;
    budget.oldest = Oldest;
    return budget;
}

/// Maps that want to be drawn in each frame.
class Contenders {
public:
    explicit Contenders(const MapBudget& givenBudget) : budget(givenBudget) {}

    /// Asks for all maps once. @return which are drawn
    std::vector<bool> frame() {
        ++mFrame;
        std::vector<bool> isDrawn(wishes.size());
        drawn.resize(wishes.size());
        ages.resize(wishes.size());
        for (std::size_t map = 0; map < wishes.size(); ++map) {
            isDrawn[map] = queue.ask({this, map}, mFrame, wishes[map], budget);
            drawn[map] += isDrawn[map] ? 1 : 0;
            ages[map] = isDrawn[map] ? 0 : ages[map] + 1;
        }
        return isDrawn;
    }

    MapQueue queue;
    MapBudget budget;
    std::vector<MapQueue::Wish> wishes;
    std::vector<int> drawn;
    /// Frames in a row without being drawn.
    std::vector<unsigned> ages;

private:
    unsigned long mFrame = 0;
};

TEST(MapQueue, DrawsAsManyAsTheBudgetSays) {
    Contenders maps(mapsAFrame(2));
    maps.wishes.resize(7, {.wrongness = 1.0, .distance = 5.0});
    for (int i = 0; i < 70; ++i)
        EXPECT_EQ(std::ranges::count(maps.frame(), true), 2) << i;
    // All alike, so each in its turn. Of those that waited as long it is the first one's.
    for (const int drawn : maps.drawn)
        EXPECT_NEAR(drawn, 20, 4);
}

TEST(MapQueue, DrawsNearMapsMoreOftenAndNoneTooSeldom) {
    Contenders maps(mapsAFrame(1));
    maps.wishes = {{.distance = 10}, {.distance = 30}, {.distance = 90}, {.distance = 1e6}};
    for (int i = 0; i < 1000; ++i) {
        maps.frame();
        // One that is due waits for no other: there may be two in a frame.
        for (const unsigned age : maps.ages)
            EXPECT_LE(age, Oldest);
    }
    EXPECT_TRUE(std::ranges::is_sorted(maps.drawn, std::ranges::greater{}));
    EXPECT_GT(maps.drawn[0], 2 * maps.drawn[1]);
    EXPECT_LT(maps.drawn[0], 4 * maps.drawn[1]);
    EXPECT_GT(maps.drawn[3], 1000 / static_cast<int>(Oldest) - 10);
}

TEST(MapQueue, DrawsTheMoreWrongOneFirst) {
    Contenders maps(mapsAFrame(1));
    maps.wishes = {{.wrongness = 0.05, .distance = 10}, {.wrongness = 1.0, .distance = 10}};
    for (int i = 0; i < 200; ++i)
        maps.frame();
    EXPECT_GT(maps.drawn[1], 8 * maps.drawn[0]);
    EXPECT_GT(maps.drawn[0], 0);
}

TEST(MapQueue, GivesPlacesThatAreNotNeededToOthers) {
    const MapBudget budget = mapsAFrame(1);
    MapQueue queue;
    const MapQueue::Wish near{.distance = 1};
    const MapQueue::Wish far{.distance = 1000};
    EXPECT_TRUE(queue.ask({&queue, 0}, 1, near, budget));
    EXPECT_FALSE(queue.ask({&queue, 1}, 1, far, budget));
    EXPECT_TRUE(queue.ask({&queue, 0}, 2, near, budget));
    EXPECT_FALSE(queue.ask({&queue, 1}, 2, far, budget));
    // The near one stands still now.
    queue.rest({&queue, 0}, 3, budget);
    EXPECT_TRUE(queue.ask({&queue, 1}, 3, far, budget));
    queue.rest({&queue, 0}, 4, budget);
    EXPECT_TRUE(queue.ask({&queue, 1}, 4, far, budget));
}

TEST(MapQueue, DrawsWhatHasNothingToKeep) {
    Contenders maps(mapsAFrame(1));
    maps.wishes.resize(5, {.distance = 1, .must = true});
    EXPECT_EQ(std::ranges::count(maps.frame(), true), 5);
    for (MapQueue::Wish& wish : maps.wishes)
        wish.must = false;
    EXPECT_EQ(std::ranges::count(maps.frame(), true), 1);
}

TEST(MapQueue, KeepsToMilliseconds) {
    MapBudget budget;
    budget.milliseconds = 3.0;
    Contenders maps(budget);
    maps.wishes = {{.distance = 5, .milliseconds = 1.0},
                   {.distance = 5, .milliseconds = 2.0},
                   {.distance = 5, .milliseconds = 1.5},
                   {.distance = 5, .milliseconds = 9.0}};
    for (int i = 0; i < 100; ++i) {
        const std::vector<bool> isDrawn = maps.frame();
        double sum = 0.0;
        for (std::size_t map = 0; map < isDrawn.size(); ++map)
            sum += isDrawn[map] ? maps.wishes[map].milliseconds : 0.0;
        // One that takes more than there is has a frame of its own.
        if (i > 0 && !isDrawn[3]) {
            EXPECT_LE(sum, 3.0) << i;
        }
        EXPECT_GT(sum, 0.0) << i;
    }
    for (const int drawn : maps.drawn)
        EXPECT_GE(drawn, 100 / static_cast<int>(Oldest) - 2);
}

TEST(MapQueue, KnowsAFrameByItsMaps) {
    // A program that draws its pictures without Ogre::Root's frames.
    const MapBudget budget = mapsAFrame(1);
    MapQueue queue;
    int drawn = 0;
    for (int picture = 0; picture < 50; ++picture)
        for (std::size_t map = 0; map < 5; ++map)
            drawn += queue.ask({&queue, map}, 7, {.distance = 1}, budget) ? 1 : 0;
    EXPECT_EQ(drawn, 50);
}

TEST(MapQueue, HoldsForAnyMixOfWishes) {
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int round = 0; round < 100; ++round) {
        Contenders maps(mapsAFrame(1 + engine() % 4));
        maps.wishes.resize(1 + engine() % 12);
        std::size_t due = 0;
        for (int i = 0; i < 60; ++i) {
            for (MapQueue::Wish& wish : maps.wishes)
                wish = {share(engine), 100 * share(engine), share(engine), share(engine) < 0.02};
            due = static_cast<std::size_t>(std::ranges::count(maps.ages, Oldest)) +
                  static_cast<std::size_t>(
                      std::ranges::count(maps.wishes, true, &MapQueue::Wish::must));
            const std::size_t drawn =
                static_cast<std::size_t>(std::ranges::count(maps.frame(), true));
            EXPECT_LE(drawn, maps.budget.maps + due);
            EXPECT_GE(drawn, std::min(maps.budget.maps, maps.wishes.size()));
            for (const unsigned age : maps.ages)
                EXPECT_LE(age, Oldest);
        }
    }
}

} // namespace
} // namespace Lixel::Tests
