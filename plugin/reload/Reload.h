#pragma once

#include "fit/geometry/Types.h"

#include <OgrePrerequisites.h>

#include <string>
#include <vector>

/// Scripts and shaders that are edited on disk while a program runs.
namespace Lixel {
/// @addtogroup LixelScripts
/// @{

/** Reads a resource group's scripts and shaders again, as they are on disk now.

    Setups (`.shadow`), materials and programs (`.material`, `.program`) change in place: lights and
    objects keep what they have, and the next frame is drawn with it. The shaders of programs that
    are in use are read again with all that they include, and OGRE's shader system makes its
    programs of that group's materials anew, and those with Lixel's shadows that include its files.

    What has an error stays as it was: a setup, all materials of a script, a shader. So does what is
    no longer in the files. OGRE does not see files that are new in a location; add the location
    again (ResourceGroupManager::addResourceLocation).

    Call it between two frames.

    @return what is wrong, a line each, which the log has too; empty where all was read
    @throws Ogre::ItemIdentityException where there is no such group
    @throws Ogre::InvalidStateException where there is no Root, or the plugin is not loaded
*/
LIXEL_API std::vector<std::string> reload(const Ogre::String& group);

/// Told of each reload; libLixelRTSS is.
class LIXEL_API ReloadListener {
public:
    virtual ~ReloadListener() = default;
    /// A material is about to lose its techniques.
    virtual void materialChanges(Ogre::Material& material) = 0;
    /// A group's shaders have been read again. What other programs were made of them, whose text is
    /// in no file, is to be made anew.
    /// @return what is wrong, a line each, which the log has too; it stays as it was
    virtual std::vector<std::string> shadersChange(const Ogre::String& group) = 0;
};

/// Registers a listener, once. It must be removed before it is destroyed.
LIXEL_API void addReloadListener(ReloadListener& listener);
LIXEL_API void removeReloadListener(ReloadListener& listener);

/// @}
} // namespace Lixel
