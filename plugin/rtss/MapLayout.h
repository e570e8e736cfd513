#pragma once

#include <array>
#include <cstddef>

namespace Ogre {
class SceneManager;
} // namespace Ogre

namespace Lixel {

/** How many shadow maps programs have to read.

    Programs are made for one layout. A program made for more maps also works, but is slower.
*/
struct MapLayout {
    /// Of each light of a kind, by Ogre::Light::LightTypes.
    std::array<std::size_t, 4> mapsOfType{};
    /// Of all lights: shadow textures. 0 where programs read none.
    std::size_t textures = 0;

    bool operator==(const MapLayout&) const = default;

    /// The most that a light of any kind has.
    std::size_t mostMaps() const;
};

/// Of a scene manager as it is now; empty unless its technique is an integrated one.
MapLayout layoutOf(const Ogre::SceneManager& manager);

/// The least that serves both.
MapLayout joined(const MapLayout& a, const MapLayout& b);

} // namespace Lixel
