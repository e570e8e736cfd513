#include "reload/ProgramSettings.h"

#include "scene/OgreVersions.h"

namespace Lixel {

Ogre::NameValuePairList settingsOf(const Ogre::GpuProgram& program) {
    Ogre::NameValuePairList settings;
    for (const auto& setting : program.getParameters()) {
        const Ogre::String& name = settingName(setting);
        settings[name] = program.getParameter(name);
    }
    return settings;
}

void setSettings(Ogre::GpuProgram& program, const Ogre::NameValuePairList& settings) {
    for (const auto& [name, value] : settings)
        if (program.getParameter(name) != value) program.setParameter(name, value);
}

void loadIfPossible(Ogre::GpuProgram& program) {
    try {
        program.load();
    } catch (const Ogre::Exception&) {
        // It is in the log.
    }
}

} // namespace Lixel
