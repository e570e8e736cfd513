// An application that knows Lixel by plugins.cfg alone: when OGRE unloads the plugin, its code
// goes.

#include "SpoiltLight.h"

#include <Lixel/headless/Headless.h>

#include <Ogre.h>

#include <gtest/gtest.h>

#include <cstdlib>

namespace Lixel::Tests {
namespace {

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
    Ogre::LogManager logs;
    logs.createLog("", true, false, true);
    Ogre::Root root("", "", "");
    root.loadPlugin(OGRE_PLUGIN_DIR "/RenderSystem_GL3Plus.so");
    const Ogre::String plugin = LIXEL_PLUGIN_DIR "/Plugin_Lixel.so";
    root.loadPlugin(plugin);
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

    root.unloadPlugin(plugin);
    EXPECT_EQ(mended->getVisibilityFlags(), flags);
    EXPECT_EQ(bad->getVisibilityFlags(), 0U) << "OGRE is not handed what it aborts on";
    root.renderOneFrame();
    root.loadPlugin(plugin);
    root.renderOneFrame();
    root.unloadPlugin(plugin);
    manager->destroyLight(bad);
    root.renderOneFrame();
    root.destroySceneManager(manager);
}

/// OGRE takes two spellings of a path for two plugins.
TEST(Load, TwiceIsOnce) {
    unsetenv("DISPLAY");
    ASSERT_EQ(Headless::enable(), "");
    Ogre::LogManager logs;
    logs.createLog("", true, false, true);
    Ogre::Root root("", "", "");
    root.loadPlugin(OGRE_PLUGIN_DIR "/RenderSystem_GL3Plus.so");
    const Ogre::String plugin = LIXEL_PLUGIN_DIR "/Plugin_Lixel.so";
    root.loadPlugin(plugin);
    root.loadPlugin("/" + plugin);
    EXPECT_EQ(root.getInstalledPlugins().size(), 2U) << "the render system's and Lixel's";
    openWindow(root);
    root.renderOneFrame();
    root.unloadPlugin(plugin);
    root.renderOneFrame();
    EXPECT_EQ(root.getInstalledPlugins().size(), 2U) << "still loaded by the other spelling";
    root.unloadPlugin("/" + plugin);
    EXPECT_EQ(root.getInstalledPlugins().size(), 1U);
}

} // namespace
} // namespace Lixel::Tests
