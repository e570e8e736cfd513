// A budget for drawing shadow maps: kept maps are read as they were drawn, and come right later.

#include "TestStage.h"

#include <Lixel/setup/CascadesShadowCameraSetup.h>
#include <Lixel/setup/MapBudget.h>
#include <Lixel/setup/MapPlan.h>
#include <Lixel/setup/ShadowCameraSetups.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace Lixel::Tests {
namespace {

/// The decisions of one frame.
class FramePlans : public ShadowMapObserver {
public:
    FramePlans() { addShadowMapObserver(*this); }
    ~FramePlans() override { removeShadowMapObserver(*this); }
    void shadowMapFitted(const ShadowMap& map) override {
        list.push_back(map.decision);
        drawnLight = drawnLight || (&map.light == light && map.decision.plan == MapPlan::Draw);
    }
    long drawn() const { return std::ranges::count(list, MapPlan::Draw, &MapDecision::plan); }
    long postponed() const {
        return std::ranges::count(list, PlanReason::Postponed, &MapDecision::reason);
    }

    std::vector<MapDecision> list;
    /// A light, and whether a map of it was drawn.
    const Ogre::Light* light = nullptr;
    bool drawnLight = false;
};

/// A box on the ground with others around it, under a sun of four cascades.
class MapBudgetTest : public testing::Test {
protected:
    static constexpr std::size_t Maps = 4;

    MapBudgetTest() {
        for (int i = 0; i < 12; ++i)
            scene.addCube(
                {-33.0F + 6.0F * static_cast<float>(i), 1, -20.0F - 3.0F * static_cast<float>(i)},
                {1, 2, 1});
        Ogre::SceneManager& manager = scene.stage.sceneManager();
        for (const auto& [name, object] : manager.getMovableObjects("Entity"))
            static_cast<Ogre::Entity*>(object)->setMaterialName("Lixel/Surface/Integrated/Maps6");
        manager.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
        manager.setShadowTextureReceiverMaterial(Ogre::MaterialPtr());
        manager.setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, Maps);
        manager.setShadowTextureSettings(512, Maps, Ogre::PF_FLOAT32_R);
        scene.stage.setShadowSetup(cascades());
        for (int i = 0; i < 4; ++i)
            frame();
    }
    ~MapBudgetTest() override { setMapBudget({}); }

    /// Slices that stay where they are.
    static std::shared_ptr<CascadesShadowCameraSetup> cascades() {
        CascadeOptions options;
        options.vsSplitDepths = {17, 30, 50};
        return CascadesShadowCameraSetup::create(XPSMShadowCameraSetup::create(), options);
    }
    static void limitTo(std::size_t maps) {
        MapBudget budget;
        budget.maps = maps;
        setMapBudget(budget);
    }
    void frame() {
        plans.list.clear();
        plans.drawnLight = false;
        scene.stage.drawFrame();
    }
    Ogre::SceneNode& viewer() { return *scene.stage.camera().getParentSceneNode(); }

    BoxOnGround scene;
    FramePlans plans;
};

TEST_F(MapBudgetTest, DrawsNoMoreMapsThanItSays) {
    limitTo(1);
    frame(); // which has nothing to keep
    int postponed = 0;
    std::vector<int> drawn(Maps);
    for (int i = 0; i < 60; ++i) {
        viewer().translate(0.05F, 0, 0);
        viewer().yaw(Ogre::Degree(0.1F), Ogre::Node::TS_WORLD);
        frame();
        ASSERT_EQ(plans.list.size(), Maps);
        postponed += static_cast<int>(plans.postponed());
        for (std::size_t map = 0; map < Maps; ++map)
            drawn[map] += plans.list[map].plan == MapPlan::Draw ? 1 : 0;
    }
    int sum = 0;
    for (const int each : drawn) {
        // Each one at least every seventeenth frame.
        EXPECT_GE(each, 3);
        sum += each;
    }
    EXPECT_LE(sum, 60 + 4);
    EXPECT_GT(postponed, 100);
    EXPECT_GT(drawn.front(), drawn.back());
}

