#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace Ogre {
class Light;
class SceneManager;
} // namespace Ogre

namespace Lixel {

class LightNews;
struct ShadowTarget;

/** How many maps a light has. OGRE draws more than one right only under integrated techniques.

    The log is told where there are more or fewer than its setup makes use of.
    @param targets shadow textures from the light's first one on; none where nothing is drawn
    @param mapsOfSun how many of so many maps the setup fills for a sun
    @return 0 for a texture that draws all of its layers together */
std::size_t mapCountOf(const Ogre::Light& light, const std::vector<ShadowTarget>& targets,
                       const Ogre::SceneManager& sceneManager,
                       const std::function<std::size_t(std::size_t)>& mapsOfSun, LightNews& news);

} // namespace Lixel
