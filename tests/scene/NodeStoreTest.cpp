// The flat store of nodes' boxes, against comparing every box.
#include "scene/NodeStore.h"

#include <OgreSceneNode.h>

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <random>

namespace Lixel::Tests {
namespace {

using Ogre::AxisAlignedBox;
using Ogre::Vector3;

/// A store with random boxes, and the same boxes in a plain list.
class NodeStoreTest : public testing::Test {
protected:
    struct Entry {
        std::unique_ptr<Ogre::SceneNode> node;
        NodeStore::Slot slot;
        AxisAlignedBox box;
    };

    float between(float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(mEngine);
    }
    bool oneIn(int count) { return std::uniform_int_distribution<int>(1, count)(mEngine) == 1; }

    AxisAlignedBox randomBox(float reach) {
        const Vector3 centre(between(-reach, reach), between(-10, 10), between(-reach, reach));
        // Few are large.
        const float size = oneIn(20) ? reach / 4 : 2.0f;
        const Vector3 half(between(0, size), between(0, size), between(0, size));
        return {centre - half, centre + half};
    }

    Entry& add(const AxisAlignedBox& box) {
        auto node = std::make_unique<Ogre::SceneNode>(nullptr);
        const NodeStore::Slot slot = mStore.add(*node);
        mStore.set(slot, box, Ogre::Sphere());
        mEntries.push_back({std::move(node), slot, box});
        return mEntries.back();
    }
    void move(Entry& entry, const AxisAlignedBox& box) {
        entry.box = box;
        mStore.set(entry.slot, box, Ogre::Sphere());
    }
    void remove(std::size_t index) {
        mStore.remove(mEntries[index].slot);
        std::swap(mEntries[index], mEntries.back());
        mEntries.pop_back();
    }

    NodeCuller randomVolume(float reach) {
        NodeCuller volume;
        const int planes = std::uniform_int_distribution<int>(0, 8)(mEngine);
        const Vec3 middle(between(-reach, reach), 0.0, between(-reach, reach));
        for (int i = 0; i < planes; ++i) {
            const Vec3 normal = Vec3(between(-1, 1), between(-1, 1), between(-1, 1)).normalized();
            volume.add(normal, between(0, reach) - normal.dot(middle), Vec3::Zero());
        }
        return volume;
    }

    /// Compares what a search finds with what a comparison of all boxes finds.
    void expectFinds(const NodeCuller& volume) {
        NodeSearch search;
        mStore.find(volume, search);
        EXPECT_TRUE(std::ranges::is_sorted(search.found));
        EXPECT_TRUE(std::ranges::is_sorted(search.doubtful));
        mDoubtful += search.doubtful.size();
        std::size_t guess = 0;
        search.decide(
            [&](NodeStore::Slot slot) { return volume.excludes(mStore.box(slot), guess); });
        std::vector<NodeStore::Slot> expected;
        for (const Entry& entry : mEntries) {
            if (entry.box.isNull()) continue;
            if (!volume.excludes(entry.box, guess)) expected.push_back(entry.slot);
            EXPECT_EQ(&mStore.node(entry.slot), entry.node.get());
        }
        std::ranges::sort(expected);
        EXPECT_EQ(search.found, expected);
        mFound += expected.size();
    }

    /// Compares how many blocks a view of a twentieth of the world cuts with how many it cuts where
    /// the same boxes were just added.
    void expectSearchesLikeANewStore() {
        NodeStore fresh;
        for (const Entry& entry : mEntries)
            fresh.set(fresh.add(*entry.node), entry.box, Ogre::Sphere());
        fresh.tighten();
        NodeCuller volume;
        for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
            volume.add(normal, 110.0, Vec3::Zero());
        EXPECT_LE(4 * mStore.cutBlocks(volume), 5 * fresh.cutBlocks(volume));
        expectFinds(volume);
    }

