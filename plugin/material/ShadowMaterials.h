#pragma once

#include "fit/geometry/Types.h"

#include <OgrePrerequisites.h>

namespace Ogre {
class SceneManager;
} // namespace Ogre

namespace Lixel {
/// @addtogroup LixelMaterials
/// @{

/** Sets a scene manager's shadow caster and receiver material by their names.

    The same as SceneManager::setShadowTextureCasterMaterial and setShadowTextureReceiverMaterial
    with MaterialManager::getByName, which gives a null material for a wrong name: OGRE takes that
    for no material, and ends in an exception about another.

    @param sceneManager whose materials are set
    @param receiver empty for none: integrated shadow techniques take none, and leave it out. Which
    of additive and modulative ones it goes with is known when it is drawn, since the technique may
    be set later: the log says then if it is the other
    @throws Ogre::ItemIdentityException where there is no material of a name, with those that there
    are
*/
LIXEL_API void setShadowMaterials(Ogre::SceneManager& sceneManager,
                                  const Ogre::String& receiver = "",
                                  const Ogre::String& caster = "Lixel/Caster");

/// @}
} // namespace Lixel
