#pragma once

#include <OgreLight.h>
#include <OgrePrerequisites.h>
#include <RTShaderSystem/OgreShaderFFPRenderState.h>
#include <RTShaderSystem/OgreShaderPrerequisites.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace Ogre {
class GpuProgramParameters;
class Pass;
} // namespace Ogre

/** The lights in programs that OGRE's shader system makes, and how each is dimmed.

    All that differs between OGRE's versions is in this file and its source:
    before 14 a program has uniforms for each light, sorted by its kind, and which of an object's
    lights they are is found for each object. Since 14 it has arrays in the order of the object's
    lights, and multiplies each light by an element of the local variable lShadowFactor.
*/
namespace Lixel {

#if OGRE_VERSION_MAJOR >= 14
/// Where among the parts of a program the lights are dimmed: before they are summed up.
inline constexpr int DimmingOrder = Ogre::RTShader::FFP_LIGHTING - 1;
#else
/// Where among the parts of a program the lights are dimmed: once the calls that sum them up are
/// there to be changed.
inline constexpr int DimmingOrder = Ogre::RTShader::FFP_LIGHTING + 1;
#endif

/// One of the lights that a pixel program sums up.
struct ProgramLight {
    /// Of the program's lights.
    std::size_t index = 0;
    /// None where it may be of any kind.
    std::optional<Ogre::Light::LightTypes> type;
    /// Uniforms with its colours, and the first one's name in the program.
    std::vector<Ogre::RTShader::UniformParameterPtr> colours;
    std::string colourName;

    /// Where it is in the list of lights of the object that is about to be drawn; beyond its end
    /// where the object has no such light.
    std::size_t placeIn(const Ogre::GpuProgramParameters& pixelParameters) const;
};

/// How many lights a render state's programs are made for.
std::size_t lightCountOf(const Ogre::RTShader::RenderState& state);

/// The lights that a pixel program sums up; none where they are summed up per vertex.
std::vector<ProgramLight> lightsIn(Ogre::RTShader::Program& pixelProgram,
                                   const Ogre::RTShader::RenderState& state);

/// Has a pixel program multiply each light by a visibility, which is known at the beginning of it.
void dimLights(Ogre::RTShader::Program& pixelProgram, const std::vector<ProgramLight>& lights,
               const std::vector<Ogre::RTShader::ParameterPtr>& visibilities, std::uint32_t stage);

/// The position in object space that a vertex program goes on with, bent or placed as it may be.
Ogre::RTShader::ParameterPtr objectPositionIn(Ogre::RTShader::Function& vertexMain);

} // namespace Lixel
