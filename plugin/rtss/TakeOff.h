#pragma once

#include <OgrePrerequisites.h>

#include <vector>

namespace Ogre::RTShader {
class RenderState;
class ShaderGenerator;
} // namespace Ogre::RTShader

namespace Lixel {

/// Names of all schemes that a generator has.
std::vector<Ogre::String> schemesOf(const Ogre::RTShader::ShaderGenerator& generator);

/// Takes one type of sub-render state out of all schemes and materials, and off all programs, which
/// the generator makes anew when they are next drawn.
void takeOffAllStates(Ogre::RTShader::ShaderGenerator& generator, const Ogre::String& type);

/// Takes one type of sub-render state out of a scheme, or out of a pass. Whether there was any.
bool takeOff(Ogre::RTShader::RenderState& state, const Ogre::String& type);

} // namespace Lixel
