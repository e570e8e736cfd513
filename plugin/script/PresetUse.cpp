#include "script/PresetUse.h"

#include "material/ShadowMaterials.h"
#include "scene/NameList.h"
#include "scene/OgreVersions.h"
#include "script/PresetPlan.h"
#include "script/PresetWords.h"
#include "script/ShadowCameraSetupManager.h"
#include "script/ShadowPreset.h"

#include <OgreAny.h>
#include <OgreException.h>
#include <OgreLight.h>
#include <OgreResourceGroupManager.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreShadowCameraSetup.h>
#include <OgreUserObjectBindings.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <typeinfo>
#include <vector>

namespace Lixel {
namespace {

const char* const BindingKey = "Lixel/ShadowPreset";

/// What is written on what uses a preset.
struct Binding {
    std::string preset;
    std::string group;
    /// What it was given. Where it has another by now, an application took the preset off.
    Ogre::ShadowCameraSetupPtr setup;
    /// How far its shadows reached before a preset said so; none while none has.
    std::optional<Ogre::Real> distanceBefore;
};

/// What is bound there now, if anything is.
std::optional<Binding> bindingAt(const Ogre::UserObjectBindings& bindings) {
    const Ogre::Any& any = bindings.getUserAny(BindingKey);
    return any.has_value() ? std::optional(Ogre::any_cast<Binding>(any)) : std::nullopt;
}

Ogre::UserObjectBindings& bindingsOf(Ogre::SceneManager& sceneManager, Ogre::Light* light) {
    return light != nullptr ? light->getUserObjectBindings()
                            : sceneManager.getRootSceneNode()->getUserObjectBindings();
}

const Ogre::ShadowCameraSetupPtr& setupOf(Ogre::SceneManager& sceneManager, Ogre::Light* light) {
    return light != nullptr ? light->getCustomShadowCameraSetup()
                            : sceneManager.getShadowCameraSetup();
}

/// Adds the preset that is bound there, if there still is one of that name.
void addBound(Ogre::SceneManager& sceneManager, Ogre::Light* light,
              std::vector<PresetUser>& users) {
    const std::optional<Binding> binding = bindingAt(bindingsOf(sceneManager, light));
    if (!binding || binding->setup != setupOf(sceneManager, light)) return;
    // OGRE throws where it is asked for a group that is gone.
    if (!Ogre::ResourceGroupManager::getSingleton().resourceGroupExists(binding->group)) return;
    if (const ShadowPresetPtr preset =
            ShadowCameraSetupManager::findByName(binding->preset, binding->group))
        users.push_back({preset.get(), light});
}

/// Who uses which preset in a scene: the scene manager, if it does, stands first.
std::vector<PresetUser> usersIn(Ogre::SceneManager& sceneManager) {
    std::vector<PresetUser> users;
    addBound(sceneManager, nullptr, users);
    for (const auto& [name, object] : sceneManager.getMovableObjects(LightTypeName))
        addBound(sceneManager, static_cast<Ogre::Light*>(object), users);
    return users;
}

/// The receiver that the scene manager is to have; empty for none.
std::string receiverOf(const SettingValues& settings) {
    const std::string said = settingOf(settings, "receiver_material");
    if (!said.empty()) return said == NoMaterialWord ? "" : said;
    const Ogre::ShadowTechnique technique = shadowTechniqueOf(settings);
    if (isIntegrated(technique)) return {};
    std::string name = "Lixel/Receiver";
    if (technique == Ogre::SHADOWTYPE_TEXTURE_MODULATIVE) name += "/Modulative";
    if (settingOf(settings, "filter") == "bilinear") name += "/Bilinear";
    return name;
}

/// Names of the presets that say a setting, for a message.
std::string sayersOf(const std::vector<PresetUser>& users, const std::string& keyword) {
    std::set<std::string> names;
    for (const PresetUser& user : users)
        if (user.preset->getSettings().contains(keyword)) names.insert(user.preset->getName());
    return joinNames(names);
}

/// A scene manager, what uses presets in it, and what these say together.
struct Change {
    Ogre::SceneManager* sceneManager;
    std::vector<PresetUser> users;
    PresetPlan plan;
};

/// @throws Ogre::InvalidParametersException where the presets cannot be used together
Change prepare(Ogre::SceneManager& sceneManager, const std::vector<PresetUser>& users) {
    return {&sceneManager, users, planFor(users)};
}

/// Changes nothing where it throws.
void setMaterials(const Change& change) {
    Ogre::SceneManager& sceneManager = *change.sceneManager;
    const std::string caster = settingOf(change.plan.settings, "caster_material");
    const bool hasCaster = caster != NoMaterialWord;
    try {
        // OGRE always has BaseWhite: Lixel's own materials need not be there.
        setShadowMaterials(sceneManager, receiverOf(change.plan.settings),
                           hasCaster ? caster : "BaseWhite");
    } catch (const Ogre::Exception& exception) {
        const std::string casters = sayersOf(change.users, "caster_material");
        const std::string receivers = sayersOf(change.users, "receiver_material");
        if (casters.empty() && receivers.empty()) throw;
        OGRE_EXCEPT(Ogre::Exception::ERR_ITEM_NOT_FOUND,
                    exception.getDescription() +
                        " (caster_material is said by: " + (casters.empty() ? "nobody" : casters) +
                        "; receiver_material by: " + (receivers.empty() ? "nobody" : receivers) +
                        ")",
                    "ShadowPreset::applyTo");
    }
    if (!hasCaster) sceneManager.setShadowTextureCasterMaterial({});
}

/// OGRE recreates every texture that it is given a config for, so unchanged ones are skipped.
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

/// Whether all lights without a setup of their own have one that is no default of OGRE's.
bool hasSetupForAll(const Ogre::SceneManager& sceneManager) {
    const Ogre::ShadowCameraSetupPtr& setup = sceneManager.getShadowCameraSetup();
    if (!setup) return false;
    const Ogre::ShadowCameraSetup& shared = *setup;
    return typeid(shared) != typeid(Ogre::DefaultShadowCameraSetup);
}

/** How many textures all lights need together; at least a sun's, for a scene whose lights are still
    to come.

    Lights of the application's own that cast shadows count too: OGRE hands textures out in its own
    order. But every light casts shadows unless it is told not to, and there may be hundreds: those
    that have no setup keep textures that are there, and get no new ones. */
std::size_t texturesFor(const Change& change) {
    Ogre::SceneManager& sceneManager = *change.sceneManager;
    const bool isForAll = change.users.front().light == nullptr || hasSetupForAll(sceneManager);
    std::size_t needed = 0, wanted = 0;
    for (const auto& [name, object] : sceneManager.getMovableObjects(LightTypeName)) {
        const auto* const light = static_cast<const Ogre::Light*>(object);
        const bool isUser =
            std::ranges::find(change.users, light, &PresetUser::light) != change.users.end();
        if (!isUser && !light->getCastShadows()) continue;
        const std::size_t maps = sceneManager.getShadowTextureCountPerLightType(light->getType());
        wanted += maps;
        if (isUser || isForAll || light->getCustomShadowCameraSetup()) needed += maps;
    }
    const std::size_t present = sceneManager.getShadowTextureConfigList().size();
    return std::max({needed, std::min(present, wanted),
                     sceneManager.getShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL)});
}

/// A light's is its scene manager's until it has one of its own, which 0 is not.
void setFarDistance(const PresetUser& user, Ogre::SceneManager& sceneManager,
                    Ogre::Real wsDistance) {
    if (user.light == nullptr)
        sceneManager.setShadowFarDistance(wsDistance);
    else if (wsDistance < 0)
        user.light->resetShadowFarDistance();
    else
        user.light->setShadowFarDistance(wsDistance);
}

/// Negative where a light has none of its own.
Ogre::Real farDistanceOf(const PresetUser& user, const Ogre::SceneManager& sceneManager) {
    if (user.light == nullptr) return sceneManager.getShadowFarDistance();
    const Ogre::Real distance = user.light->getShadowFarDistance();
    return distance == sceneManager.getShadowFarDistance() ? -1 : distance;
}

void giveTo(const PresetUser& user, Ogre::SceneManager& sceneManager) {
    const Ogre::ShadowCameraSetupPtr setup = user.preset->getSetup();
    if (user.light == nullptr)
        sceneManager.setShadowCameraSetup(setup);
    else
        user.light->setCustomShadowCameraSetup(setup);
    Ogre::UserObjectBindings& bindings = bindingsOf(sceneManager, user.light);
    Binding binding{user.preset->getName(), user.preset->getGroup(), setup, {}};
    if (const std::optional<Binding> before = bindingAt(bindings))
        binding.distanceBefore = before->distanceBefore;
    const std::string distance = settingOf(user.preset->getSettings(), "far_distance");
    if (!distance.empty()) {
        if (!binding.distanceBefore) binding.distanceBefore = farDistanceOf(user, sceneManager);
        float wsDistance = 0.0F;
        // Whatever the locale's decimal point is.
        std::from_chars(distance.data(), distance.data() + distance.size(), wsDistance);
        setFarDistance(user, sceneManager, wsDistance);
    } else if (binding.distanceBefore) {
        setFarDistance(user, sceneManager, *binding.distanceBefore);
        binding.distanceBefore.reset();
    }
    bindings.setUserAny(BindingKey, Ogre::Any(binding));
}

/// All but the materials.
void carryOut(const Change& change) {
    Ogre::SceneManager& sceneManager = *change.sceneManager;
    const SettingValues& settings = change.plan.settings;
    const Ogre::ShadowTechnique technique = shadowTechniqueOf(settings);
    if (sceneManager.getShadowTechnique() != technique) sceneManager.setShadowTechnique(technique);
    sceneManager.setShadowTextureSelfShadow(settingOf(settings, "self_shadow") == "true");
    for (const auto& [type, maps] : change.plan.maps)
        sceneManager.setShadowTextureCountPerLightType(type, static_cast<std::size_t>(maps));
    setTextures(sceneManager, texturesFor(change), settings);
    for (const PresetUser& user : change.users)
        giveTo(user, sceneManager);
}

} // namespace

