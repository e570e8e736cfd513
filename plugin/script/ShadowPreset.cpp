#include "script/ShadowPreset.h"

#include "scene/NameList.h"
#include "script/PresetUse.h"
#include "script/PresetWords.h"
#include "setup/CascadesShadowCameraSetup.h"
#include "setup/SetupList.h"

#include <OgreException.h>
#include <OgreLight.h>
#include <OgreSceneManager.h>

#include <optional>
#include <vector>

namespace Lixel {
namespace {

using WrongLines = std::vector<std::pair<PresetLine, std::string>>;

/// Makes a setup: of one technique, or cascades and the setup of their slices.
class SetupBuilder {
public:
    /// Sets the options that are right.
    SetupBuilder(const SettingValues& settings, const std::vector<PresetLine>& options)
        : mKind(findSetupKind(settingOf(settings, "technique"))) {
        if (mKind->name == CascadesWord) {
            mSlices = findSetupKind(settingOf(settings, "slices"));
            mSliceSetup = mSlices->create();
            setup = CascadesShadowCameraSetup::create(mSliceSetup);
        } else {
            setup = mKind->create();
        }
        for (const PresetLine& line : options)
            add(line);
    }

    std::shared_ptr<FittedShadowCameraSetup> setup;
    std::vector<PresetLine> right;
    WrongLines wrong;

private:
    void add(const PresetLine& line) {
        const std::string fault = hasOption(line.keyword)
                                      ? set(line)
                                      : "there is no keyword '" + line.keyword +
                                            "' of a shadow_camera_setup of " + name() +
                                            "; there are: " + keywords();
        if (fault.empty())
            right.push_back(line);
        else
            wrong.emplace_back(line, fault);
    }

    bool isOfSlices(const std::string& keyword) const {
        return mSlices != nullptr && findOption(mSlices->options, keyword) != nullptr &&
               findOption(mKind->options, keyword) == nullptr;
    }

    bool hasOption(const std::string& keyword) const {
        return findOption(mKind->options, keyword) != nullptr || isOfSlices(keyword) ||
               findOption(CommonOptions::declared(), keyword) != nullptr;
    }

    /// @return what is wrong; empty where the option was set
    std::string set(const PresetLine& line) const {
        try {
            (isOfSlices(line.keyword) ? mSliceSetup : setup)
                ->setParameter(line.keyword, line.value);
        } catch (const Ogre::Exception& exception) {
            return exception.getDescription();
        }
        return {};
    }

    /// All keywords that such a setup has.
    std::string keywords() const {
        std::vector<std::string> names;
        for (const PresetSetting& setting : presetSettings())
            names.emplace_back(setting.keyword);
        for (const Option& option : mKind->options)
            names.emplace_back(option.keyword);
        if (mSlices != nullptr)
            for (const Option& option : mSlices->options)
                names.emplace_back(option.keyword);
        for (const Option& option : CommonOptions::declared())
            names.emplace_back(option.keyword);
        return joinNames(names);
    }

    std::string name() const {
        std::string text(mKind->name);
        if (mSlices != nullptr) {
            text += " of ";
            text += mSlices->name;
        }
        return text;
    }

    const SetupKind* mKind;
    const SetupKind* mSlices = nullptr; ///< null unless cascades
    std::shared_ptr<FittedShadowCameraSetup> mSliceSetup;
};

/// Lines sorted into settings, options of the setup, and what is wrong.
struct SortedLines {
    SettingValues settings;
    std::vector<PresetLine> options;
    WrongLines wrong;

    explicit SortedLines(const std::vector<PresetLine>& lines) {
        PresetLine slices;
        for (const PresetLine& line : lines) {
            const PresetSetting* const setting = findPresetSetting(line.keyword);
            if (setting == nullptr) {
                options.push_back(line);
            } else if (const std::optional<std::string> value = setting->read(line.value)) {
                settings[line.keyword] = *value;
                if (line.keyword == "slices") slices = line;
            } else {
                wrong.emplace_back(line, line.keyword + ": '" + line.value + "' is not " +
                                             setting->values);
            }
        }
        if (!settings.contains("slices") || settingOf(settings, "technique") == CascadesWord)
            return;
        wrong.emplace_back(slices, "slices: only 'technique " + std::string(CascadesWord) +
                                       "' has slices, and this is " +
                                       settingOf(settings, "technique"));
        settings.erase("slices");
    }
};

} // namespace

ShadowPreset::ShadowPreset(Ogre::ResourceManager* creator, const Ogre::String& name,
                           Ogre::ResourceHandle handle, const Ogre::String& group, bool isManual,
                           Ogre::ManualResourceLoader* loader)
    : Ogre::Resource(creator, name, handle, group, isManual, loader) {}

std::vector<std::pair<PresetLine, std::string>>
ShadowPreset::define(const std::vector<PresetLine>& lines) {
    auto [settings, options, wrong] = SortedLines(lines);
    // Which options there are is known only now that the technique is.
    const SetupBuilder builder(settings, options);
    wrong.insert(wrong.end(), builder.wrong.begin(), builder.wrong.end());
    if (mIsDefined && !wrong.empty()) return wrong;
    mIsDefined = true;
    mSettings = settings;
    mOptions = builder.right;
    if (isLoaded()) mSetup = builder.setup;
    return wrong;
}

void ShadowPreset::restore(const ShadowPreset::State& state) {
    mSettings = state.settings;
    mOptions = state.options;
    mSetup = state.setup;
    // It may have been loaded since.
    if (isLoaded() && !mSetup) loadImpl();
}

void ShadowPreset::loadImpl() {
    mSetup = SetupBuilder(mSettings, mOptions).setup;
}

void ShadowPreset::unloadImpl() {
    mSetup.reset();
}

const std::shared_ptr<FittedShadowCameraSetup>& ShadowPreset::getSetup() {
    if (!mSetup) load();
    return mSetup;
}

Ogre::String ShadowPreset::getSetting(const Ogre::String& keyword) const {
    return findPresetSetting(keyword) == nullptr ? Ogre::String() : settingOf(mSettings, keyword);
}

void ShadowPreset::applyTo(Ogre::Light& light) {
    Ogre::SceneManager* const sceneManager = light._getManager();
    if (sceneManager == nullptr)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "light: '" + light.getName() + "' belongs to no scene manager",
                    "ShadowPreset::applyTo");
    usePreset(*this, *sceneManager, &light);
}

void ShadowPreset::applyTo(Ogre::SceneManager& sceneManager) {
    usePreset(*this, sceneManager, nullptr);
}

} // namespace Lixel
