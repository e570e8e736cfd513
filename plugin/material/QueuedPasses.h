#pragma once

#include <functional>

namespace Ogre {
class Pass;
class SceneManager;
class Technique;
} // namespace Ogre

namespace Lixel {

/// Calls `visit` once for each pass of solid objects that a scene manager is about to draw, and
/// says whether its queue group receives shadows.
void forQueuedPasses(Ogre::SceneManager& manager,
                     const std::function<void(const Ogre::Pass& pass, bool groupReceives)>& visit);

/// Calls `visit` once for each technique that a scene manager is about to draw, transparent ones too.
void forQueuedTechniques(Ogre::SceneManager& manager,
                         const std::function<void(Ogre::Technique& technique)>& visit);

/// Whether anything that a scene manager is about to draw reads Lixel's maps: by its own programs,
/// or by the shadow receiver material of its technique or of the scene manager.
bool drawsLixelsReceivers(Ogre::SceneManager& manager);

} // namespace Lixel
