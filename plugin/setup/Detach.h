#pragma once

#include "fit/geometry/Types.h"

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/** Takes off all that setups and guards have hung into OGRE: listeners of scene managers and shadow
    textures, and marks on lights and cameras. Afterwards OGRE calls nothing of Lixel's that it is
    not handed anew.

    For when the library is about to be unloaded while scenes live: the plugin calls it when it
    shuts down. Setups that are used afterwards work, begin without memory, and hang themselves in
    again.
*/
LIXEL_API void detachFromOgre();

/// @}
} // namespace Lixel
