#pragma once

#include "rtss/ProgramLights.h"

#include <RTShaderSystem/OgreShaderFunction.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/** The calls of LixelShaderSystem.glsl in a program of the shader system.

    Each program calls addReceiver once, then addVisibility for each of its lights.
*/
namespace Lixel {

/// The source that generated programs include, without its ending.
inline constexpr const char* ReceiverSource = "LixelShaderSystem";

/// Of pixel programs: before anything else, where the flow does not diverge.
inline constexpr std::uint32_t VisibilityStage = Ogre::RTShader::FFP_PS_PRE_PROCESS + 10;

/// What a program has for one light.
struct LightUniforms {
    ProgramLight light;
    /// Uniforms bound to the light's custom parameters.
    struct Custom {
        Ogre::RTShader::UniformParameterPtr uniform;
        std::size_t parameter;
    };
    std::vector<Custom> customs;
    /// Null where the program reads no map of the light.
    Ogre::RTShader::UniformParameterPtr firstUnit;
    /// Light-list index that `customs` currently refer to.
    std::size_t lightListIndex = 0;

    /// Sets them for the object that is about to be drawn. Only where there is a firstUnit.
    /// @param index the light's index in the object's list
    /// @param unit the shadow unit that has the light's first map; negative: none has it
    void bind(std::size_t index, int unit);
};

/// What is shared by the calls of one program's making.
struct ProgramBuild {
    Ogre::RTShader::Program& vertex;
    Ogre::RTShader::Program& pixel;
    /// Samplers of the texture units that hold shadow maps, in their order.
    std::vector<Ogre::RTShader::ParameterPtr> maps;
    /// The receiver's position in the world, and its screen derivatives.
    Ogre::RTShader::ParameterPtr ws, dx, dy;

    Ogre::RTShader::Function& main() const;
    Ogre::RTShader::FunctionStageRef stage() const;
    /// Variables of the pixel program, by their names without a prefix.
    Ogre::RTShader::ParameterPtr vec4(const char* name) const;
    Ogre::RTShader::ParameterPtr number(const std::string& name) const;
};

/// Hands the position in the world to the pixel program, which takes its derivatives.
/// @param first the first of `count` texture units that hold shadow maps
void addReceiver(ProgramBuild& build, std::size_t first, std::size_t count);

/// @param maps how many of the light's maps the program reads, from the first on; may be 0
/// @return the variable that holds how much of the light there is
Ogre::RTShader::ParameterPtr addVisibility(ProgramBuild& build, LightUniforms& uniforms,
                                           std::size_t maps);

} // namespace Lixel
