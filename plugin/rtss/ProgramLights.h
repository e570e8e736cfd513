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
    lights, and since 14.1 it multiplies each light by an element of the local variable
    lShadowFactor. In 14.0 that is one number, which dims the first light alone.
*/
namespace Lixel {

#if OGRE_VERSION_MAJOR == 14 && !OGRE_MIN_VERSION(14, 1, 0)
#error "libLixelRTSS needs OGRE 14.1 or newer, or 1.12 or 13: set LIXEL_BUILD_RTSS to OFF"
#endif

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

    /// Its index in the list of lights of the object that is about to be drawn; beyond the list's
    /// end where the object has no such light.
    std::size_t lightListIndex(const Ogre::GpuProgramParameters& pixelParameters) const;
};

/// How many lights a render state's programs are made for.
std::size_t lightCountOf(const Ogre::RTShader::RenderState& state);

/// The lights that a pixel program sums up and that can be dimmed one by one.
std::vector<ProgramLight> lightsIn(Ogre::RTShader::Program& pixelProgram,
                                   const Ogre::RTShader::RenderState& state);

/// Why lightsIn finds none, as the end of "a material that ...", with what to do.
std::string whyWithoutLights(const Ogre::RTShader::RenderState& state);

/// Has a pixel program multiply each light by a visibility, which is known at the beginning of it.
void dimLights(Ogre::RTShader::Program& pixelProgram, const std::vector<ProgramLight>& lights,
               const std::vector<Ogre::RTShader::ParameterPtr>& visibilities, std::uint32_t stage);

/// The position in object space that a vertex program goes on with, bent or placed as it may be.
Ogre::RTShader::ParameterPtr objectPositionIn(Ogre::RTShader::Function& vertexMain);

} // namespace Lixel
