#include "script/PresetUse.h"

#include "material/ShadowMaterials.h"
#include "scene/NameList.h"
#include "scene/OgreVersions.h"
#include "script/ShadowCameraSetupManager.h"
#include "script/ShadowPreset.h"

#include <OgreAny.h>
#include <OgreException.h>
#include <OgreLight.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreUserObjectBindings.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace Lixel {
namespace {

const char* const BindingKey = "Lixel/ShadowPreset";

struct Use {
    ShadowPreset* preset;
    Ogre::Light* light; ///< null for the scene manager
};

/// What is written on what uses a preset.
struct Binding {
    std::string preset;
    /// What it was given. Where it has another by now, an application took the preset off.
    Ogre::ShadowCameraSetupPtr setup;
};

Ogre::UserObjectBindings& bindingsOf(Ogre::SceneManager& sceneManager, Ogre::Light* light) {
    return light != nullptr ? light->getUserObjectBindings()
                            : sceneManager.getRootSceneNode()->getUserObjectBindings();
}

const Ogre::ShadowCameraSetupPtr& setupOf(Ogre::SceneManager& sceneManager, Ogre::Light* light) {
    return light != nullptr ? light->getCustomShadowCameraSetup()
                            : sceneManager.getShadowCameraSetup();
}

/// Adds the preset that is bound there, if there still is one of that name.
void addBound(Ogre::SceneManager& sceneManager, Ogre::Light* light, std::vector<Use>& uses) {
    const Ogre::Any& any = bindingsOf(sceneManager, light).getUserAny(BindingKey);
    if (!any.has_value()) return;
    const auto binding = Ogre::any_cast<Binding>(any);
    if (binding.setup != setupOf(sceneManager, light)) return;
    if (const ShadowPresetPtr preset = ShadowCameraSetupManager::findByName(binding.preset))
        uses.push_back({preset.get(), light});
}

/// Who uses which preset in a scene: the scene manager, if it does, stands first.
std::vector<Use> usesIn(Ogre::SceneManager& sceneManager) {
    std::vector<Use> uses;
    addBound(sceneManager, nullptr, uses);
    for (const auto& [name, object] : sceneManager.getMovableObjects(LightTypeName))
        addBound(sceneManager, static_cast<Ogre::Light*>(object), uses);
    return uses;
}

constexpr std::array LightTypes{Ogre::Light::LT_POINT, Ogre::Light::LT_DIRECTIONAL,
                                Ogre::Light::LT_SPOTLIGHT};

/// Whether a setting is the whole scene manager's in OGRE.
bool isOfScene(const std::string& keyword) {
    return keyword != "technique" && keyword != "slices" && keyword != "maps" &&
           keyword != "far_distance";
}

int mapsOf(const ShadowPreset& preset) {
    const std::string maps = settingOf(preset.getSettings(), "maps");
    if (!maps.empty()) return std::stoi(maps);
    return settingOf(preset.getSettings(), "technique") == "Cascades" ? 3 : 1;
}

bool isForType(const Use& use, Ogre::Light::LightTypes type) {
    return use.light == nullptr || use.light->getType() == type;
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
SettingValues settingsOfScene(const std::vector<Use>& uses) {
    SettingValues together;
    std::map<std::string, const ShadowPreset*> sayers;
    for (const Use& use : uses)
        for (const auto& [keyword, value] : use.preset->getSettings()) {
            if (!isOfScene(keyword)) continue;
            const auto [said, isNew] = together.emplace(keyword, value);
            if (isNew)
                sayers[keyword] = use.preset;
            else if (said->second != value)
                refuse(keyword, *sayers[keyword], said->second, *use.preset, value);
        }
    return together;
}

/// How many maps each light of a type has.
int mapsOfType(const std::vector<Use>& uses, Ogre::Light::LightTypes type) {
    const Use* first = nullptr;
    for (const Use& use : uses) {
        if (!isForType(use, type)) continue;
        // What a light says counts for it, not what is said for all that say nothing.
        if (first != nullptr && first->light == nullptr) first = nullptr;
        if (first == nullptr) {
            first = &use;
        } else if (mapsOf(*first->preset) != mapsOf(*use.preset)) {
            refuse("maps", *first->preset, std::to_string(mapsOf(*first->preset)), *use.preset,
                   std::to_string(mapsOf(*use.preset)));
        }
    }
    return first == nullptr ? 1 : mapsOf(*first->preset);
}

Ogre::ShadowTechnique techniqueNamed(const std::string& name) {
    if (name == "texture_additive") return Ogre::SHADOWTYPE_TEXTURE_ADDITIVE;
    if (name == "texture_modulative") return Ogre::SHADOWTYPE_TEXTURE_MODULATIVE;
    if (name == "texture_modulative_integrated")
        return Ogre::SHADOWTYPE_TEXTURE_MODULATIVE_INTEGRATED;
    return Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED;
}

bool isIntegrated(const std::string& technique) {
    return technique.ends_with("_integrated");
}

/// The receiver that the scene manager is to have; empty for none.
std::string receiverOf(const SettingValues& settings) {
    const std::string technique = settingOf(settings, "shadow_technique");
    const std::string said = settingOf(settings, "receiver_material");
    if (!said.empty()) return said == "none" ? "" : said;
    if (isIntegrated(technique)) return {};
    std::string name = "Lixel/Receiver";
    if (technique == "texture_modulative") name += "/Modulative";
    if (settingOf(settings, "filter") == "bilinear") name += "/Bilinear";
    return name;
}

/// Names of the presets that say a setting, for a message.
std::string sayersOf(const std::vector<Use>& uses, const std::string& keyword) {
    std::set<std::string> names;
    for (const Use& use : uses)
        if (use.preset->getSettings().contains(keyword)) names.insert(use.preset->getName());
    return joinNames(names);
}

void setMaterials(Ogre::SceneManager& sceneManager, const SettingValues& settings,
                  const std::vector<Use>& uses) {
    const std::string caster = settingOf(settings, "caster_material");
    try {
        setShadowMaterials(sceneManager, receiverOf(settings),
                           caster == "none" ? "Lixel/Caster" : caster);
    } catch (const Ogre::Exception& exception) {
        const std::string casters = sayersOf(uses, "caster_material");
        const std::string receivers = sayersOf(uses, "receiver_material");
        if (casters.empty() && receivers.empty()) throw;
        OGRE_EXCEPT(Ogre::Exception::ERR_ITEM_NOT_FOUND,
                    exception.getDescription() +
                        " (caster_material is said by: " + (casters.empty() ? "nobody" : casters) +
                        "; receiver_material by: " + (receivers.empty() ? "nobody" : receivers) +
                        ")",
                    "ShadowPreset::applyTo");
    }
    if (caster == "none") sceneManager.setShadowTextureCasterMaterial({});
}

/// Leaves textures alone that are as they should be: OGRE makes those anew that it is told of.
void setTextures(Ogre::SceneManager& sceneManager, std::size_t count,
                 const SettingValues& settings) {
    const std::string size = settingOf(settings, "map_size");
    const auto width = static_cast<unsigned short>(std::stoi(size));
    const auto height = static_cast<unsigned short>(std::stoi(size.substr(size.find(' '))));
    const Ogre::PixelFormat format =
        Ogre::PixelUtil::getFormatFromName(settingOf(settings, "map_format"));
    sceneManager.setShadowTextureCount(count);
    for (std::size_t i = 0; i < count; ++i) {
        Ogre::ShadowTextureConfig texture = sceneManager.getShadowTextureConfigList()[i];
        if (texture.width == width && texture.height == height && texture.format == format)
            continue;
        texture.width = width;
        texture.height = height;
        texture.format = format;
        sceneManager.setShadowTextureConfig(i, texture);
    }
}

/// How many maps the lights that use presets have together; at least one sun's, for a scene whose
/// lights are still to come.
std::size_t mapsOfLights(Ogre::SceneManager& sceneManager, const std::vector<Use>& uses) {
    const bool hasSceneWide = !uses.empty() && uses.front().light == nullptr;
    std::size_t count = 0;
    for (const auto& [name, object] : sceneManager.getMovableObjects(LightTypeName)) {
        const auto* const light = static_cast<const Ogre::Light*>(object);
        const bool takesFromScene =
            hasSceneWide && light->getCastShadows() && !light->getCustomShadowCameraSetup();
        if (takesFromScene || std::ranges::find(uses, light, &Use::light) != uses.end())
            count += sceneManager.getShadowTextureCountPerLightType(light->getType());
    }
    return std::max<std::size_t>(
        count, sceneManager.getShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL));
}

void giveTo(const Use& use, Ogre::SceneManager& sceneManager) {
    const std::string distance = settingOf(use.preset->getSettings(), "far_distance");
    const Ogre::ShadowCameraSetupPtr setup = use.preset->getSetup();
    if (use.light == nullptr) {
        sceneManager.setShadowCameraSetup(setup);
        if (!distance.empty()) sceneManager.setShadowFarDistance(std::stof(distance));
    } else {
        use.light->setCustomShadowCameraSetup(setup);
        if (!distance.empty()) use.light->setShadowFarDistance(std::stof(distance));
    }
    bindingsOf(sceneManager, use.light)
        .setUserAny(BindingKey, Ogre::Any(Binding{use.preset->getName(), setup}));
}

/// Throws where a light is to have several maps, and OGRE reads one.
void checkMaps(const std::vector<Use>& uses, const std::string& technique) {
    for (const Use& use : uses)
        if (use.light != nullptr && mapsOf(*use.preset) > 1 && !isIntegrated(technique))
            OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                        "maps: OGRE reads several maps of a light only under an integrated "
                        "shadow_technique, and this is " +
                            technique + "; '" + use.preset->getName() + "' has " +
                            std::to_string(mapsOf(*use.preset)) +
                            (use.preset->getSettings().contains("maps")
                                 ? ""
                                 : ", as Cascades have where they do not say maps"),
                        "ShadowPreset::applyTo");
}

