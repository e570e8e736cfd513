#pragma once

#include <OgreMaterial.h>

namespace Lixel::Tests {

/// Lixel/Caster, whose scripts are read on first use.
Ogre::MaterialPtr benchCaster();

} // namespace Lixel::Tests
