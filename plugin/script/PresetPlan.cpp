#include "script/PresetPlan.h"

#include "script/PresetWords.h"
#include "script/ShadowPreset.h"

#include <OgreException.h>

#include <algorithm>
#include <array>
#include <optional>

namespace Lixel {
namespace {

constexpr std::array LightTypes{Ogre::Light::LT_POINT, Ogre::Light::LT_DIRECTIONAL,
                                Ogre::Light::LT_SPOTLIGHT};

/// Whether a setting is the whole scene manager's in OGRE.
bool isOfScene(const std::string& keyword) {
    return keyword != "technique" && keyword != "slices" && keyword != "maps" &&
           keyword != "far_distance";
}

[[noreturn]] void refuse(const std::string& keyword, const ShadowPreset& one, const std::string& of,
                         const ShadowPreset& other, const std::string& than) {
    OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                keyword + ": '" + one.getName() + "' says " + of + " and '" + other.getName() +
                    "', which is used in the same scene, says " + than + "; OGRE has one for " +
                    (keyword == "maps" ? "all lights of a type" : "all of a scene manager"),
                "ShadowPreset::applyTo");
}

/// What all presets say of the scene manager together.
SettingValues settingsOfScene(const std::vector<PresetUser>& users) {
    SettingValues together;
    std::map<std::string, const ShadowPreset*> sayers;
    for (const PresetUser& user : users)
        for (const auto& [keyword, value] : user.preset->getSettings()) {
            if (!isOfScene(keyword)) continue;
            const auto [said, isNew] = together.emplace(keyword, value);
            if (isNew)
                sayers[keyword] = user.preset;
            else if (said->second != value)
                refuse(keyword, *sayers[keyword], said->second, *user.preset, value);
        }
    return together;
}

/// How many maps a preset asks for; none where any number will do: what a light has no use for is
/// not drawn.
std::optional<int> mapsSaidBy(const ShadowPreset& preset) {
    const std::string maps = settingOf(preset.getSettings(), "maps");
    if (!maps.empty()) return std::stoi(maps);
    if (settingOf(preset.getSettings(), "technique") == CascadesWord) return 3;
    return std::nullopt;
}

struct PlannedMaps {
    bool hasUsers = false;
    int count = 1;
    const PresetUser* sayer = nullptr; ///< null where no preset says it
};

/// How many maps each light of a type has.
PlannedMaps mapsOfType(const std::vector<PresetUser>& users, Ogre::Light::LightTypes type) {
    PlannedMaps planned;
    for (const PresetUser& user : users) {
        if (user.light != nullptr && user.light->getType() != type) continue;
        planned.hasUsers = true;
        const std::optional<int> said = mapsSaidBy(*user.preset);
        if (!said) continue;
        // A light's preset overrides the scene-wide one.
        const bool isFirst = planned.sayer == nullptr || planned.sayer->light == nullptr;
        if (!isFirst && planned.count != *said)
            refuse("maps", *planned.sayer->preset, std::to_string(planned.count), *user.preset,
                   std::to_string(*said));
        if (isFirst) planned = {true, *said, &user};
    }
    return planned;
}

/// Throws where a light is to have several maps, and OGRE reads one.
void checkMaps(const PlannedMaps& maps, const SettingValues& settings) {
    if (maps.count == 1 || isIntegrated(shadowTechniqueOf(settings))) return;
    const ShadowPreset& preset = *maps.sayer->preset;
    OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                "maps: OGRE reads several maps of a light only under an integrated "
                "shadow_technique, and this is " +
                    settingOf(settings, "shadow_technique") + "; '" + preset.getName() + "' has " +
                    std::to_string(maps.count) +
                    (preset.getSettings().contains("maps")
                         ? ""
                         : ", as Cascades have where they do not say maps"),
                "ShadowPreset::applyTo");
}

} // namespace

PresetPlan planFor(const std::vector<PresetUser>& users) {
    PresetPlan plan{.settings = settingsOfScene(users), .maps = {}};
    std::vector<PlannedMaps> all;
    for (const Ogre::Light::LightTypes type : LightTypes) {
        all.push_back(mapsOfType(users, type));
        if (all.back().hasUsers) plan.maps[type] = all.back().count;
    }
    for (const PlannedMaps& maps : all)
        checkMaps(maps, plan.settings);
    return plan;
}

Ogre::ShadowTechnique shadowTechniqueOf(const SettingValues& settings) {
    const std::string name = settingOf(settings, "shadow_technique");
    return std::ranges::find(ShadowTechniqueWords, name, &ShadowTechniqueWord::name)->technique;
}

bool isIntegrated(Ogre::ShadowTechnique technique) {
    return (technique & Ogre::SHADOWDETAILTYPE_INTEGRATED) != 0;
}

} // namespace Lixel
