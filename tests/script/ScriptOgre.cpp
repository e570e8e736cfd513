#include "ScriptOgre.h"

#include "script/ShadowCameraSetupManager.h"

#include <OgreResourceGroupManager.h>

#include <unistd.h>

#include <fstream>
#include <utility>

namespace Lixel::Tests {

ScriptOgre::ScriptOgre()
    : mFolder(std::filesystem::temp_directory_path() /
              ("lixel-scripts-" + std::to_string(getpid()))) {
    std::filesystem::remove_all(mFolder);
    std::filesystem::create_directories(mFolder);
    // Made before Root, which would else write Ogre.log.
    mLogs = std::make_unique<Ogre::LogManager>();
    mLogs->createLog("", true, false, true)->addListener(this);
    mRoot = std::make_unique<Ogre::Root>("", "", "");
    mManager = std::make_unique<ShadowCameraSetupManager>();
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    groups.createResourceGroup("Scripts", true);
    groups.addResourceLocation(mFolder.string(), "FileSystem", "Scripts");
}

ScriptOgre::~ScriptOgre() {
    mManager.reset();
    mRoot.reset();
    mLogs->getDefaultLog()->removeListener(this);
    std::filesystem::remove_all(mFolder);
}

void ScriptOgre::write(const std::string& file, const std::string& text) const {
    std::ofstream(mFolder / file) << text;
}

void ScriptOgre::initialise() const {
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    // OGRE finds what was there when the folder was added.
    groups.removeResourceLocation(mFolder.string(), "Scripts");
    groups.addResourceLocation(mFolder.string(), "FileSystem", "Scripts");
    groups.clearResourceGroup("Scripts");
    groups.initialiseResourceGroup("Scripts");
}

std::vector<std::string> ScriptOgre::takeErrors() {
    return std::exchange(mErrors, {});
}

void ScriptOgre::messageLogged(const Ogre::String& message, Ogre::LogMessageLevel level, bool,
                               const Ogre::String&, bool&) {
    if (level >= Ogre::LML_CRITICAL) mErrors.push_back(message);
}

ShadowPresetPtr preset(const std::string& name) {
    return ShadowCameraSetupManager::findByName(name);
}

std::string errorsOf(ScriptOgre& ogre, const std::string& script, const std::string& file) {
    ogre.write(file, script);
    ogre.takeErrors();
    ogre.initialise();
    std::string errors;
    for (const std::string& error : ogre.takeErrors())
        errors += error + '\n';
    return errors;
}

} // namespace Lixel::Tests
