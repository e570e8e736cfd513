#pragma once

#include "fit/Types.h"

namespace Ogre {
class SceneManager;
} // namespace Ogre

namespace Lixel {

/** Keeps lights with a NaN or an infinity away from OGRE, which aborts on them.

    OGRE turns a shadow camera towards the light before it asks any ShadowCameraSetup, and that
    asserts on NaN. So before each scene is drawn the guard hides lights whose direction or position
    is not finite, says so once in the log, and shows them again when they are good again.

    Guarding a scene manager twice has no effect. The plugin guards all of them before every frame;
    setups guard theirs when they are first used.
*/
LIXEL_API void guardLights(Ogre::SceneManager& sceneManager);

} // namespace Lixel
