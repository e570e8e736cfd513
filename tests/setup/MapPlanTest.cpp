// Which shadow maps are drawn, which are kept and which are empty, and that none is ever stale.

#include "TestStage.h"

#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/MapPlan.h>
#include <Lixel/setup/ShadowCameraSetups.h>

/// Of no namespace: an application's.
class AnApplicationsListener : public Ogre::RenderQueueListener {};

namespace Lixel::Tests {
namespace {

/// The decisions of the last frame.
class Decisions : public ShadowMapObserver {
public:
    Decisions() { addShadowMapObserver(*this); }
    ~Decisions() override { removeShadowMapObserver(*this); }
    void shadowMapFitted(const ShadowMap& map) override { list.push_back(map.decision); }

    std::vector<MapDecision> list;
};

/// Proves each map that is kept while it lives.
class Proof {
public:
    explicit Proof(Samples::Stage& stage) {
        setProofMode(true, [&stage] { stage.finish(); });
    }
    ~Proof() {
        EXPECT_EQ(proofCount().different, 0U);
        setProofMode(false);
    }
};

/// A box on the ground whose map has come to rest.
class MapPlanTest : public testing::Test {
protected:
    MapPlanTest() { settle(); }

    void settle() {
        for (int i = 0; i < 8; ++i)
            frame();
    }
    MapDecision frame() {
        mDecisions.list.clear();
        scene.stage.drawFrame();
        EXPECT_EQ(mDecisions.list.size(), 1U);
        return mDecisions.list.empty() ? MapDecision{} : mDecisions.list.front();
    }
    Ogre::Entity& boxEntity() {
        return *static_cast<Ogre::Entity*>(scene.box->getAttachedObject(0));
    }

