#include "material/NoMapsCheck.h"

#include "material/MapReads.h"
#include "material/MaterialCheck.h"
#include "material/QueuedPasses.h"
#include "scene/Log.h"
#include "scene/OgreVersions.h"
#include "setup/FittedShadowCameraSetup.h"
#include "setup/ObservedShadowCameraSetup.h"

#include <OgreLight.h>
#include <OgreSceneManager.h>
#include <OgreViewport.h>

#include <algorithm>
#include <string>

namespace Lixel {
namespace {

bool hasLixelsSetup(const Ogre::Light& light, const Ogre::SceneManager& manager) {
    const Ogre::ShadowCameraSetupPtr& own = light.getCustomShadowCameraSetup();
    const Ogre::ShadowCameraSetup* const setup =
        own ? own.get() : manager.getShadowCameraSetup().get();
    return dynamic_cast<const FittedShadowCameraSetup*>(setup) != nullptr ||
           dynamic_cast<const ObservedShadowCameraSetup*>(setup) != nullptr;
}

} // namespace

void NoMapsCheck::checkQueue(const Ogre::Viewport& viewport) {
    if (!mManager.isShadowTechniqueTextureBased() || !viewport.getShadowsEnabled()) return;
    const unsigned views = mViews++;
    if (views >= MaterialCheck::FirstLooks &&
        (views - MaterialCheck::FirstLooks) % MaterialCheck::Interval == 0)
        check();
}

void NoMapsCheck::check() {
    const bool hasTextures = !mManager.getShadowTextureConfigList().empty();
    if (hasTextures ? mSaidNoSetup : mSaidNoTextures) return;
    const Ogre::LightList& lights = mManager._getLightsAffectingFrustum();
    const auto casts = [](const Ogre::Light* light) { return light->getCastShadows(); };
    const auto hasSetup = [this](const Ogre::Light* light) {
        return light->getCastShadows() && hasLixelsSetup(*light, mManager);
    };
    const auto hasTexturesOfItsType = [this](const Ogre::Light* light) {
        return light->getCastShadows() &&
               mManager.getShadowTextureCountPerLightType(light->getType()) > 0;
    };
    if (std::none_of(lights.begin(), lights.end(), casts) || !drawsLixelsMaterials()) return;
    const std::string name = "'" + mManager.getName() + "'";
    if (!hasTextures) {
        mSaidNoTextures = true;
        logWarning(
            "scene manager " + name +
            " has no shadow textures, so no light casts shadows there: "
            "SceneManager::setShadowTextureSettings(1024, 1, PF_FLOAT32_R), with one for each "
            "light");
    } else if (std::none_of(lights.begin(), lights.end(), hasTexturesOfItsType)) {
        mSaidNoSetup = true;
        logWarning("scene manager " + name +
                   " has no shadow textures for lights of the types that cast shadows there: "
                   "SceneManager::setShadowTextureCountPerLightType");
    } else if (std::none_of(lights.begin(), lights.end(), hasSetup)) {
        mSaidNoSetup = true;
        logWarning(
            "materials of Lixel are drawn in scene manager " + name +
            ", but no light that casts shadows has a setup of Lixel's, so nothing there is in "
            "shadow: give Light::setCustomShadowCameraSetup or "
            "SceneManager::setShadowCameraSetup one, such as XPSMShadowCameraSetup::create(), or "
            "put the setup there is inside an ObservedShadowCameraSetup");
    }
}

bool NoMapsCheck::drawsLixelsMaterials() const {
    const Ogre::Pass* const caster = shadowCasterPassOf(mManager);
    return (caster != nullptr && writesCasterDepth(*caster)) || drawsLixelsReceivers(mManager);
}

} // namespace Lixel
