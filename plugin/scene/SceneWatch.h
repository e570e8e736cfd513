#pragma once

#include "fit/geometry/Types.h"

namespace Ogre {
class SceneManager;
} // namespace Ogre

namespace Lixel {

/** Keeps something for scene managers, and has to drop it when one goes: what is made of
    OGRE's classes does not survive OGRE.

    Watchers come and go as they like, even while they are told. */
class LIXEL_API SceneWatcher {
public:
    SceneWatcher();
    virtual ~SceneWatcher();
    SceneWatcher(const SceneWatcher&) = delete;
    SceneWatcher& operator=(const SceneWatcher&) = delete;

    /// The scene manager is being destroyed, or Lixel takes leave of it.
    virtual void sceneGone(Ogre::SceneManager& sceneManager) = 0;
};

/// From now on watchers are told when this one goes. Watching it twice has no effect.
LIXEL_API void watchScene(Ogre::SceneManager& sceneManager);

/// Tells watchers that all scene managers have gone, and watches none.
LIXEL_API void unwatchScenes();

} // namespace Lixel