    BoxOnGround scene;
    Decisions mDecisions;
};

TEST_F(MapPlanTest, AStillMapIsKept) {
    const MapDecision decision = frame();
    EXPECT_EQ(decision.plan, MapPlan::Reuse) << toString(decision.reason);
    EXPECT_EQ(decision.reason, PlanReason::NothingChanged);
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
    EXPECT_GT(scene.visibilityAt(InTheSun), 128);
}

TEST_F(MapPlanTest, KeptMapsAreWhatWouldBeDrawn) {
    const Proof proof(scene.stage);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(frame().plan, MapPlan::Reuse);
    EXPECT_EQ(proofCount().maps, 3U);
}

/// A deed between two frames, and what the next frame has to say of it.
struct Change {
    std::string name;
    std::function<void(MapPlanTest&, BoxOnGround&)> make;
    PlanReason reason;
};

void PrintTo(const Change& change, std::ostream* out) {
    *out << change.name;
}

class MapPlanChangeTest : public MapPlanTest, public testing::WithParamInterface<Change> {};

Ogre::Entity& entityOf(BoxOnGround& scene) {
    return *static_cast<Ogre::Entity*>(scene.box->getAttachedObject(0));
}

const std::vector<Change>& changes() {
    static const std::vector<Change> all{
        {"BoxMoves", [](auto&, BoxOnGround& s) { s.box->translate(0.0F, 0.001F, 0.0F); },
         PlanReason::MapChanged},
        {"CullingMode",
         [](auto&, BoxOnGround& s) {
             entityOf(s).getSubEntity(0)->getMaterial()->setCullingMode(Ogre::CULL_NONE);
         },
         PlanReason::CastersChanged},
        {"MaterialHasHoles",
         [](auto&, BoxOnGround& s) {
             Ogre::MaterialPtr holes =
                 entityOf(s).getSubEntity(0)->getMaterial()->clone("with holes");
             for (Ogre::Pass* pass : holes->getTechnique(0)->getPasses())
                 pass->setAlphaRejectSettings(Ogre::CMPF_GREATER, 128);
             entityOf(s).setMaterial(holes);
         },
         PlanReason::RestlessCaster},
        {"PartIsHidden",
         [](auto&, BoxOnGround& s) { entityOf(s).getSubEntity(0)->setVisible(false); },
         PlanReason::CastersChanged},
        {"PartIsInAnotherQueueGroup",
         [](auto&, BoxOnGround& s) { entityOf(s).getSubEntity(0)->setRenderQueueGroup(60); },
         PlanReason::CastersChanged},
        {"ListenerOnTheBox",
         [](auto&, BoxOnGround& s) {
             static Ogre::MovableObject::Listener listener;
             entityOf(s).setListener(&listener);
         },
         PlanReason::RestlessCaster},
        {"SunTurns",
         [](auto&, BoxOnGround& s) {
             s.stage.light().getParentSceneNode()->yaw(Ogre::Degree(5), Ogre::Node::TS_WORLD);
         },
         PlanReason::MapChanged},
        {"ViewerMoves",
         [](auto&, BoxOnGround& s) {
             s.stage.camera().getParentSceneNode()->translate(0.5F, 0, 0);
         },
         PlanReason::MapChanged},
        {"MapIsLarger",
         [](auto&, BoxOnGround& s) {
             s.stage.sceneManager().setShadowTextureSettings(256, 1, Ogre::PF_FLOAT32_R);
         },
         PlanReason::Unknown},
        {"VisibilityMask",
         [](auto&, BoxOnGround& s) { s.stage.viewport().setVisibilityMask(0x7FFFFFFF); },
         PlanReason::SettingsChanged},
        {"OtherTechnique",
         [](auto&, BoxOnGround& s) {
             s.stage.sceneManager().setShadowTechnique(
                 Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
         },
         PlanReason::SettingsChanged},
        {"OwnListener",
         [](auto&, BoxOnGround& s) {
             static AnApplicationsListener listener;
             s.stage.sceneManager().addRenderQueueListener(&listener);
         },
         PlanReason::Listener},
        {"OwnCasterMaterial",
         [](auto&, BoxOnGround& s) {
             Ogre::MaterialPtr caster = Ogre::MaterialManager::getSingleton()
                                            .getByName("Lixel/Caster")
                                            ->clone("own caster");
             auto program = createProgram("own/fragment", Ogre::RGN_DEFAULT, "glsl",
                                          Ogre::GPT_FRAGMENT_PROGRAM);
             program->setSource("#version 330\nin vec2 lixelSurface;\nout vec4 colour;\n"
                                "void main() { colour = vec4(0.5); }");
             caster->getTechnique(0)->getPass(0)->setFragmentProgram("own/fragment");
             s.stage.sceneManager().setShadowTextureCasterMaterial(caster);
         },
         PlanReason::OwnCasterMaterial},
        {"AnotherDrewIntoTheTexture",
         [](auto&, BoxOnGround& s) {
             s.stage.sceneManager().getShadowTexture(0)->getBuffer()->getRenderTarget()->update();
         },
         PlanReason::Unknown},
        {"RedrawIsAskedFor", [](auto&, BoxOnGround&) { redrawShadowMaps(); }, PlanReason::Unknown},
        {"ReuseIsForbidden",
         [](auto&, BoxOnGround& s) {
             const auto setup = XPSMShadowCameraSetup::create();
             setup->setReuseMaps(false);
             s.stage.setShadowSetup(setup);
         },
         PlanReason::Forbidden},
    };
    return all;
}

INSTANTIATE_TEST_SUITE_P(Changes, MapPlanChangeTest, testing::ValuesIn(changes()),
                         [](const auto& test) { return test.param.name; });

TEST_P(MapPlanChangeTest, HasTheMapDrawn) {
    ASSERT_EQ(frame().plan, MapPlan::Reuse);
    GetParam().make(*this, scene);
    const MapDecision decision = frame();
    EXPECT_EQ(decision.plan, MapPlan::Draw);
    EXPECT_EQ(decision.reason, GetParam().reason) << toString(decision.reason);
    if (decision.reason == PlanReason::RestlessCaster) {
        EXPECT_EQ(decision.name, boxEntity().getName());
    }
    // Listeners and masks go with the scene.
    scene.stage.viewport().setVisibilityMask(0xFFFFFFFF);
}

TEST_F(MapPlanTest, ABoxThatCastsNoMoreLeavesAnEmptyMapThatCostsNothing) {
    boxEntity().setCastShadows(false);
    EXPECT_EQ(frame().plan, MapPlan::Skip);
    EXPECT_GT(scene.visibilityAt(InShadow), 128);
    {
        const Proof proof(scene.stage);
        EXPECT_EQ(frame().plan, MapPlan::Skip);
        EXPECT_EQ(proofCount().maps, 1U);
    }
    boxEntity().setCastShadows(true);
    EXPECT_EQ(frame().plan, MapPlan::Draw);
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
}

TEST_F(MapPlanTest, WhatIsHiddenLeavesTheMap) {
    for (int i = 0; i < 2; ++i) {
        boxEntity().setVisible(false);
        EXPECT_EQ(frame().plan, MapPlan::Skip);
        EXPECT_GT(scene.visibilityAt(InShadow), 128);
        boxEntity().setVisible(true);
        EXPECT_EQ(frame().plan, MapPlan::Draw);
        EXPECT_LT(scene.visibilityAt(InShadow), 128);
    }
}

TEST_F(MapPlanTest, TwoScenesThatShareATextureDrawBoth) {
    Ogre::SceneManager& other = *scene.stage.root().createSceneManager();
    other.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE);
    other.setShadowTextureSettings(1024, 1, Ogre::PF_FLOAT32_R);
    Ogre::Camera* const viewer = other.createCamera("other");
    other.getRootSceneNode()->createChildSceneNode()->attachObject(viewer);
    Ogre::Light* const sun = other.createLight();
    sun->setType(Ogre::Light::LT_DIRECTIONAL);
    other.getRootSceneNode()->createChildSceneNode()->attachObject(sun);
    Ogre::Viewport* const second =
        scene.stage.window().addViewport(viewer, 1, 0.9F, 0.9F, 0.1F, 0.1F);
    frame();
    frame();
    const MapDecision decision = frame();
    EXPECT_EQ(decision.plan, MapPlan::Draw);
    EXPECT_EQ(decision.reason, PlanReason::Unknown);
    scene.stage.window().removeViewport(second->getZOrder());
    scene.stage.root().destroySceneManager(&other);
}

} // namespace
} // namespace Lixel::Tests
