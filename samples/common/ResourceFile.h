#pragma once

#include <OgreConfigFile.h>
#include <OgreResourceGroupManager.h>

#include <string>

namespace Lixel::Samples {

/// Adds what a resources.cfg lists, "[group]" sections of "type=path", where `isWanted` is true of
/// the section's name.
template <typename IsWanted>
void addResources(const std::string& file, const IsWanted& isWanted) {
    Ogre::ConfigFile config;
    config.load(file);
    for (const auto& [section, settings] : config.getSettingsBySection()) {
        const std::string group = section.empty() ? "General" : section;
        if (!isWanted(group)) continue;
        for (const auto& [type, path] : settings)
            Ogre::ResourceGroupManager::getSingleton().addResourceLocation(path, type, group);
    }
}

} // namespace Lixel::Samples
