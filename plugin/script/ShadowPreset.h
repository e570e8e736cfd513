#pragma once

#include "script/PresetSettings.h"
#include "setup/FittedShadowCameraSetup.h"

#include <OgreResource.h>

#include <memory>
#include <utility>
#include <vector>

namespace Ogre {
class Light;
class SceneManager;
} // namespace Ogre

namespace Lixel {
/// @addtogroup LixelScripts
/// @{

/// A line of a script: a keyword and its value.
struct PresetLine {
    std::string keyword;
    std::string value;
    std::string file;
    unsigned line = 0;
};

/** What a `shadow_camera_setup` script defines: a setup with its options, and what goes with it:
    the number, size and format of maps, OGRE's shadow technique and the materials.

    ShadowCameraSetupManager has them by name. In one line:

        Lixel::ShadowCameraSetupManager::getByName("Lixel/Sun")->applyTo(*light);

    Map size and format, shadow technique, materials and self-shadowing are the scene manager's in
    OGRE, and the number of maps is that of all lights of a type. So two presets in one scene that
    say different values are an error that names both; what a preset does not say goes with
    whatever another says, and has its standard value where none does. Cascades that do not say how
    many maps they have count as saying three.
*/
class LIXEL_API ShadowPreset : public Ogre::Resource {
public:
    ShadowPreset(Ogre::ResourceManager* creator, const Ogre::String& name,
                 Ogre::ResourceHandle handle, const Ogre::String& group, bool isManual,
                 Ogre::ManualResourceLoader* loader);

    /** Gives the light this preset: it casts shadows, with this setup, and its scene manager has
        what goes with it. It has it again after the script was edited and reloaded.
        @throws Ogre::InvalidParametersException where another preset in this scene says otherwise
        @throws Ogre::ItemIdentityException where there is no material of a name that it says
    */
    void applyTo(Ogre::Light& light);
    /// Gives it to all lights of a scene manager that have no setup of their own.
    /// @throws as for a light
    void applyTo(Ogre::SceneManager& sceneManager);

    /// The setup. The same instance serves all lights.
    const std::shared_ptr<FittedShadowCameraSetup>& getSetup();

    /// A setting's value, as scripts spell it: "3" of "maps". Empty where there is no such keyword.
    Ogre::String getSetting(const Ogre::String& keyword) const;
    /// What the script says of settings, and nothing else.
    const SettingValues& getSettings() const { return mSettings; }

    /** Defines it by lines of a script. Of two with one keyword the later one counts. The first
        definition leaves out lines that are wrong; another one changes nothing where one is wrong.
        @return what is wrong with which line */
    std::vector<std::pair<PresetLine, std::string>> define(const std::vector<PresetLine>& lines);

    /// What a script has said of it, and the setup made of that.
    struct State {
        SettingValues settings;
        std::vector<PresetLine> options;
        std::shared_ptr<FittedShadowCameraSetup> setup;
    };
    State state() const { return {mSettings, mOptions, mSetup}; }
    /// Defines it as it was.
    void restore(const State& state);

protected:
    void loadImpl() override;
    void unloadImpl() override;

private:
    SettingValues mSettings;
    /// Lines of its setup's options, all of them right.
    std::vector<PresetLine> mOptions;
    bool mIsDefined = false;
    std::shared_ptr<FittedShadowCameraSetup> mSetup;
};

using ShadowPresetPtr = std::shared_ptr<ShadowPreset>;

/// @}
} // namespace Lixel
