#pragma once

#include "fit/geometry/Types.h"

namespace Ogre {
class MovableObject;
class SceneManager;
} // namespace Ogre

namespace Lixel {

/** A number that no other object has or will have: what is remembered of a light or a camera is
    remembered by it, since another may come to be at the address, and under the name, of one that
    has gone.

    The object itself carries it, among its user objects, and so it goes with it. A user who clears
    those makes it another object. */
using Identity = std::uint64_t;

LIXEL_API Identity identityOf(const Ogre::MovableObject& object);

/// Takes the numbers off a scene manager's lights and cameras.
LIXEL_API void forgetIdentities(Ogre::SceneManager& sceneManager);

} // namespace Lixel
