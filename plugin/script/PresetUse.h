#pragma once

#include <OgrePrerequisites.h>

#include <string>

namespace Ogre {
class Light;
class SceneManager;
} // namespace Ogre

namespace Lixel {

class ShadowPreset;

/** Gives a preset to a light, or, where `light` is null, to all lights of the scene manager that
    have no setup of their own. Then configures the scene manager from all of its presets.

    What uses which preset is written on the light, and on the scene's root node: nothing else
    remembers it.
    @throws as ShadowPreset::applyTo; then nothing was changed
*/
void usePreset(ShadowPreset& preset, Ogre::SceneManager& sceneManager, Ogre::Light* light);

/** Gives all presets of all scene managers again to what uses them, after some were defined anew.
    All are checked before anything is changed.
    @return empty, or which scene manager refuses, and why: then some scene managers may have other
    shadow materials, and nothing else was changed
*/
std::string useAllPresetsAgain();

} // namespace Lixel
