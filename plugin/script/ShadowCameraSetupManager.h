#pragma once

#include "script/ShadowPreset.h"

#include <OgreResourceManager.h>

#include <memory>
#include <string>
#include <vector>

namespace Lixel {
/// @addtogroup LixelScripts
/// @{

class PresetTranslator;

/** All `shadow_camera_setup`s of scripts, by name: a resource manager as OGRE's own.

    The plugin makes it, and from then on OGRE parses `.shadow` files and takes shadow_camera_setup
    in `.material` files, when a resource group is initialised. A line that is wrong is OGRE's script
    error, with file, line, and the keywords and values that there are; it is left out, and all
    others count. A `.shadow` file whose structure is wrong is left out as a whole. (OGRE's parser,
    which reads `.material` files, does not survive all that is wrong with them.)
*/
class LIXEL_API ShadowCameraSetupManager : public Ogre::ResourceManager {
public:
    /// Needs an Ogre::Root, and that there is no other one.
    ShadowCameraSetupManager();
    ~ShadowCameraSetupManager() override;

    /// @throws Ogre::InvalidStateException where there is no manager: the plugin is not loaded
    static ShadowCameraSetupManager& getSingleton();

    /// @throws Ogre::ItemIdentityException where there is none of that name, with those that there
    /// are
    static ShadowPresetPtr getByName(const Ogre::String& name,
                                     const Ogre::String& group = Ogre::RGN_AUTODETECT);
    /// Null where there is none.
    static ShadowPresetPtr findByName(const Ogre::String& name,
                                      const Ogre::String& group = Ogre::RGN_AUTODETECT);
    /// All of a group, or of all groups where it is empty, in the order of their names.
    static std::vector<ShadowPresetPtr> list(const Ogre::String& group = "");

    /** Reads the `.shadow` files of a group again, as they are on disk now, and gives what they
        define to all lights and scene managers that use it. A definition with an error stays as it
        was, and so does one that is no longer there; all of them do where two that are used in a scene
        contradict each other.
        @return the errors, a line each, which the log has too
    */
    std::vector<std::string> reload(const Ogre::String& group);

    void parseScript(Ogre::DataStreamPtr& stream, const Ogre::String& group) override;
    /** Has OGRE parse a script, which it may have parsed before: setups in it are defined anew. A
        script whose structure OGRE's parser would not survive is left out.
        @return the errors, a line each, which the log has too
    */
    std::vector<std::string> parseAgain(const std::string& text, const std::string& file,
                                        const Ogre::String& group);

private:
    /// Reads a group's `.shadow` files. @return the errors, a line each
    std::vector<std::string> readGroup(const Ogre::String& group);
    /// Reads one `.shadow` file. @return the errors, a line each
    std::vector<std::string> readScript(Ogre::DataStream& stream, const Ogre::String& group);

    Ogre::Resource* createImpl(const Ogre::String& name, Ogre::ResourceHandle handle,
                               const Ogre::String& group, bool isManual,
                               Ogre::ManualResourceLoader* loader,
                               const Ogre::NameValuePairList* parameters) override;

    std::unique_ptr<PresetTranslator> mTranslator;
};

/// @}
} // namespace Lixel