    std::mt19937 mEngine{7};
    NodeStore mStore;
    std::vector<Entry> mEntries;
    std::size_t mFound = 0;
    std::size_t mDoubtful = 0;
};

TEST_F(NodeStoreTest, FindsNothingInAnEmptyStore) {
    expectFinds(NodeCuller());
    EXPECT_EQ(mStore.size(), 0U);
}

TEST_F(NodeStoreTest, FindsWhatAComparisonOfAllBoxesFinds) {
    constexpr float Reach = 300;
    for (int step = 0; step < 4000; ++step) {
        if (mEntries.size() < 500 || oneIn(3)) add(randomBox(Reach));
        if (oneIn(4))
            remove(std::uniform_int_distribution<std::size_t>(0, mEntries.size() - 1)(mEngine));
        for (int moves = 0; moves < 3 && !mEntries.empty(); ++moves) {
            Entry& entry = mEntries[std::uniform_int_distribution<std::size_t>(0, mEntries.size() -
                                                                                      1)(mEngine)];
            const Vector3 shift(between(-5, 5), between(-1, 1), between(-5, 5));
            if (entry.box.isFinite() && !oneIn(10))
                move(entry, {entry.box.getMinimum() + shift, entry.box.getMaximum() + shift});
            else if (oneIn(4))
                move(entry, oneIn(2) ? AxisAlignedBox::BOX_NULL : AxisAlignedBox::BOX_INFINITE);
            else
                move(entry, randomBox(Reach));
        }
        if (oneIn(3)) mStore.tighten();
        if (step % 20 == 0) expectFinds(randomVolume(Reach));
    }
    EXPECT_GT(mFound, 1000U);
    // Few boxes lie at a border to single precision.
    EXPECT_LT(mDoubtful, mFound / 4);
    while (!mEntries.empty())
        remove(mEntries.size() / 2);
    expectFinds(NodeCuller());
    EXPECT_EQ(mStore.size(), 0U);
    EXPECT_LE(mStore.blockCount(), 1U);
}

TEST_F(NodeStoreTest, HoldsManyBoxesAtOnePlace) {
    const AxisAlignedBox box(Vector3(1, 2, 3), Vector3(2, 3, 4));
    for (int i = 0; i < 1000; ++i)
        add(box);
    add(randomBox(10));
    for (int i = 0; i < 20; ++i)
        expectFinds(randomVolume(5));
    for (std::size_t i = 0; i < 900; ++i)
        move(mEntries[i], randomBox(50));
    for (int i = 0; i < 20; ++i)
        expectFinds(randomVolume(50));
}

TEST_F(NodeStoreTest, HoldsFarFromTheWorldsOrigin) {
    const Vector3 far(3e5f, 0, -2e6f);
    for (int i = 0; i < 300; ++i) {
        const AxisAlignedBox box = randomBox(100);
        add({box.getMinimum() + far, box.getMaximum() + far});
    }
    for (int i = 0; i < 50; ++i) {
        NodeCuller volume;
        for (int plane = 0; plane < 6; ++plane) {
            const Vec3 normal = Vec3(between(-1, 1), between(-1, 1), between(-1, 1)).normalized();
            volume.add(normal, between(0, 80) - normal.dot(Vec3(3e5, 0, -2e6)), Vec3::Zero());
        }
        expectFinds(volume);
    }
    EXPECT_GT(mFound, 100U);
}

TEST_F(NodeStoreTest, LeavesWhatHasNoBoundsToTheSearcher) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float huge = std::numeric_limits<float>::max();
    AxisAlignedBox broken(Vector3(0), Vector3(1));
    broken.getMinimum().x = nan;
    add(broken);
    add({Vector3(-huge), Vector3(huge)});
    add(AxisAlignedBox::BOX_INFINITE);
    add(AxisAlignedBox::BOX_NULL);
    NodeSearch search;
    mStore.find(randomVolume(10), search);
    EXPECT_TRUE(search.found.empty());
    EXPECT_EQ(search.doubtful, (std::vector<NodeStore::Slot>{0, 1, 2}));
    EXPECT_EQ(mStore.size(), 3U);
}

TEST_F(NodeStoreTest, FindsInTheOrderInWhichNodesWereAdded) {
    for (int i = 0; i < 300; ++i)
        add(randomBox(100));
    for (Entry& entry : mEntries)
        move(entry, randomBox(100));
    NodeSearch search;
    mStore.find(NodeCuller(), search);
    ASSERT_EQ(search.found.size(), 300U);
    for (std::size_t i = 0; i < 300; ++i)
        EXPECT_EQ(search.found[i], i);
}

TEST_F(NodeStoreTest, KeepsNeighboursInOneBlock) {
    for (int i = 0; i < 20000; ++i)
        add(randomBox(1000));
    mStore.tighten();
    // A view of a twentieth of the world cuts few blocks: few boxes are compared one by one.
    NodeCuller volume;
    for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
        volume.add(normal, 220.0, Vec3::Zero());
    EXPECT_LT(mStore.cutBlocks(volume), mStore.blockCount() / 3);
    EXPECT_LT(mStore.blockCount(), 20000U / 24);
}

TEST_F(NodeStoreTest, KeepsNeighboursInOneBlockWhileTheyWander) {
    for (int i = 0; i < 5000; ++i)
        add(randomBox(500));
    for (int step = 0; step < 100; ++step) {
        for (Entry& entry : mEntries) {
            const Vector3 shift(between(-20, 20), 0, between(-20, 20));
            move(entry, {entry.box.getMinimum() + shift, entry.box.getMaximum() + shift});
        }
        mStore.tighten();
    }
    expectSearchesLikeANewStore();
}

TEST_F(NodeStoreTest, KeepsNoSmallBoxesAmongLargeOnes) {
    // Each of these is as large as their world, and so is what holds any of them.
    for (int i = 0; i < 2000; ++i)
        add({Vector3(-500), Vector3(500)});
    for (Entry& entry : mEntries) {
        const Vector3 centre(between(-400, 400), 0, between(-400, 400));
        move(entry, {centre - Vector3(1), centre + Vector3(1)});
    }
    mStore.tighten();
    expectSearchesLikeANewStore();
}

} // namespace
} // namespace Lixel::Tests
