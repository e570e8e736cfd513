// Where an application announces changes of objects, a scene that stands still is not looked at; and
// whatever changes is seen: at once where scene nodes tell it, and otherwise when it is announced.

#include "TestStage.h"

#include "common/Surface.h"

#include <Lixel/manager/LixelSceneManager.h>
#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/CascadesShadowCameraSetup.h>
#include <Lixel/setup/MapBudget.h>
#include <Lixel/setup/MapPlan.h>
#include <Lixel/setup/MeshPreparation.h>
#include <Lixel/setup/ShadowCameraSetups.h>

#include <OgreBillboardSet.h>
#include <OgreMovablePlane.h>

namespace Lixel::Tests {
namespace {

/// As long as any search takes to come to rest, and then some.
constexpr int FramesToRest = 400;

/// What was said of one map.
struct Told {
    std::string light;
    MapDecision decision;
    Mat4 clipFromWorld;
    /// Whether nothing was surveyed, searched for or fitted.
    bool repeated;
};

class Announced : public testing::Test, public ShadowMapObserver {
public:
    Announced() {
        addShadowMapObserver(*this);
        manager().setChangesAnnounced(true);
    }
    ~Announced() override {
        removeShadowMapObserver(*this);
        setProofMode(false);
        setMapBudget({});
        // Masks go with the stage; materials' settings with its resources.
    }
    void shadowMapFitted(const ShadowMap& map) override {
        maps.push_back({map.light.getName(), map.decision, map.fit.clipFromWorld,
                        map.surveyMicroseconds == 0.0 && map.casterMicroseconds == 0.0 &&
                            map.fitMicroseconds == 0.0});
    }

    LixelSceneManager& manager() {
        return static_cast<LixelSceneManager&>(scene.stage.sceneManager());
    }
    Ogre::Entity& box() { return *static_cast<Ogre::Entity*>(scene.box->getAttachedObject(0)); }
    Ogre::Entity& ground() {
        return *static_cast<Ogre::Entity*>(scene.ground->getAttachedObject(0));
    }
    Ogre::Light& sun() { return scene.stage.light(); }

    /// Draws a frame. @return its maps
    const std::vector<Told>& frame() {
        maps.clear();
        scene.stage.drawFrame();
        return maps;
    }
    bool allRepeated() {
        frame();
        return !maps.empty() && std::ranges::all_of(maps, &Told::repeated);
    }
    bool noneRepeated() {
        frame();
        return !maps.empty() && std::ranges::none_of(maps, &Told::repeated);
    }
    /// Draws frames until all maps are repeated. @return whether that came
    bool comesToRest() {
        for (int i = 0; i < FramesToRest; ++i)
            if (allRepeated()) return true;
        return false;
    }
    std::vector<std::uint8_t> picture() {
        frame();
        return scene.stage.picture();
    }

