#include "script/ShadowPreset.h"

#include "scene/NameList.h"
#include "script/PresetUse.h"
#include "setup/CascadesShadowCameraSetup.h"
#include "setup/SetupList.h"

#include <OgreException.h>
#include <OgreLight.h>
#include <OgreSceneManager.h>

#include <algorithm>
#include <vector>

namespace Lixel {
namespace {

/// A setup under construction: of one technique, or cascades and the setup of their slices.
struct Parts {
    const SetupKind* kind;
    const SetupKind* slices; ///< null unless cascades
    std::shared_ptr<FittedShadowCameraSetup> setup;
    std::shared_ptr<FittedShadowCameraSetup> sliceSetup;

    explicit Parts(const SettingValues& settings)
        : kind(findSetupKind(settingOf(settings, "technique"))), slices(nullptr) {
        if (kind->name != "Cascades") {
            setup = kind->create();
            return;
        }
        slices = findSetupKind(settingOf(settings, "slices"));
        sliceSetup = slices->create();
        setup = CascadesShadowCameraSetup::create(sliceSetup);
    }

    bool isOfSlices(const std::string& keyword) const {
        return slices != nullptr && findOption(slices->options, keyword) != nullptr &&
               findOption(kind->options, keyword) == nullptr;
    }

    bool hasOption(const std::string& keyword) const {
        return findOption(kind->options, keyword) != nullptr || isOfSlices(keyword) ||
               findOption(CommonOptions::declared(), keyword) != nullptr;
    }

    /// @return what is wrong; empty where the option was set
    std::string set(const PresetLine& line) const {
        try {
            (isOfSlices(line.keyword) ? sliceSetup : setup)->setParameter(line.keyword, line.value);
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
        for (const Option& option : kind->options)
            names.emplace_back(option.keyword);
        if (slices != nullptr)
            for (const Option& option : slices->options)
                names.emplace_back(option.keyword);
        for (const Option& option : CommonOptions::declared())
            names.emplace_back(option.keyword);
        return joinNames(names);
    }

    std::string name() const {
        std::string text(kind->name);
        if (slices != nullptr) {
            text += " of ";
            text += slices->name;
        }
        return text;
    }
};

} // namespace

ShadowPreset::ShadowPreset(Ogre::ResourceManager* creator, const Ogre::String& name,
                           Ogre::ResourceHandle handle, const Ogre::String& group, bool isManual,
                           Ogre::ManualResourceLoader* loader)
    : Ogre::Resource(creator, name, handle, group, isManual, loader) {}

std::vector<std::pair<PresetLine, std::string>>
ShadowPreset::define(const std::vector<PresetLine>& lines) {
    std::vector<std::pair<PresetLine, std::string>> wrong;
    SettingValues settings;
    std::vector<PresetLine> others;
    for (const PresetLine& line : lines) {
        const PresetSetting* const setting = findPresetSetting(line.keyword);
        if (setting == nullptr) {
            others.push_back(line);
        } else if (const std::optional<std::string> value = setting->read(line.value)) {
            settings[line.keyword] = *value;
        } else {
            wrong.emplace_back(line, line.keyword + ": '" + line.value + "' is not " +
                                         std::string(setting->values));
        }
    }
    if (settings.contains("slices") && settingOf(settings, "technique") != "Cascades") {
        const auto line = std::ranges::find(lines, "slices", &PresetLine::keyword);
        wrong.emplace_back(*line, "slices: only 'technique Cascades' has slices, and this is " +
                                      settingOf(settings, "technique"));
        settings.erase("slices");
    }
    // What they may be is known only now that the technique is.
    std::vector<PresetLine> options;
    const Parts parts(settings);
    for (const PresetLine& line : others) {
        const std::string fault = parts.hasOption(line.keyword)
                                      ? parts.set(line)
                                      : "there is no keyword '" + line.keyword +
                                            "' of a shadow_camera_setup of " + parts.name() +
                                            "; there are: " + parts.keywords();
        if (fault.empty())
            options.push_back(line);
        else
            wrong.emplace_back(line, fault);
    }
    if (mIsDefined && !wrong.empty()) return wrong;
    mIsDefined = true;
    mSettings = settings;
    mOptions = options;
    if (isLoaded()) mSetup = parts.setup;
    return wrong;
}

void ShadowPreset::restore(const ShadowPreset::State& state) {
    mSettings = state.settings;
    mOptions = state.options;
    mSetup = state.setup;
}

void ShadowPreset::loadImpl() {
    const Parts parts(mSettings);
    for (const PresetLine& line : mOptions)
        parts.set(line);
    mSetup = parts.setup;
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
