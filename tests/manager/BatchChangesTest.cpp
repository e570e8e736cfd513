// Casters in batches under random changes: maps of two scenes that go through the same, one with
// batches and kept maps, the other without either.
#include "CasterDeeds.h"

#include <Lixel/setup/MapPlan.h>
#include <Lixel/setup/ShadowMapObserver.h>

#include <gtest/gtest.h>

#include <utility>

namespace Lixel::Tests {
namespace {

/// Counts what is done with a scene's maps.
class Decisions : private ShadowMapObserver {
public:
    explicit Decisions(const Ogre::SceneManager& manager) : mManager(manager) {
        addShadowMapObserver(*this);
    }
    ~Decisions() override { removeShadowMapObserver(*this); }
    Decisions(const Decisions&) = delete;
    Decisions& operator=(const Decisions&) = delete;

    std::size_t kept = 0;

private:
    void shadowMapFitted(const ShadowMap& map) override {
        if (&map.sceneManager != &mManager) return;
        if (map.decision.plan == MapPlan::Reuse) ++kept;
    }

    const Ogre::SceneManager& mManager;
};

/// What one scene has shown.
struct ChangedMaps {
    std::vector<std::vector<std::uint8_t>> maps;
    /// Before each map.
    std::vector<std::string> deeds;
    std::size_t drawCalls = 0;
    std::size_t kept = 0;
};

/// Scenes of one configuration share their shadow textures, so each goes its way by itself.
ChangedMaps walk(std::uint64_t seed, bool hasBatches) {
    constexpr int Steps = 120;
    BatchScene batches(hasBatches, hasBatches);
    // At rest, so that maps are kept.
    batches.scene().moving.clear();
    ChangedScene scene{batches, {}};
    // Not the ground, and not what hangs below another.
    for (int i = 1; i < 25; ++i)
        scene.casters.push_back(batches.manager().getEntity("thing" + std::to_string(i)));
    for (int i = 0; i < 8; ++i)
        addPanel(scene, Ogre::Vector3(static_cast<float>(i) * 1.5f - 6, 1.5f, -4));
    const Decisions decisions(batches.manager());
    Random random(seed);
    ChangedMaps all;
    std::string done;
    for (int step = 0; step < Steps; ++step) {
        const CasterDeed& deed = casterDeeds()[random.below(casterDeeds().size())];
        Ogre::Entity& caster = *scene.casters[random.below(scene.casters.size())];
        done += std::string(deed.name) + " of " + caster.getName() + "; ";
        deed.perform(scene, caster, random);
        if (random.oneIn(2)) continue;
        // Where nothing changes, a map is drawn until its fit rests, twice at least, and then kept.
        for (int frames = random.of({1, 1, 8}); frames > 0; --frames) {
            all.maps.push_back(batches.drawMap());
            all.deeds.push_back(std::exchange(done, ""));
            all.drawCalls += batches.drawCalls();
        }
    }
    all.kept = decisions.kept;
    return all;
}

class BatchChanges : public testing::TestWithParam<std::uint64_t> {};

INSTANTIATE_TEST_SUITE_P(Seed, BatchChanges, testing::Range<std::uint64_t>(1, 7));

TEST_P(BatchChanges, LeaveEachTexelAsSingleDrawsHaveIt) {
    const ChangedMaps single = walk(GetParam(), false);
    const ChangedMaps batched = walk(GetParam(), true);
    ASSERT_EQ(single.maps.size(), batched.maps.size());
    std::string done;
    std::size_t changed = 0;
    for (std::size_t i = 0; i < single.maps.size(); ++i) {
        done += "\n" + batched.deeds[i];
        ASSERT_EQ(differingTexels(single.maps[i], batched.maps[i]), 0U) << "map " << i << done;
        changed += i > 0 && single.maps[i] != single.maps[i - 1] ? 1U : 0U;
    }
    EXPECT_GT(changed, 10U);
    EXPECT_GT(batched.kept, 3U);
    EXPECT_LT(static_cast<double>(batched.drawCalls), 0.7 * static_cast<double>(single.drawCalls));
}

} // namespace
} // namespace Lixel::Tests