TEST_F(MapBudgetTest, DrawsALightInTimeThatComesAndGoes) {
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    manager.setShadowTextureCountPerLightType(Ogre::Light::LT_SPOTLIGHT, 1);
    manager.setShadowTextureSettings(128, Maps + 1, Ogre::PF_FLOAT32_R);
    Ogre::Light* const lamp = manager.createLight("far lamp");
    lamp->setType(Ogre::Light::LT_SPOTLIGHT);
    lamp->setSpotlightRange(Ogre::Degree(1), Ogre::Degree(2));
    lamp->setCustomShadowCameraSetup(XPSMShadowCameraSetup::create());
    Ogre::SceneNode* const node = manager.getRootSceneNode()->createChildSceneNode();
    node->attachObject(lamp);
    node->setPosition(0, 300, 300);
    node->setDirection(0, -1, -1, Ogre::Node::TS_WORLD);
    limitTo(1);
    plans.light = lamp;
    int asked = 0;
    int drawn = 0;
    for (int i = 0; i < 80; ++i) {
        viewer().translate(0.05F, 0, 0);
        scene.box->translate(0, 0.002F, 0);
        lamp->setVisible(i % 2 == 0);
        frame();
        if (plans.list.size() <= Maps) continue;
        ++asked;
        drawn += plans.drawnLight ? 1 : 0;
    }
    EXPECT_EQ(asked, 40);
    EXPECT_GE(drawn, 80 / 18);
    EXPECT_LT(drawn, 20);
}

TEST_F(MapBudgetTest, ComesRightWhenTheViewerStands) {
    limitTo(1);
    frame();
    for (int i = 0; i < 10; ++i) {
        viewer().translate(0.1F, 0, 0.1F);
        frame();
    }
    for (int i = 0; i < 30; ++i)
        frame();
    for (const MapDecision& decision : plans.list)
        EXPECT_EQ(decision.reason, PlanReason::NothingChanged);
    const std::vector<std::uint8_t> settled = scene.stage.picture();
    setMapBudget({});
    redrawShadowMaps();
    frame();
    EXPECT_EQ(plans.drawn(), static_cast<long>(Maps));
    EXPECT_EQ(settled, scene.stage.picture());
}

TEST_F(MapBudgetTest, ReadsAKeptMapAsItWasDrawn) {
    const auto picture = [&](std::size_t maps) {
        limitTo(maps);
        frame();
        return scene.stage.picture();
    };
    const auto differing = [](const std::vector<std::uint8_t>& a,
                              const std::vector<std::uint8_t>& b) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            count += std::abs(a[i] - b.at(i)) > 3 ? 1U : 0U;
        return 100.0 * static_cast<double>(count) / static_cast<double>(a.size());
    };
    // While maps wait for their turn, shadows of what stands still stay where they are.
    std::vector<std::vector<std::uint8_t>> pictures{picture(1)};
    int postponed = 0;
    for (int i = 0; i < 20; ++i) {
        viewer().translate(0.03F, 0, 0);
        pictures.push_back(picture(1));
        postponed += static_cast<int>(plans.postponed());
    }
    EXPECT_GT(postponed, 40);
    double sum = 0.0;
    for (int i = 20; i > 0; --i) {
        sum += differing(pictures[static_cast<std::size_t>(i)], picture(0));
        viewer().translate(-0.03F, 0, 0);
    }
    scene.stage.light().setCastShadows(false);
    const double shadows = differing(pictures.front(), picture(0));
    EXPECT_GT(shadows, 0.5);
    EXPECT_LT(sum / 20, 0.05 * shadows);
}

TEST_F(MapBudgetTest, DrawsAllWhereSettingsChanged) {
    limitTo(1);
    frame();
    frame();
    scene.stage.sceneManager().setShadowTextureSelfShadow(
        !scene.stage.sceneManager().getShadowTextureSelfShadow());
    frame();
    EXPECT_EQ(plans.postponed(), 0);
    EXPECT_GT(plans.drawn(), 1);
}

TEST_F(MapBudgetTest, LeavesSetupsAloneThatReuseNothing) {
    const auto setup = cascades();
    setup->setReuseMaps(false);
    scene.stage.setShadowSetup(setup);
    limitTo(1);
    for (int i = 0; i < 3; ++i) {
        viewer().translate(0.1F, 0, 0);
        frame();
        EXPECT_EQ(plans.postponed(), 0);
        EXPECT_GT(plans.drawn(), 1);
    }
}

TEST_F(MapBudgetTest, RefusesWhatIsNoTime) {
    MapBudget budget;
    for (const double wrong : {-1.0, std::nan(""), HUGE_VAL}) {
        budget.milliseconds = wrong;
        EXPECT_THROW(setMapBudget(budget), Ogre::InvalidParametersException);
    }
    EXPECT_FALSE(mapBudget().isLimited());
}

TEST_F(MapBudgetTest, KeepsToMilliseconds) {
    MapBudget budget;
    budget.milliseconds = 1e-6;
    setMapBudget(budget);
    frame();
    frame();
    int drawn = 0;
    for (int i = 0; i < 30; ++i) {
        viewer().translate(0.05F, 0, 0);
        frame();
        drawn += static_cast<int>(plans.drawn());
    }
    EXPECT_GE(drawn, 30);
    EXPECT_LE(drawn, 30 + 6);
}

} // namespace
} // namespace Lixel::Tests