/// Throws before anything is changed.
void give(const std::vector<Use>& uses, Ogre::SceneManager& sceneManager) {
    const SettingValues settings = settingsOfScene(uses);
    const std::string technique = settingOf(settings, "shadow_technique");
    std::map<Ogre::Light::LightTypes, int> maps;
    for (const Ogre::Light::LightTypes type : LightTypes)
        maps[type] = mapsOfType(uses, type);
    checkMaps(uses, technique);
    setMaterials(sceneManager, settings, uses);
    if (sceneManager.getShadowTechnique() != techniqueNamed(technique))
        sceneManager.setShadowTechnique(techniqueNamed(technique));
    sceneManager.setShadowTextureSelfShadow(settingOf(settings, "self_shadow") == "true");
    for (const Ogre::Light::LightTypes type : LightTypes)
        sceneManager.setShadowTextureCountPerLightType(type, static_cast<std::size_t>(maps[type]));
    setTextures(sceneManager, mapsOfLights(sceneManager, uses), settings);
    for (const Use& use : uses)
        giveTo(use, sceneManager);
}

} // namespace

void usePreset(ShadowPreset& preset, Ogre::SceneManager& sceneManager, Ogre::Light* light) {
    std::vector<Use> uses = usesIn(sceneManager);
    std::erase_if(uses, [&](const Use& use) { return use.light == light; });
    uses.insert(light == nullptr ? uses.begin() : uses.end(), Use{&preset, light});
    give(uses, sceneManager);
    // Not in usePresetsAgain: an application may have switched its shadows off meanwhile.
    if (light != nullptr) light->setCastShadows(true);
}

void usePresetsAgain(Ogre::SceneManager& sceneManager) {
    const std::vector<Use> uses = usesIn(sceneManager);
    if (!uses.empty()) give(uses, sceneManager);
}

} // namespace Lixel
