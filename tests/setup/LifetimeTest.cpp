// Setups that outlive what they were used with, and what is gone and replaced by another.

#include "SpoiltLight.h"
#include "TestStage.h"

#include <Lixel/setup/MapPlan.h>

#include <OgreException.h>

namespace Lixel::Tests {
namespace {

/// OGRE knows it by PluginFolder of plugins.cfg, "/", and the path there.
const Ogre::String Plugin = "/" LIXEL_PLUGIN_DIR "/Plugin_Lixel.so";

/// Options as text, whose dictionary goes with Root.
void expectOptionsWork(const Ogre::ShadowCameraSetupPtr& setup) {
    auto& fitted = dynamic_cast<FittedShadowCameraSetup&>(*setup);
    EXPECT_TRUE(fitted.setParameter("filter_radius", "1"));
    EXPECT_EQ(fitted.getParameter("filter_radius"), "1");
    EXPECT_GT(fitted.getParameters().size(), CommonOptions::declared().size());
    EXPECT_THROW(fitted.setParameter("filter_radius", "-1"), Ogre::InvalidParametersException);
}

class OutlivingSetup : public testing::TestWithParam<std::string> {};

TEST_P(OutlivingSetup, MayGoAfterRoot) {
    Ogre::ShadowCameraSetupPtr setup = Samples::findShadowSetup(GetParam())->create();
    {
        BoxOnGround scene("", "Uniform");
        scene.stage.setShadowSetup(setup);
        EXPECT_LT(scene.visibilityAt(InShadow), 128);
    }
    expectOptionsWork(setup);
    setup.reset();
}

TEST_P(OutlivingSetup, MayBeUsedWithANewRoot) {
    const Ogre::ShadowCameraSetupPtr setup = Samples::findShadowSetup(GetParam())->create();
    for (int i = 0; i < 3; ++i) {
        BoxOnGround scene("", "Uniform");
        scene.stage.setShadowSetup(setup);
        EXPECT_LT(scene.visibilityAt(InShadow), 128);
        expectOptionsWork(setup);
    }
}

TEST_P(OutlivingSetup, MayGoAfterItsSceneManager) {
    Ogre::ShadowCameraSetupPtr setup = Samples::findShadowSetup(GetParam())->create();
    BoxOnGround scene("", "Uniform");
    scene.stage.setShadowSetup(setup);
    scene.stage.drawFrame();
    scene.stage.window().removeAllViewports();
    scene.stage.root().destroySceneManager(&scene.stage.sceneManager());
    setup.reset();
    scene.stage.drawFrame();
}

INSTANTIATE_TEST_SUITE_P(Setups, OutlivingSetup, testing::Values("Uniform", "XPSM", "Optimal"));

/// Drops a setup when the scene manager goes, as an application's own listener may.
TEST(Lifetime, ASetupMayGoWhileItsSceneManagerDoes) {
    struct Owner : Ogre::SceneManager::Listener {
        void sceneManagerDestroyed(Ogre::SceneManager*) override { setup.reset(); }
        Ogre::ShadowCameraSetupPtr setup;
    } owner;
    BoxOnGround scene;
    scene.stage.sceneManager().addListener(&owner);
    owner.setup = Samples::findShadowSetup("XPSM")->create();
    scene.stage.setShadowSetup(owner.setup);
    scene.stage.drawFrame();
    scene.stage.light().resetCustomShadowCameraSetup();
    scene.stage.window().removeAllViewports();
    scene.stage.root().destroySceneManager(&scene.stage.sceneManager());
    EXPECT_FALSE(owner.setup);
}

TEST(Lifetime, ALightInAnothersPlaceInheritsNothing) {
    BoxOnGround scene;
    LogCollector log;
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    scene.stage.light().setVisible(false);
    Ogre::SceneNode* const node = manager.getRootSceneNode()->createChildSceneNode();
    node->setPosition(0, 1, 0);
    const auto drawWith = [&](Ogre::Light& lamp) {
        lamp.setType(Ogre::Light::LT_POINT);
        lamp.setCustomShadowCameraSetup(scene.stage.light().getCustomShadowCameraSetup());
        node->attachObject(&lamp);
        scene.stage.drawFrame();
        scene.stage.drawFrame();
    };
    Ogre::Light* const first = manager.createLight("Lamp");
    drawWith(*first);
    EXPECT_EQ(log.count("light 'Lamp' shines too wide"), 1U);
    manager.destroyLight(first);
    // Some get other addresses, as the allocator has it.
    Ogre::Light* second = nullptr;
    for (int i = 0; i < 10000 && second != first; ++i)
        second = manager.createLight();
    if (second != first) GTEST_SKIP() << "no new light has the old one's address";
    drawWith(*second);
    EXPECT_EQ(log.count("light '" + second->getName() + "' shines too wide"), 1U);
}

TEST(Lifetime, ThePluginLeavesNothingBehind) {
    BoxOnGround scene;
    LogCollector log;
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
    scene.stage.root().unloadPlugin(Plugin);
    scene.stage.light().resetCustomShadowCameraSetup();
    scene.stage.sceneManager().setShadowTechnique(Ogre::SHADOWTYPE_NONE);
    // OGRE does not mind one of these without shadows; the guard would.
    Ogre::Light* const lamp = scene.stage.sceneManager().createLight();
    scene.stage.sceneManager().getRootSceneNode()->createChildSceneNode()->attachObject(lamp);
    lamp->setType(Ogre::Light::LT_SPOTLIGHT);
    SpoiltLight(*lamp).spoil();
    scene.stage.drawFrame();
    EXPECT_EQ(log.count("not finite"), 0U) << "a guard was left in the scene manager";
}

TEST(Lifetime, SetupsWorkAfterThePluginWasLoadedAgain) {
    BoxOnGround scene;
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
    for (int i = 0; i < 2; ++i) {
        scene.stage.root().unloadPlugin(Plugin);
        scene.stage.drawFrame();
        scene.stage.root().loadPlugin(Plugin);
        EXPECT_LT(scene.visibilityAt(InShadow), 128);
    }
}

/// OGRE throws between the preparation of a map and its drawing; then the textures go.
TEST(Lifetime, AnExceptionInAMapLeavesNothingBehind) {
    BoxOnGround scene;
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    scene.stage.drawFrame();
    const Ogre::MaterialPtr caster =
        Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster");
    for (unsigned short size = 64; size <= 1024; size = static_cast<unsigned short>(2 * size)) {
        manager.setShadowTextureCasterMaterial({}); // OGRE's own has no programs
        EXPECT_THROW(scene.stage.drawFrame(), Ogre::Exception);
        manager.setShadowTextureCasterMaterial(caster);
        manager.setShadowTextureSettings(size, 1, Ogre::PF_FLOAT32_R);
        scene.stage.drawFrame();
        const Ogre::TexturePtr& texture = manager.getShadowTexture(0);
        EXPECT_TRUE(texture->getBuffer()->getRenderTarget()->getViewport(0)->isAutoUpdated());
    }
    EXPECT_LT(scene.visibilityAt(Ogre::Vector3(-2, 0, 0)), 128);
}

/// OGRE's own, which notes what a shadow camera culls with before it is set up.
class NotingSetup : public Ogre::DefaultShadowCameraSetup {
public:
    void getShadowCamera(const Ogre::SceneManager* manager, const Ogre::Camera* viewer,
                         const Ogre::Viewport* viewport, const Ogre::Light* light,
                         Ogre::Camera* camera, std::size_t iteration) const override {
        culling = camera->getCullingFrustum();
        DefaultShadowCameraSetup::getShadowCamera(manager, viewer, viewport, light, camera,
                                                  iteration);
    }
    mutable const Ogre::Frustum* culling = nullptr;
};

/// The textures stay, and so do their cameras.
TEST(Lifetime, AnExceptionInAMapIsOverInTheNextFrame) {
    BoxOnGround scene;
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    scene.stage.drawFrame();
    const Ogre::Viewport& viewport =
        *manager.getShadowTexture(0)->getBuffer()->getRenderTarget()->getViewport(0);
    const Ogre::Frustum* const own = viewport.getCamera()->getCullingFrustum();
    const Ogre::MaterialPtr caster =
        Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster");
    const auto lixels = scene.stage.light().getCustomShadowCameraSetup();
    const auto noting = std::make_shared<NotingSetup>();
    for (const Ogre::ShadowCameraSetupPtr& next : {lixels, Ogre::ShadowCameraSetupPtr(noting)}) {
        manager.setShadowTextureCasterMaterial({}); // OGRE's own has no programs
        redrawShadowMaps();
        EXPECT_THROW(scene.stage.drawFrame(), Ogre::Exception);
        EXPECT_NE(viewport.getCamera()->getCullingFrustum(), own);
        manager.setShadowTextureCasterMaterial(caster);
        scene.stage.setShadowSetup(next);
        scene.stage.drawFrame();
        EXPECT_EQ(viewport.getCamera()->getCullingFrustum(), own);
        EXPECT_TRUE(viewport.isAutoUpdated());
    }
    EXPECT_EQ(noting->culling, own);
}

} // namespace
} // namespace Lixel::Tests
