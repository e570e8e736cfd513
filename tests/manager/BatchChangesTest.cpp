// Casters in batches under random changes: maps of two scenes that go through the same, one with
// batches and kept maps, the other without either.
#include "../stress/Random.h"
#include "BatchScene.h"

#include <Lixel/setup/MapPlan.h>
#include <Lixel/setup/ShadowMapObserver.h>

#include <OgreMaterialManager.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreSubEntity.h>
#include <OgreTechnique.h>

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;

constexpr const char* PanelMesh = "batch panel";

struct ChangedScene {
    BatchScene& batches;
    std::vector<Ogre::Entity*> casters;
    std::size_t made = 0;
};

struct BatchDeed {
    const char* name;
    void (*perform)(ChangedScene& scene, Ogre::Entity& caster, Random& random);
};

Ogre::Pass& firstPass(Ogre::Entity& caster) {
    return *caster.getSubEntity(0)->getMaterial()->getTechnique(0)->getPass(0);
}

void addPanel(ChangedScene& scene, const Vector3& position) {
    if (!Ogre::MeshManager::getSingleton().resourceExists(PanelMesh, Ogre::RGN_DEFAULT))
        Ogre::MeshManager::getSingleton().createPlane(
            PanelMesh, Ogre::RGN_DEFAULT, Ogre::Plane(Vector3(1, 0.3f, 0), 0), 2, 3, 2, 2);
    PictureScene& pictures = scene.batches.scene();
    Ogre::Entity* const panel = pictures.manager().createEntity(
        "panel" + std::to_string(scene.made++), PanelMesh, Ogre::RGN_DEFAULT);
    panel->setMaterial(pictures.surface(Ogre::ColourValue(0.8f, 0.5f, 0.2f)));
    pictures.place().createChildSceneNode(position)->attachObject(panel);
    scene.casters.push_back(panel);
}

/// After a reload, entities begin anew.
void reloadPanels(ChangedScene& scene, Ogre::Entity&, Random&) {
    Ogre::MeshManager::getSingleton().getByName(PanelMesh, Ogre::RGN_DEFAULT)->reload();
    for (Ogre::Entity* caster : scene.casters) {
        if (caster->getMesh()->getName() != PanelMesh) continue;
        caster->_initialise(true);
        caster->setMaterial(scene.batches.scene().surface(Ogre::ColourValue(0.8f, 0.5f, 0.2f)));
    }
}

/// Not the scene manager's: OGRE leaves that as the surface needed it that was drawn last.
Ogre::MaterialPtr ownCaster() {
    Ogre::MaterialManager& materials = Ogre::MaterialManager::getSingleton();
    const char* const name = "batch's own caster";
    const Ogre::MaterialPtr made = materials.getByName(name, "Lixel");
    return made ? made : materials.getByName("Lixel/Caster", "Lixel")->clone(name);
}

void setOwnCaster(ChangedScene&, Ogre::Entity& caster, Random& random) {
    firstPass(caster).getParent()->setShadowCasterMaterial(random.oneIn(5) ? ownCaster()
                                                                           : Ogre::MaterialPtr());
}

void destroyCaster(ChangedScene& scene, Ogre::Entity& caster, Random&) {
    if (scene.casters.size() < 12) return;
    std::erase(scene.casters, &caster);
    caster.detachFromParent();
    scene.batches.manager().destroyEntity(&caster);
}

