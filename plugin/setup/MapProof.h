#pragma once

#include "setup/MapPlan.h"

#include <OgreTexture.h>

#include <cstdint>
#include <vector>

namespace Lixel {

/// A shadow map's texels, as its format stores them.
std::vector<std::uint8_t> readTexels(const Ogre::Texture& texture);

/// Compares what a map kept with what was drawn anew, and logs the first difference of a light.
void proveMap(const Ogre::Texture& texture, const std::vector<std::uint8_t>& kept);

} // namespace Lixel
