#pragma once

#include "fit/geometry/Types.h"

namespace Ogre {
class SceneManager;
} // namespace Ogre

namespace Lixel {

/** Keeps lights with a NaN or an infinity away from OGRE, which aborts on them.

    OGRE turns a shadow camera towards the light before it asks any ShadowCameraSetup, and that
    asserts on NaN. So the guard checks visible lights before each scene is drawn. Bad is a light
    whose direction or position is not finite, since OGRE 13.6 one whose angle or shadow distance
    is not, and since OGRE 13 one without a node. The guard takes all visibility flags off a bad
    light, which hides it, and logs this (News.h says how often). It restores the flags when the
    light is good again.

    Light::setVisible stays the user's: a light that was hidden or shown while it was guarded is
    hidden or shown afterwards. So are visibility flags set meanwhile (except 0), which
    the guard takes off and keeps for later.

    Guarding a scene manager twice has no effect. The plugin guards all of them before every frame;
    setups guard theirs when they are first used.
*/
LIXEL_API void guardLights(Ogre::SceneManager& sceneManager);

/// Leaves no guard behind in any scene manager. Lights that are still bad stay hidden, and the log
/// says so.
LIXEL_API void unguardLights();

} // namespace Lixel