constexpr std::array Deeds{
    BatchDeed{"show", [](ChangedScene&, Ogre::Entity& c, Random& r) { c.setVisible(!r.oneIn(3)); }},
    BatchDeed{"mask",
              [](ChangedScene&, Ogre::Entity& c, Random& r) {
                  c.setVisibilityFlags(r.of<Ogre::uint32>({1, 2, 3}));
              }},
    BatchDeed{"viewport's mask",
              [](ChangedScene& s, Ogre::Entity&, Random& r) {
                  s.batches.scene().target->getViewport(0)->setVisibilityMask(
                      r.of<Ogre::uint32>({1, 3, 3}));
              }},
    BatchDeed{"cast",
              [](ChangedScene&, Ogre::Entity& c, Random& r) { c.setCastShadows(!r.oneIn(3)); }},
    BatchDeed{"show a part", [](ChangedScene&, Ogre::Entity& c,
                                Random& r) { c.getSubEntity(0)->setVisible(!r.oneIn(3)); }},
    BatchDeed{"culling",
              [](ChangedScene&, Ogre::Entity& c, Random& r) {
                  firstPass(c).setCullingMode(
                      r.of({Ogre::CULL_NONE, Ogre::CULL_CLOCKWISE, Ogre::CULL_ANTICLOCKWISE}));
              }},
    BatchDeed{"holes",
              [](ChangedScene&, Ogre::Entity& c, Random& r) {
                  firstPass(c).setAlphaRejectSettings(
                      r.oneIn(5) ? Ogre::CMPF_GREATER_EQUAL : Ogre::CMPF_ALWAYS_PASS, 128);
              }},
    BatchDeed{"blending",
              [](ChangedScene&, Ogre::Entity& c, Random& r) {
                  firstPass(c).setSceneBlending(r.oneIn(5) ? Ogre::SBT_TRANSPARENT_ALPHA
                                                           : Ogre::SBT_REPLACE);
              }},
    BatchDeed{"own caster", setOwnCaster},
    BatchDeed{"another's material",
              [](ChangedScene& s, Ogre::Entity& c, Random& r) {
                  c.setMaterial(
                      s.casters[r.below(s.casters.size())]->getSubEntity(0)->getMaterial());
              }},
    BatchDeed{"scale",
              [](ChangedScene&, Ogre::Entity& c, Random& r) {
                  const float factor = r.of({-1.0f, -1.0f, 0.8f, 1.25f, 1.1f});
                  c.getParentSceneNode()->scale(factor, r.oneIn(2) ? factor : 1, 1);
              }},
    BatchDeed{"move",
              [](ChangedScene&, Ogre::Entity& c, Random& r) {
                  c.getParentSceneNode()->translate(r.between(-1, 1), 0, r.between(-1, 1));
              }},
    BatchDeed{"turn",
              [](ChangedScene&, Ogre::Entity& c, Random& r) {
                  c.getParentSceneNode()->yaw(Ogre::Degree(r.between(0, 90)));
              }},
    BatchDeed{"queue group",
              [](ChangedScene&, Ogre::Entity& c, Random& r) {
                  c.setRenderQueueGroup(r.of<Ogre::uint8>({50, 50, 60}));
              }},
    BatchDeed{"part's priority",
              [](ChangedScene&, Ogre::Entity& c, Random& r) {
                  c.getSubEntity(0)->setRenderQueueGroupAndPriority(
                      50, r.of<Ogre::ushort>({90, 100, 100}));
              }},
    BatchDeed{"reload the panels' mesh", reloadPanels},
    BatchDeed{"add a panel",
              [](ChangedScene& s, Ogre::Entity&, Random& r) {
                  const float x = r.between(-8, 8);
                  if (s.casters.size() < 40) addPanel(s, Vector3(x, 1.2f, r.between(-8, 8)));
              }},
    BatchDeed{"destroy", destroyCaster},
    BatchDeed{"relate to the camera",
              [](ChangedScene& s, Ogre::Entity&, Random& r) {
                  s.batches.manager().setCameraRelativeRendering(r.oneIn(2));
              }},
    BatchDeed{"turn the sun",
              [](ChangedScene& s, Ogre::Entity&, Random& r) {
                  s.batches.scene().sun->getParentSceneNode()->yaw(Ogre::Degree(r.between(0, 20)),
                                                                   Ogre::Node::TS_WORLD);
              }},
    BatchDeed{"technique",
              [](ChangedScene& s, Ogre::Entity&, Random& r) {
                  s.batches.manager().setShadowTechnique(
                      r.of({Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED,
                            Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
                            Ogre::SHADOWTYPE_TEXTURE_MODULATIVE_INTEGRATED}));
              }},
    BatchDeed{"nothing", [](ChangedScene&, Ogre::Entity&, Random&) {}},
    BatchDeed{"nothing again", [](ChangedScene&, Ogre::Entity&, Random&) {}},
};

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
        addPanel(scene, Vector3(static_cast<float>(i) * 1.5f - 6, 1.5f, -4));
    const Decisions decisions(batches.manager());
    Random random(seed);
    ChangedMaps all;
    std::string done;
    for (int step = 0; step < Steps; ++step) {
        const BatchDeed& deed = Deeds[random.below(Deeds.size())];
        Ogre::Entity& caster = *scene.casters[random.below(scene.casters.size())];
        done += std::string(deed.name) + " of " + caster.getName() + "; ";
        deed.perform(scene, caster, random);
        if (random.oneIn(2)) continue;
        // Where nothing changes, a map is drawn twice, and then kept.
        for (int frames = random.of({1, 1, 4}); frames > 0; --frames) {
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
