// What OGRE loads and unloads.

#include "cg/CgPlugin.h"

#include <OgreLogManager.h>
#include <OgreRoot.h>

#include <memory>

namespace {
std::unique_ptr<Lixel::Cg::CgPlugin> thePlugin;
/// How often OGRE has loaded it: it takes two spellings of a path for two plugins.
unsigned theLoads = 0;
} // namespace

extern "C" __attribute__((visibility("default"))) void dllStartPlugin() {
    if (theLoads++ > 0) {
        Ogre::LogManager::getSingleton().logWarning("Plugin_LixelCg is loaded already");
        return;
    }
    thePlugin = std::make_unique<Lixel::Cg::CgPlugin>();
    Ogre::Root::getSingleton().installPlugin(thePlugin.get());
}

extern "C" __attribute__((visibility("default"))) void dllStopPlugin() {
    if (--theLoads > 0) return;
    Ogre::Root::getSingleton().uninstallPlugin(thePlugin.get());
    thePlugin.reset();
}
