#pragma once

#include "script/PresetSettings.h"

#include <OgreLight.h>

#include <map>
#include <string>
#include <vector>

namespace Lixel {

class ShadowPreset;

/// What uses a preset in a scene.
struct PresetUser {
    ShadowPreset* preset;
    Ogre::Light* light; ///< null for the scene manager
};

/// What all presets of a scene say together.
struct PresetPlan {
    /// Of the scene manager.
    SettingValues settings;
    /// Maps of each light of a type; without types whose lights use no preset, which stay as an
    /// application has set them.
    std::map<Ogre::Light::LightTypes, int> maps;
};

/// @param users the scene manager, if it has a preset, stands first
/// @throws Ogre::InvalidParametersException where two contradict each other, or OGRE reads one map
/// of a light that is to have several
PresetPlan planFor(const std::vector<PresetUser>& users);

/// That of a plan.
Ogre::ShadowTechnique shadowTechniqueOf(const SettingValues& settings);

/// Whether materials draw shadows themselves, without a receiver of the scene manager.
bool isIntegrated(Ogre::ShadowTechnique technique);

} // namespace Lixel
