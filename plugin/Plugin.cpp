#include "Plugin.h"

#include <Lixel/manager/LixelSceneManager.h>
#include <Lixel/material/OnDemandPrograms.h>
#include <Lixel/material/ShadowParameters.h>
#include <Lixel/scene/Log.h>
#include <Lixel/script/ShadowCameraSetupManager.h>
#include <Lixel/setup/Detach.h>
#include <Lixel/setup/LightGuard.h>

#include <OgreRoot.h>
#include <OgreSceneManager.h>

namespace Lixel {

Plugin::Plugin() = default;
Plugin::~Plugin() = default;

const Ogre::String& Plugin::getName() const {
    static const Ogre::String name = "Lixel";
    return name;
}

void Plugin::initialise() {
    mShadowParameters = std::make_unique<ShadowParameters>();
    mPresets = std::make_unique<ShadowCameraSetupManager>();
    mPrograms = std::make_unique<OnDemandPrograms>();
    mSceneManagers = std::make_unique<LixelSceneManagerFactory>();
    Ogre::Root::getSingleton().addSceneManagerFactory(mSceneManagers.get());
    Ogre::Root::getSingleton().addFrameListener(this);
}

void Plugin::shutdown() {
    Ogre::Root::getSingleton().removeFrameListener(this);
    // Destroys the scene managers that it made.
    Ogre::Root::getSingleton().removeSceneManagerFactory(mSceneManagers.get());
    mSceneManagers.reset();
    mPrograms.reset();
    mPresets.reset();
    mShadowParameters.reset();
    // The library may be unloaded next, under scenes that live on.
    detachFromOgre();
}

bool Plugin::frameStarted(const Ogre::FrameEvent&) {
    for (const auto& [name, manager] : Ogre::Root::getSingleton().getSceneManagers()) {
        guardLights(*manager);
        mShadowParameters->serve(*manager);
    }
    return true;
}

} // namespace Lixel

namespace {
std::unique_ptr<Lixel::Plugin> thePlugin;
/// How often OGRE has loaded it: it takes two spellings of a path for two plugins.
unsigned loads = 0;
} // namespace

extern "C" __attribute__((visibility("default"))) void dllStartPlugin() {
    if (loads++ > 0) {
        Lixel::logWarning("Plugin_Lixel is loaded already, maybe by plugins.cfg and by another "
                          "spelling of its path; it stays installed once");
        return;
    }
    thePlugin = std::make_unique<Lixel::Plugin>();
    Ogre::Root::getSingleton().installPlugin(thePlugin.get());
}

extern "C" __attribute__((visibility("default"))) void dllStopPlugin() {
    if (--loads > 0) return;
    Ogre::Root::getSingleton().uninstallPlugin(thePlugin.get());
    thePlugin.reset();
}
