#pragma once

#include <OgreGpuProgramParams.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Lixel {

/** What is wrong with how a program's parameters are bound to Lixel's, as lines for the log.

    Uniforms whose names begin with `lixel` are recognised by name, as LixelShadow.glsl,
    LixelCaster.glsl and LixelFog.glsl declare them: each has to be bound to its own `light_custom`
    number, or be in a shared set that the parameters refer to. Of uniforms with other names,
    numbers that mean none of Lixel's parameters, but look like one, are found.
*/
std::vector<std::string> findWrongBindings(const Ogre::GpuProgramParameters& parameters);

/// The maps of the smallest of Lixel/ShadowMaps2, Lixel/Surface/Integrated/Maps2 and so on that
/// reads at least so many; of the largest where none does.
std::size_t mapsOfParentFor(std::size_t maps);

} // namespace Lixel
