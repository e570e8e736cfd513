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
    @param receiver name of the receiver material; empty for none. Integrated shadow techniques use
    none. Whether it fits the technique (additive or modulative) is checked when it is drawn, since
    the technique may be set later; a mismatch is logged
    @throws Ogre::ItemIdentityException where there is no material of a name, with those that there
    are
*/
LIXEL_API void setShadowMaterials(Ogre::SceneManager& sceneManager,
                                  const Ogre::String& receiver = "",
                                  const Ogre::String& caster = "Lixel/Caster");

/// @}
} // namespace Lixel
