#pragma once

#include "fit/geometry/Types.h"

namespace Ogre {
class MovableObject;
class SceneManager;
} // namespace Ogre

namespace Lixel {

/** A number that is unique to a light or camera; no later object gets it again.

    Memories of lights and cameras are keyed by it, since a new object may have the address and the
    name of a destroyed one. The number is kept among the object's user objects. A user who clears
    those makes it count as a new object. */
using Identity = std::uint64_t;

LIXEL_API Identity identityOf(const Ogre::MovableObject& object);

/// Takes the numbers off a scene manager's lights and cameras.
LIXEL_API void forgetIdentities(Ogre::SceneManager& sceneManager);

} // namespace Lixel
