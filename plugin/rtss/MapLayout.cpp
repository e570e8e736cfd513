#include "rtss/MapLayout.h"

#include <OgreLight.h>
#include <OgreSceneManager.h>

#include <algorithm>

namespace Lixel {

std::size_t MapLayout::mostMaps() const {
    return *std::max_element(mapsOfType.begin(), mapsOfType.end());
}

MapLayout layoutOf(const Ogre::SceneManager& manager) {
    MapLayout layout;
    if (!manager.isShadowTechniqueTextureBased() || !manager.isShadowTechniqueIntegrated())
        return layout;
    layout.textures = manager.getShadowTextureConfigList().size();
    for (const auto type :
         {Ogre::Light::LT_DIRECTIONAL, Ogre::Light::LT_POINT, Ogre::Light::LT_SPOTLIGHT})
        layout.mapsOfType[type] =
            std::min(manager.getShadowTextureCountPerLightType(type), layout.textures);
    return layout;
}

MapLayout joined(const MapLayout& a, const MapLayout& b) {
    MapLayout both;
    both.textures = std::max(a.textures, b.textures);
    for (std::size_t type = 0; type < both.mapsOfType.size(); ++type)
        both.mapsOfType[type] = std::max(a.mapsOfType[type], b.mapsOfType[type]);
    return both;
}

} // namespace Lixel