    BoxOnGround scene{"LixelSceneManager"};
    std::vector<Told> maps;
};

TEST_F(Announced, AStillSceneIsNotLookedAt) {
    ASSERT_TRUE(comesToRest());
    EXPECT_EQ(maps.front().decision.plan, MapPlan::Reuse);
    EXPECT_EQ(maps.front().decision.reason, PlanReason::NothingChanged);
    const Mat4 fit = maps.front().clipFromWorld;
    const auto repeated = picture();
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
    EXPECT_GT(scene.visibilityAt(InTheSun), 128);
    manager().setChangesAnnounced(false);
    EXPECT_EQ(repeated, picture());
    EXPECT_EQ(maps.front().clipFromWorld, fit);
    EXPECT_FALSE(maps.front().repeated);
}

TEST_F(Announced, NothingIsTakenForGrantedUnlessItIsPromised) {
    manager().setChangesAnnounced(false);
    EXPECT_FALSE(manager().getChangesAnnounced());
    EXPECT_FALSE(comesToRest());
    box().setVisible(false);
    EXPECT_EQ(frame().front().decision.plan, MapPlan::Skip);
}

TEST_F(Announced, AFrameWithoutShadowsIsRepeated) {
    box().setCastShadows(false);
    ASSERT_TRUE(comesToRest());
    EXPECT_EQ(maps.front().decision.plan, MapPlan::Skip);
}

/// A deed between two frames.
struct Deed {
    std::string name;
    std::function<void(Announced&)> make;
};

void PrintTo(const Deed& deed, std::ostream* out) {
    *out << deed.name;
}

const auto DeedName = [](const auto& test) { return test.param.name; };

class AnnouncedDeedTest : public Announced, public testing::WithParamInterface<Deed> {
protected:
    /// What is drawn now is what is drawn when all is read anew.
    void expectFresh() {
        const std::vector<std::uint8_t> shown = scene.stage.picture();
        const std::vector<Told> then = maps;
        redrawShadowMaps();
        const std::vector<std::uint8_t> fresh = picture();
        ASSERT_EQ(then.size(), maps.size());
        for (std::size_t i = 0; i < maps.size(); ++i)
            ASSERT_EQ(then[i].clipFromWorld, maps[i].clipFromWorld);
        EXPECT_EQ(shown, fresh);
    }
};

// What scene nodes tell.

class AnnouncedByNodes : public AnnouncedDeedTest {};

const std::vector<Deed>& deedsOfNodes() {
    static const std::vector<Deed> all{
        {"Moved", [](Announced& a) { a.scene.box->translate(0.1F, 0, 0); }},
        {"Turned", [](Announced& a) { a.scene.box->yaw(Ogre::Degree(90)); }},
        {"Scaled", [](Announced& a) { a.scene.box->scale(1.1F, 1, 1); }},
        {"TheirParentMoved",
         [](Announced& a) { a.scene.box->getParentSceneNode()->translate(0, 0, 0.1F); }},
        {"MovedAndAskedFor",
         [](Announced& a) {
             a.scene.box->translate(0.1F, 0, 0);
             a.scene.box->_getDerivedPosition();
         }},
        {"Created",
         [](Announced& a) { a.scene.addCube(Ogre::Vector3(4, 1, 0), Ogre::Vector3(1)); }},
        {"AttachedTogether",
         [](Announced& a) {
             Ogre::Entity* const second =
                 a.manager().createEntity("second", Ogre::SceneManager::PT_SPHERE);
             second->setMaterialName("Lixel/Surface");
             a.scene.box->attachObject(second);
         }},
        {"Detached", [](Announced& a) { a.scene.box->detachAllObjects(); }},
        {"EntityDestroyed", [](Announced& a) { a.manager().destroyEntity(&a.box()); }},
        {"NodeDestroyed",
         [](Announced& a) { a.manager().destroySceneNode(std::exchange(a.scene.box, nullptr)); }},
        {"OutOfTheGraph",
         [](Announced& a) { a.scene.box->getParentSceneNode()->removeChild(a.scene.box); }},
        {"ParentOutOfTheGraph",
         [](Announced& a) {
             Ogre::SceneNode* const parent = a.manager().createSceneNode();
             a.scene.box->getParentSceneNode()->removeChild(a.scene.box);
             a.manager().getRootSceneNode()->addChild(parent);
             parent->addChild(a.scene.box);
             a.scene.stage.drawFrame();
             ASSERT_TRUE(a.comesToRest());
             a.manager().getRootSceneNode()->removeChild(parent);
         }},
        {"BackInTheGraph",
         [](Announced& a) {
             a.manager().getRootSceneNode()->removeChild(a.scene.box);
             ASSERT_TRUE(a.comesToRest());
             a.manager().getRootSceneNode()->addChild(a.scene.box);
         }},
        {"ManualObjectChanged",
         [](Announced& a) {
             Ogre::ManualObject* const object = a.manager().createManualObject();
             object->setCastShadows(false);
             const auto fill = [&](float height) {
                 object->position(-3, height, 3);
                 object->position(0, height, 3);
                 object->position(-3, height, 6);
                 object->end();
             };
             object->begin("Lixel/Surface", Ogre::RenderOperation::OT_TRIANGLE_LIST);
             fill(0.1F);
             a.manager().getRootSceneNode()->createChildSceneNode()->attachObject(object);
             ASSERT_TRUE(a.comesToRest());
             object->beginUpdate(0);
             fill(1.0F);
         }},
    };
    return all;
}

INSTANTIATE_TEST_SUITE_P(Changes, AnnouncedByNodes, testing::ValuesIn(deedsOfNodes()), DeedName);

TEST_P(AnnouncedByNodes, AreSeenAtOnce) {
    ASSERT_TRUE(comesToRest());
    ASSERT_NO_FATAL_FAILURE(GetParam().make(*this));
    EXPECT_TRUE(noneRepeated());
    expectFresh();
    EXPECT_TRUE(comesToRest());
}

// What is read in each frame all the same.

class ReadWithoutPromise : public AnnouncedDeedTest {};

const std::vector<Deed>& deedsThatAreRead() {
    static const std::vector<Deed> all{
        {"SunTurns",
         [](Announced& a) {
             a.sun().getParentSceneNode()->yaw(Ogre::Degree(5), Ogre::Node::TS_WORLD);
         }},
        {"SunBecomesASpot", [](Announced& a) { a.sun().setType(Ogre::Light::LT_SPOTLIGHT); }},
        {"LightsDistance", [](Announced& a) { a.sun().setShadowFarDistance(40); }},
        {"ShadowDistance", [](Announced& a) { a.manager().setShadowFarDistance(40); }},
        {"ViewerMoves",
         [](Announced& a) { a.scene.stage.camera().getParentSceneNode()->translate(0.1F, 0, 0); }},
        {"ViewerTurns",
         [](Announced& a) { a.scene.stage.camera().getParentSceneNode()->pitch(Ogre::Degree(1)); }},
        {"ViewersAngle", [](Announced& a) { a.scene.stage.camera().setFOVy(Ogre::Degree(30)); }},
        {"ViewersFarDistance", [](Announced& a) { a.scene.stage.camera().setFarClipDistance(50); }},
        {"Option",
         [](Announced& a) {
             static_cast<FittedShadowCameraSetup&>(*a.sun().getCustomShadowCameraSetup())
                 .setFilterRadius(3);
         }},
        {"OptionAsText",
         [](Announced& a) {
             static_cast<FittedShadowCameraSetup&>(*a.sun().getCustomShadowCameraSetup())
                 .setParameter("strength", "1");
         }},
        {"VisiblePoints",
         [](Announced& a) {
             static_cast<FittedShadowCameraSetup&>(*a.sun().getCustomShadowCameraSetup())
                 .setVisiblePoints({{InShadow}, {InTheSun}}, {{0, 1, 0}, {0, 1, 0}});
         }},
        {"MapSize",
         [](Announced& a) { a.manager().setShadowTextureSettings(256, 1, Ogre::PF_FLOAT32_R); }},
        {"SelfShadow", [](Announced& a) { a.manager().setShadowTextureSelfShadow(false); }},
        {"Technique",
         [](Announced& a) {
             a.manager().setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
         }},
        {"MaskOfTheView",
         [](Announced& a) { a.scene.stage.viewport().setVisibilityMask(0x7FFFFFFF); }},
        {"MaskOfTheManager", [](Announced& a) { a.manager().setVisibilityMask(0x7FFFFFFF); }},
        {"QueueWithoutShadows",
         [](Announced& a) {
             a.manager().getRenderQueue()->getQueueGroup(60)->setShadowsEnabled(false);
         }},
        {"MeshPrepared", [](Announced& a) { prepareMesh(a.box().getMesh()); }},
        {"RedrawIsAskedFor", [](Announced&) { redrawShadowMaps(); }},
    };
    return all;
}

INSTANTIATE_TEST_SUITE_P(Changes, ReadWithoutPromise, testing::ValuesIn(deedsThatAreRead()),
                         DeedName);

TEST_P(ReadWithoutPromise, AreSeenAtOnce) {
    ASSERT_TRUE(comesToRest());
    GetParam().make(*this);
    EXPECT_TRUE(noneRepeated());
    EXPECT_TRUE(comesToRest());
    scene.stage.viewport().setVisibilityMask(0xFFFFFFFF);
}

TEST_F(Announced, AnotherSetupIsFitted) {
    ASSERT_TRUE(comesToRest());
    scene.stage.setShadowSetup(OptimalShadowCameraSetup::create());
    EXPECT_TRUE(noneRepeated());
    EXPECT_TRUE(comesToRest());
}

TEST_F(Announced, OptionsOfSlicesCount) {
    const auto slices = XPSMShadowCameraSetup::create();
    scene.stage.setShadowSetup(CascadesShadowCameraSetup::create(slices));
    ASSERT_TRUE(comesToRest());
    slices->setOptions({.strength = 0.5});
    EXPECT_TRUE(noneRepeated());
}

TEST_F(Announced, TexturesAndSettingsOfDrawingAreReadForEachMap) {
    ASSERT_TRUE(comesToRest());
    manager().getShadowTexture(0)->getBuffer()->getRenderTarget()->update();
    frame();
    EXPECT_TRUE(maps.front().repeated);
    EXPECT_EQ(maps.front().decision.plan, MapPlan::Draw);
    EXPECT_EQ(maps.front().decision.reason, PlanReason::Unknown);
    EXPECT_EQ(frame().front().decision.plan, MapPlan::Reuse);

    manager().setShadowCasterRenderBackFaces(false);
    frame();
    EXPECT_EQ(maps.front().decision.plan, MapPlan::Draw);
    EXPECT_EQ(maps.front().decision.reason, PlanReason::SettingsChanged);
    EXPECT_EQ(frame().front().decision.plan, MapPlan::Reuse);
}

// What nobody tells.

class AnnouncedByCalls : public AnnouncedDeedTest {};

const std::vector<Deed>& deedsOfObjects() {
    static const std::vector<Deed> all{
        {"Hidden", [](Announced& a) { a.box().setVisible(false); }},
        {"CastsNoMore", [](Announced& a) { a.box().setCastShadows(false); }},
        {"Casts", [](Announced& a) { a.ground().setCastShadows(true); }},
        {"Flags", [](Announced& a) { a.box().setVisibilityFlags(0); }},
        {"PartHidden", [](Announced& a) { a.box().getSubEntity(0)->setVisible(false); }},
        {"QueueGroup", [](Announced& a) { a.box().setRenderQueueGroup(60); }},
        {"RenderingDistance", [](Announced& a) { a.box().setRenderingDistance(1); }},
        {"Material",
         [](Announced& a) {
             a.box().setMaterial(Samples::makeSurface("other", Ogre::ColourValue::Blue));
         }},
        {"Culling",
         [](Announced& a) {
             a.box().getSubEntity(0)->getMaterial()->setCullingMode(Ogre::CULL_ANTICLOCKWISE);
         }},
        {"ReceivesNoMore",
         [](Announced& a) { a.ground().getSubEntity(0)->getMaterial()->setReceiveShadows(false); }},
    };
    return all;
}

INSTANTIATE_TEST_SUITE_P(Changes, AnnouncedByCalls, testing::ValuesIn(deedsOfObjects()), DeedName);

TEST_P(AnnouncedByCalls, AreSeenWhenTheyAreAnnounced) {
    ASSERT_TRUE(comesToRest());
    GetParam().make(*this);
    manager().announceChange();
    EXPECT_TRUE(noneRepeated());
    expectFresh();
}

TEST_P(AnnouncedByCalls, AreSeenWhenARedrawIsAskedFor) {
    ASSERT_TRUE(comesToRest());
    GetParam().make(*this);
    redrawShadowMaps();
    EXPECT_TRUE(noneRepeated());
}

/// It is what the promise is for.
TEST_P(AnnouncedByCalls, AreNotLookedForWhereTheyAreNot) {
    ASSERT_TRUE(comesToRest());
    GetParam().make(*this);
    EXPECT_TRUE(allRepeated());
}

TEST_P(AnnouncedByCalls, AreSeenAtOnceWithoutThePromise) {
    ASSERT_TRUE(comesToRest());
    manager().setChangesAnnounced(false);
    GetParam().make(*this);
    EXPECT_TRUE(noneRepeated());
    expectFresh();
}

// Proof mode.

TEST_F(Announced, ProofModeProvesAKeptPromise) {
    ASSERT_TRUE(comesToRest());
    setProofMode(true, [this] { scene.stage.finish(); });
    for (int i = 0; i < 4; ++i)
        EXPECT_TRUE(noneRepeated());
    EXPECT_EQ(proofCount().maps, 4U);
    EXPECT_EQ(proofCount().different, 0U);
    setProofMode(false);
    EXPECT_TRUE(comesToRest());
}

TEST_F(Announced, ProofModeFindsABrokenPromise) {
    const std::vector<Deed> breaches{
        {"a hidden part", [](Announced& a) { a.box().getSubEntity(0)->setVisible(false); }},
        {"a hidden caster", [](Announced& a) { a.box().setVisible(false); }},
        {"a shown caster", [](Announced& a) { a.box().setVisible(true); }},
        {"another caster", [](Announced& a) { a.ground().setCastShadows(true); }},
        {"a receiver that is none",
         [](Announced& a) { a.ground().getSubEntity(0)->getMaterial()->setReceiveShadows(false); }},
    };
    for (const Deed& breach : breaches) {
        box().getSubEntity(0)->setVisible(true);
        manager().announceChange();
        ASSERT_TRUE(comesToRest()) << breach.name;
        const LogCollector log;
        setProofMode(true, [this] { scene.stage.finish(); });
        breach.make(*this);
        frame();
        EXPECT_EQ(proofCount().different, 1U) << breach.name;
        EXPECT_EQ(log.count("would have been kept"), 1U) << breach.name;
        setProofMode(false);
    }
}

TEST_F(Announced, ProofModeTakesNoAnnouncedChangeForABreach) {
    ASSERT_TRUE(comesToRest());
    setProofMode(true, [this] { scene.stage.finish(); });
    box().setVisible(false);
    manager().announceChange();
    frame();
    scene.box->translate(1, 0, 0);
    box().setVisible(true);
    manager().announceChange();
    frame();
    EXPECT_EQ(proofCount().different, 0U);
}

// What the promise does not cover.

TEST_F(Announced, RestlessCastersAreDrawnEachTime) {
    for (Ogre::Pass* const pass :
         box().getSubEntity(0)->getMaterial()->getTechnique(0)->getPasses())
        pass->setAlphaRejectSettings(Ogre::CMPF_GREATER, 0);
    EXPECT_FALSE(comesToRest());
    EXPECT_EQ(maps.front().decision.reason, PlanReason::RestlessCaster);
}

TEST_F(Announced, RestlessReceiversAreSurveyedEachTime) {
    Ogre::BillboardSet* const cloud = manager().createBillboardSet();
    cloud->setCastShadows(false);
    cloud->setMaterialName("Lixel/Surface");
    cloud->createBillboard(Ogre::Vector3(0, 3, 0));
    Ogre::SceneNode* const node = manager().getRootSceneNode()->createChildSceneNode();
    node->attachObject(cloud);
    EXPECT_FALSE(comesToRest());
    EXPECT_EQ(maps.front().decision.plan, MapPlan::Reuse);
    node->detachAllObjects();
    EXPECT_TRUE(comesToRest());
}

TEST_F(Announced, BodiesWithoutBoundsAreSurveyedEachTime) {
    Ogre::ManualObject* const endless = manager().createManualObject();
    endless->setBoundingBox(Ogre::AxisAlignedBox(Ogre::AxisAlignedBox::EXTENT_INFINITE));
    endless->begin("Lixel/Surface", Ogre::RenderOperation::OT_TRIANGLE_LIST);
    endless->position(0, 5, 0);
    endless->position(1, 5, 0);
    endless->position(0, 5, 1);
    endless->end();
    endless->setCastShadows(false);
    manager().getRootSceneNode()->createChildSceneNode()->attachObject(endless);
    EXPECT_FALSE(comesToRest());
}

/// XPSM by any other name.
class SomeonesSetup : public FittedShadowCameraSetup {
public:
    bool saysSo = false;

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override {
        return fitMap(problem, XpsmOptions(), state);
    }
    bool dependsOnlyOnOptions() const noexcept override { return saysSo; }
};

TEST_F(Announced, AnApplicationsSetupIsFittedEachTimeUnlessItSaysOtherwise) {
    const auto setup = std::make_shared<SomeonesSetup>();
    scene.stage.setShadowSetup(setup);
    EXPECT_FALSE(comesToRest());
    setup->saysSo = true;
    EXPECT_TRUE(comesToRest());
}

TEST_F(Announced, AMovablePlaneIsFittedEachTime) {
    const auto setup = PlaneOptimalShadowCameraSetup::create();
    Ogre::MovablePlane plane(Ogre::Plane(Ogre::Vector3::UNIT_Y, 0));
    setup->setMovablePlane(&plane);
    scene.stage.setShadowSetup(setup);
    EXPECT_FALSE(comesToRest());
    setup->setMovablePlane(nullptr);
    EXPECT_TRUE(comesToRest());
}

// Several lights, maps and viewers.

class AnnouncedSetupTest : public Announced, public testing::WithParamInterface<std::string> {};

INSTANTIATE_TEST_SUITE_P(Setups, AnnouncedSetupTest,
                         testing::Values("Uniform", "Optimal", "LiSPSM", "Trapezoidal", "PSM",
                                         "PlaneOptimal"),
                         [](const auto& test) { return test.param; });

TEST_P(AnnouncedSetupTest, ComesToRest) {
    scene.stage.setShadowSetup(Samples::findShadowSetup(GetParam())->create());
    EXPECT_TRUE(comesToRest());
}

TEST_F(Announced, MapsThatLastAreRepeated) {
    const auto setup = XPSMShadowCameraSetup::create();
    setup->setLastingMaps(0.2F);
    scene.stage.setShadowSetup(setup);
    ASSERT_TRUE(comesToRest());
    EXPECT_EQ(maps.front().decision.plan, MapPlan::Reuse);
    scene.stage.camera().getParentSceneNode()->translate(0.01F, 0, 0);
    EXPECT_TRUE(noneRepeated());
    EXPECT_TRUE(comesToRest());
}

TEST_F(Announced, ABudgetRests) {
    MapBudget budget;
    budget.maps = 1;
    setMapBudget(budget);
    ASSERT_TRUE(comesToRest());
    scene.box->translate(1, 0, 0);
    EXPECT_TRUE(noneRepeated());
    EXPECT_TRUE(comesToRest());
}

TEST_F(Announced, SeveralMapsOfALightAreRepeated) {
    manager().setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    manager().setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, 3);
    manager().setShadowTextureSettings(128, 3, Ogre::PF_FLOAT32_R);
    sun().setCustomShadowCameraSetup(CascadesShadowCameraSetup::create());
    // Where slices end settles slowly.
    ASSERT_TRUE(comesToRest() || comesToRest() || comesToRest() || comesToRest());
    EXPECT_EQ(maps.size(), 3U);
    const auto still = picture();
    EXPECT_TRUE(std::ranges::all_of(maps, &Told::repeated));
    // Another draws into one of them.
    manager().getShadowTexture(1)->getBuffer()->getRenderTarget()->update();
    EXPECT_EQ(still, picture());
    EXPECT_TRUE(std::ranges::all_of(maps, &Told::repeated));
    EXPECT_EQ(maps[1].decision.plan, MapPlan::Draw);
    scene.box->translate(0.1F, 0, 0);
    EXPECT_TRUE(noneRepeated());
}

TEST_F(Announced, EachLightRestsByItself) {
    manager().setShadowTextureCount(2);
    manager().setShadowTextureSettings(256, 2, Ogre::PF_FLOAT32_R);
    Ogre::Light* const lamp = manager().createLight("lamp");
    lamp->setType(Ogre::Light::LT_SPOTLIGHT);
    lamp->setSpotlightRange(Ogre::Degree(40), Ogre::Degree(70));
    lamp->setAttenuation(60, 1, 0, 0);
    Ogre::SceneNode* const node =
        manager().getRootSceneNode()->createChildSceneNode(Ogre::Vector3(6, 12, 4));
    node->attachObject(lamp);
    node->setDirection(-0.4F, -1, -0.3F, Ogre::Node::TS_WORLD);
    lamp->setCustomShadowCameraSetup(UniformShadowCameraSetup::create());
    ASSERT_TRUE(comesToRest());
    ASSERT_EQ(maps.size(), 2U);
    for (int i = 0; i < 3; ++i) {
        node->translate(0.1F, 0, 0);
        for (const Told& map : frame())
            EXPECT_EQ(map.repeated, map.light != "lamp");
    }
    lamp->setSpotlightOuterAngle(Ogre::Degree(60));
    for (const Told& map : frame())
        EXPECT_EQ(map.repeated, map.light != "lamp");
    ASSERT_TRUE(comesToRest());
    scene.box->translate(0.1F, 0, 0);
    EXPECT_TRUE(noneRepeated());
}

TEST_F(Announced, EachViewerRestsByItself) {
    Ogre::Camera* const second = manager().createCamera("second");
    second->setNearClipDistance(0.1F);
    second->setFarClipDistance(200);
    Ogre::SceneNode* const node =
        manager().getRootSceneNode()->createChildSceneNode(Ogre::Vector3(10, 6, 3));
    node->attachObject(second);
    node->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
    scene.stage.window().addViewport(second, 1, 0.6F, 0.6F, 0.4F, 0.4F);
    // They share a texture: it is drawn for each of them.
    ASSERT_TRUE(comesToRest());
    ASSERT_EQ(maps.size(), 2U);
    const auto still = picture();
    EXPECT_EQ(maps[0].decision.plan, MapPlan::Draw);
    manager().setChangesAnnounced(false);
    EXPECT_EQ(still, picture());
    manager().setChangesAnnounced(true);
    ASSERT_TRUE(comesToRest());
    node->translate(0.1F, 0, 0);
    frame();
    EXPECT_TRUE(maps[0].repeated);
    EXPECT_FALSE(maps[1].repeated);
    scene.box->translate(0.1F, 0, 0);
    EXPECT_TRUE(noneRepeated());
    scene.stage.window().removeViewport(1);
}

/// An application asks a setup for matrices, with a camera of its own.
TEST_F(Announced, QuestionsInBetweenAreAnswered) {
    ASSERT_TRUE(comesToRest());
    const Mat4 fit = maps.front().clipFromWorld;
    Ogre::Camera* const own = manager().createCamera("own");
    manager().getRootSceneNode()->createChildSceneNode()->attachObject(own);
    sun().getCustomShadowCameraSetup()->getShadowCamera(&manager(), &scene.stage.camera(),
                                                        &scene.stage.viewport(), &sun(), own, 0);
    EXPECT_TRUE(own->isCustomProjectionMatrixEnabled());
    frame();
    EXPECT_EQ(maps.front().clipFromWorld, fit);
    EXPECT_TRUE(comesToRest());
}

} // namespace
} // namespace Lixel::Tests
