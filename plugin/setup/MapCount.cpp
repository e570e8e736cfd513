#include "setup/MapCount.h"

#include "fit/parts/LightPartition.h"
#include "scene/Log.h"
#include "scene/OgreVersions.h"
#include "setup/LightNews.h"

#include <OgreLight.h>
#include <OgreSceneManager.h>

#include <algorithm>

namespace Lixel {
namespace {

/// Whether a light is the only directional light that casts shadows. OGRE counts textures for each
/// type of light, so one of several suns may have more than it needs. Lamps are left out: how many
/// maps they need does not depend on the setup alone.
bool isOnlySun(const Ogre::Light& light, const Ogre::SceneManager& sceneManager) {
    const auto isOther = [&](const Ogre::Light* other) {
        return other != &light && other->getType() == Ogre::Light::LT_DIRECTIONAL &&
               other->getCastShadows();
    };
    return light.getType() == Ogre::Light::LT_DIRECTIONAL &&
           std::ranges::none_of(sceneManager._getLightsAffectingFrustum(), isOther);
}

/// Whether OGRE reads more than one map of a light. @param wanted more than one
bool readsSeveral(const Ogre::Light& light, const Ogre::SceneManager& sceneManager,
                  std::size_t wanted, LightNews& news) {
    if (sceneManager.isShadowTechniqueIntegrated()) return true;
    if (news.isNew(LightNews::NoMapsOfItsOwn))
        logWarning(
            "light '" + light.getName() + "' has " + std::to_string(wanted) +
            " shadow textures, and OGRE uses more than one of a light only under an "
            "integrated shadow technique, such as SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED; it "
            "gets one map");
    return false;
}

} // namespace

std::size_t mapCountOf(const Ogre::Light& light, const std::vector<ShadowTarget>& targets,
                       const Ogre::SceneManager& sceneManager,
                       const std::function<std::size_t(std::size_t)>& mapsOfSun, LightNews& news) {
    if (!targets.empty() && drawsMapsTogether(*targets.front().texture)) {
        if (news.isNew(LightNews::MapsDrawnTogether))
            logWarning("no shadow map for light '" + light.getName() +
                       "': its shadow texture draws all of its layers in one pass "
                       "(TU_TARGET_ALL_LAYERS), and each of Lixel's maps has casters of its own");
        return 0;
    }
    const std::size_t wanted = sceneManager.getShadowTextureCountPerLightType(light.getType());
    const bool isSun = isOnlySun(light, sceneManager);
    if (wanted <= 1) {
        if (isSun && mapsOfSun(2) > 1 && news.isNew(LightNews::OneMapToDivide))
            logWarning("light '" + light.getName() +
                       "' has one shadow texture, and a setup that divides it among several: "
                       "SceneManager::setShadowTextureCountPerLightType gives it more, under an "
                       "integrated shadow technique");
        return 1;
    }
    if (!readsSeveral(light, sceneManager, wanted, news)) return 1;
    const std::size_t left = targets.empty() ? wanted : targets.size();
    if (left < wanted && news.isNew(LightNews::TooFewTextures))
        logWarning("light '" + light.getName() + "' should have " + std::to_string(wanted) +
                   " shadow maps, and there are textures for " + std::to_string(left) +
                   " (SceneManager::setShadowTextureCount)");
    const std::size_t maps =
        std::clamp<std::size_t>(std::min(wanted, left), 1, LightPartition::Capacity);
    if (isSun && mapsOfSun(maps) < maps && news.isNew(LightNews::MapsLeftOver))
        logWarning("light '" + light.getName() + "' has " + std::to_string(maps) +
                   " shadow textures, and its setup fills " + std::to_string(mapsOfSun(maps)) +
                   ": CascadesShadowCameraSetup fills one for each slice of the view; under "
                   "receivers that have split points, such as OGRE's PSSM, give it the same "
                   "(setSplitDepths)");
    return maps;
}

} // namespace Lixel
