// An application that knows Lixel by plugins.cfg alone: when OGRE unloads the plugin, its code
// goes.

#include "SpoiltLight.h"

#include <Lixel/headless/Headless.h>

#include <Ogre.h>

#include <gtest/gtest.h>

#include <cstdlib>

namespace Lixel::Tests {
namespace {

const Ogre::String LixelPlugin = LIXEL_PLUGIN_DIR "/Plugin_Lixel.so";

/// OGRE with a render system and Lixel's plugin, and no window yet.
struct LoadedOgre {
    LoadedOgre() {
        root.loadPlugin(OGRE_PLUGIN_DIR "/RenderSystem_GL3Plus.so");
        root.loadPlugin(LixelPlugin);
    }

    struct Log {
        Log() { manager.createLog("", true, false, true); }
        Ogre::LogManager manager;
    } log;
    Ogre::Root root{"", "", ""};
};

/// With the first render system there is.
Ogre::RenderWindow* openWindow(Ogre::Root& root) {
    root.setRenderSystem(root.getAvailableRenderers().front());
    root.initialise(false);
    Ogre::NameValuePairList parameters;
    for (const auto& [name, value] : Headless::windowParameters())
        parameters[name] = value;
    return root.createRenderWindow("", 32, 32, false, &parameters);
}

TEST(Unload, NothingIsCalledThatIsGone) {
    unsetenv("DISPLAY");
    ASSERT_EQ(Headless::enable(), "");
    LoadedOgre ogre;
    Ogre::Root& root = ogre.root;
    Ogre::RenderWindow* const window = openWindow(root);
    Ogre::ResourceGroupManager::getSingleton().initialiseAllResourceGroups();
    Ogre::SceneManager* const manager = root.createSceneManager();
    Ogre::Camera* const camera = manager->createCamera("");
    manager->getRootSceneNode()->createChildSceneNode()->attachObject(camera);
    window->addViewport(camera);
    Ogre::Light* const mended = manager->createLight("mended");
    Ogre::Light* const bad = manager->createLight("bad");
    for (Ogre::Light* light : {mended, bad}) {
        light->setType(Ogre::Light::LT_DIRECTIONAL);
        manager->getRootSceneNode()->createChildSceneNode()->attachObject(light);
    }
    SpoiltLight(*bad).spoil();
    SpoiltLight spoilt(*mended);
    spoilt.spoil();
    const Ogre::uint32 flags = mended->getVisibilityFlags();
    root.renderOneFrame();
    // Shadows on this one would end the program.
    spoilt.mend();

    root.unloadPlugin(LixelPlugin);
    EXPECT_EQ(mended->getVisibilityFlags(), flags);
    EXPECT_EQ(bad->getVisibilityFlags(), 0U) << "OGRE is not handed what it aborts on";
    root.renderOneFrame();
    root.loadPlugin(LixelPlugin);
    root.renderOneFrame();
    root.unloadPlugin(LixelPlugin);
    manager->destroyLight(bad);
    root.renderOneFrame();
    root.destroySceneManager(manager);
}

void readLixelsScripts() {
    Ogre::ResourceGroupManager& groups = Ogre::ResourceGroupManager::getSingleton();
    for (const char* folder :
         {LIXEL_MATERIALS_DIR "/scripts", LIXEL_MATERIALS_DIR "/programs/glsl"})
        groups.addResourceLocation(folder, "FileSystem");
    groups.addResourceLocation(OGRE_SHADOW_MEDIA, "FileSystem", Ogre::RGN_INTERNAL);
    groups.initialiseAllResourceGroups();
}

/// Six cubes before a sun.
Ogre::SceneManager* makeCubes(Ogre::Root& root, Ogre::RenderWindow& window,
                              const std::string& managerType = "LixelSceneManager") {
    Ogre::SceneManager* const manager = root.createSceneManager(managerType);
    Ogre::SceneNode* const world = manager->getRootSceneNode();
    Ogre::Camera* const camera = manager->createCamera("");
    camera->setNearClipDistance(1);
    world->createChildSceneNode(Ogre::Vector3(0, 100, 800))->attachObject(camera);
    window.addViewport(camera);
    manager->setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    manager->setShadowTextureSettings(64, 1, Ogre::PF_FLOAT32_R);
    manager->setShadowTextureSelfShadow(true);
    manager->setShadowFarDistance(2000);
    manager->setShadowTextureCasterMaterial(
        Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster"));
    Ogre::Light* const sun = manager->createLight();
    sun->setType(Ogre::Light::LT_DIRECTIONAL);
    Ogre::SceneNode* const node = world->createChildSceneNode();
    node->attachObject(sun);
    node->setDirection(Ogre::Vector3(-1, -2, 0), Ogre::Node::TS_WORLD);
    for (int i = 0; i < 6; ++i) {
        Ogre::Entity* const cube = manager->createEntity(Ogre::SceneManager::PT_CUBE);
        cube->setMaterialName("Lixel/Surface/Integrated");
        world->createChildSceneNode(Ogre::Vector3(150.0f * static_cast<float>(i) - 375, 0, 0))
            ->attachObject(cube);
    }
    return manager;
}

std::size_t countBatchMaterials() {
    std::size_t count = 0;
    for (const auto& [handle, material] :
         Ogre::MaterialManager::getSingleton().getResourceIterator())
        if (material->getName().compare(0, 12, "Lixel/Batch/") == 0) ++count;
    return count;
}

/// What Lixel's scene manager made with the render system goes with the plugin, or with OGRE.
class BatchesEnd : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Unloads, BatchesEnd, testing::Bool());

TEST_P(BatchesEnd, LeaveNothing) {
    unsetenv("DISPLAY");
    ASSERT_EQ(Headless::enable(), "");
    LoadedOgre ogre;
    Ogre::Root& root = ogre.root;
    Ogre::RenderWindow* const window = openWindow(root);
    readLixelsScripts();
    Ogre::SceneManager* const manager = makeCubes(root, *window);
    for (int frame = 0; frame < 3; ++frame)
        root.renderOneFrame();
    EXPECT_EQ(
        manager->getShadowTexture(0)->getBuffer()->getRenderTarget()->getStatistics().batchCount,
        1U);
    EXPECT_GT(countBatchMaterials(), 0U);
    if (!GetParam()) return;
    window->removeAllViewports();
    root.unloadPlugin(LixelPlugin);
    EXPECT_TRUE(root.getSceneManagers().empty());
    EXPECT_EQ(countBatchMaterials(), 0U);
    root.renderOneFrame();
}

/// OGRE keeps the programs of scripts, whose class is the plugin's.
TEST(Unload, ProgramsGoOn) {
    unsetenv("DISPLAY");
    ASSERT_EQ(Headless::enable(), "");
    LoadedOgre ogre;
    Ogre::Root& root = ogre.root;
    Ogre::RenderWindow* const window = openWindow(root);
    readLixelsScripts();
    makeCubes(root, *window, "DefaultSceneManager");
    root.renderOneFrame();
    root.unloadPlugin(LixelPlugin);
    root.renderOneFrame();
    // One that was not used so far.
    const Ogre::MaterialPtr unused =
        Ogre::MaterialManager::getSingleton().getByName("Lixel/Surface/Integrated/Maps6");
    unused->load();
    EXPECT_NE(unused->getBestTechnique(), nullptr);
    root.loadPlugin(LixelPlugin);
    root.renderOneFrame();
    Ogre::HighLevelGpuProgramManager::getSingleton().reloadAll();
    root.renderOneFrame();
    root.unloadPlugin(LixelPlugin);
    root.renderOneFrame();
}

/// OGRE takes two spellings of a path for two plugins.
TEST(Load, TwiceIsOnce) {
    unsetenv("DISPLAY");
    ASSERT_EQ(Headless::enable(), "");
    LoadedOgre ogre;
    Ogre::Root& root = ogre.root;
    root.loadPlugin("/" + LixelPlugin);
    EXPECT_EQ(root.getInstalledPlugins().size(), 2U) << "the render system's and Lixel's";
    openWindow(root);
    root.renderOneFrame();
    root.unloadPlugin(LixelPlugin);
    root.renderOneFrame();
    EXPECT_EQ(root.getInstalledPlugins().size(), 2U) << "still loaded by the other spelling";
    root.unloadPlugin("/" + LixelPlugin);
    EXPECT_EQ(root.getInstalledPlugins().size(), 1U);
}

} // namespace
} // namespace Lixel::Tests
