#pragma once

#include <OgrePrerequisites.h>

namespace Ogre {
class Light;
class SceneManager;
} // namespace Ogre

namespace Lixel {

class ShadowPreset;

/** Gives a preset to a light, or, where `light` is null, to all lights of the scene manager that have no
    setup of their own, and the scene manager what all presets in it say together.

    What uses which preset is written on the light, and on the scene's root node: nothing else
    remembers it.
    @throws as ShadowPreset::applyTo; then nothing was changed
*/
void usePreset(ShadowPreset& preset, Ogre::SceneManager& sceneManager, Ogre::Light* light);

/// Gives all presets of a scene manager again to what uses them, after some were defined anew.
/// @throws as ShadowPreset::applyTo; then nothing was changed
void usePresetsAgain(Ogre::SceneManager& sceneManager);

} // namespace Lixel
