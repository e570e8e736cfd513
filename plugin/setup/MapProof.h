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

/// Compares what a map showed with casters in batches with what single draws have drawn.
void proveBatchedMap(const Ogre::Texture& texture, const std::vector<std::uint8_t>& batched);

} // namespace Lixel
