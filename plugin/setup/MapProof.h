#pragma once

#include "setup/MapPlan.h"

#include <OgreTexture.h>

#include <cstdint>
#include <vector>

namespace Lixel {

/// A shadow map's texels, as its format stores them.
std::vector<std::uint8_t> readTexels(const Ogre::Texture& texture);

/// Compares what a map kept with what was drawn anew, and logs a difference.
void proveMap(const Ogre::Texture& texture, const std::vector<std::uint8_t>& kept);

/// What saves work while a map is drawn.
struct MapShortcuts {
    /// Casters in batches.
    bool batches = false;
    /// What stands still and what moves apart.
    bool layers = false;

    bool any() const { return batches || layers; }
};

/// Compares what a map showed that was drawn with shortcuts with what single draws have drawn.
void proveMapDrawnBy(const MapShortcuts& shortcuts, const Ogre::Texture& texture,
                     const std::vector<std::uint8_t>& before);

} // namespace Lixel
