#pragma once

#include "script/ShadowPreset.h"

#include <OgreLog.h>
#include <OgreLogManager.h>
#include <OgreRoot.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace Lixel {
class ShadowCameraSetupManager;
}

namespace Lixel::Tests {

/// OGRE without a render system, with a manager of presets, and a resource group "Scripts" that is
/// a new folder.
class ScriptOgre : Ogre::LogListener {
public:
    ScriptOgre();
    ~ScriptOgre() override;

    /// Writes a file into the folder.
    void write(const std::string& file, const std::string& text) const;
    /// Has OGRE read all files, as an application does; what they defined before is gone.
    void initialise() const;
    /// What was logged as an error since the last call.
    std::vector<std::string> takeErrors();

private:
    void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel level, bool maskDebug,
                       const Ogre::String& logName, bool& skipThisMessage) override;

    std::filesystem::path mFolder;
    std::vector<std::string> mErrors;
    std::unique_ptr<Ogre::LogManager> mLogs;
    std::unique_ptr<Ogre::Root> mRoot;
    std::unique_ptr<ShadowCameraSetupManager> mManager;
};

/// The preset of that name; null where there is none.
ShadowPresetPtr preset(const std::string& name);

/// Writes one file and has all of them read. @return what was logged as errors, a line each
std::string errorsOf(ScriptOgre& ogre, const std::string& script,
                     const std::string& file = "my.shadow");

} // namespace Lixel::Tests