void usePreset(ShadowPreset& preset, Ogre::SceneManager& sceneManager, Ogre::Light* light) {
    std::vector<PresetUser> users = usersIn(sceneManager);
    std::erase_if(users, [&](const PresetUser& user) { return user.light == light; });
    users.insert(light == nullptr ? users.begin() : users.end(), PresetUser{&preset, light});
    const Change change = prepare(sceneManager, users);
    setMaterials(change);
    carryOut(change);
    // Not in useAllPresetsAgain: an application may have switched its shadows off meanwhile.
    if (light != nullptr) light->setCastShadows(true);
}

std::string useAllPresetsAgain() {
    std::vector<Change> changes;
    const Ogre::SceneManager* current = nullptr;
    try {
        for (const auto& [name, sceneManager] : Ogre::Root::getSingleton().getSceneManagers()) {
            current = sceneManager;
            const std::vector<PresetUser> users = usersIn(*sceneManager);
            if (!users.empty()) changes.push_back(prepare(*sceneManager, users));
        }
        for (const Change& change : changes) {
            current = change.sceneManager;
            setMaterials(change);
        }
    } catch (const Ogre::Exception& exception) {
        return "in scene manager '" + current->getName() + "', " + exception.getDescription();
    }
    for (const Change& change : changes)
        carryOut(change);
    return {};
}

} // namespace Lixel
