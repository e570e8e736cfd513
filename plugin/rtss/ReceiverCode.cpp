#include "rtss/ReceiverCode.h"

#include <Lixel/material/ShadowParameters.h>

#include <OgreGpuProgramParams.h>
#include <RTShaderSystem/OgreShaderParameter.h>
#include <RTShaderSystem/OgreShaderProgram.h>

#include <array>
#include <utility>

namespace Lixel {

using namespace Ogre::RTShader;
using Ogre::GpuProgramParameters;

namespace {

/// OGRE's own; their macros are in no public header since 14.
const char* const TransformLibrary = "FFPLib_Transform";
const char* const TransformFunction = "FFP_Transform";

/// Of vertex programs: after positions are bent and placed.
constexpr std::uint32_t PositionStage = FFP_VS_TRANSFORM + 50;

/// What this library hands from vertex to pixel programs, and nothing else does.
constexpr auto WorldPosition =
    static_cast<Parameter::Content>(Parameter::SPC_CUSTOM_CONTENT_BEGIN + 76);

/// A map's custom parameters of its light, in the order in which programs take them.
constexpr std::array MapParameters{LP_MAP_ROW_U,     LP_MAP_ROW_V,     LP_MAP_ROW_W,
                                   LP_MAP_ROW_DEPTH, LP_MAP_SIZE_BIAS, LP_MAP_ROW_SHARE};

/// As `light_custom` takes it: the parameter's index, and the light's in the list.
std::uint32_t customNumber(std::size_t parameter, std::size_t lightListIndex) {
    return static_cast<std::uint32_t>(parameter << 16U | lightListIndex);
}

/// Variables with the map that serves.
struct ServingMap {
    explicit ServingMap(const ProgramBuild& build)
        : rows{build.vec4("u"), build.vec4("v"), build.vec4("w"), build.vec4("depth")},
          size(build.vec4("size")),
          greatest(build.number("greatest")),
          index(build.number("serving")) {}

    std::array<ParameterPtr, 4> rows;
    ParameterPtr size;
    /// The greatest of the maps' functions, and which map has it.
    ParameterPtr greatest, index;
};

/// Of a light's maps, the one whose function is greatest.
void addChoice(ProgramBuild& build, LightUniforms& uniforms, std::size_t maps,
               const ServingMap& serving) {
    for (std::size_t map = 0; map < maps; ++map) {
        std::vector<Operand> operands{In(build.ws)};
        if (map > 0) operands.push_back(In(static_cast<float>(map)));
        for (const LightParameter first : MapParameters) {
            const std::size_t parameter = first + LP_MAP_STEP * map;
            uniforms.customs.push_back(
                {build.pixel.resolveParameter(GpuProgramParameters::ACT_LIGHT_CUSTOM,
                                              customNumber(parameter, uniforms.lightListIndex)),
                 parameter});
            operands.push_back(In(uniforms.customs.back().uniform));
        }
        // They are written by the first map, and kept or written by the others.
        const auto semantic = map == 0 ? Operand::OPS_OUT : Operand::OPS_INOUT;
        for (const ParameterPtr& row : serving.rows)
            operands.emplace_back(row, semantic);
        for (const ParameterPtr& part : {serving.size, serving.greatest, serving.index})
            operands.emplace_back(part, semantic);
        build.stage().callFunction(map == 0 ? "Lixel_FirstMap" : "Lixel_NextMap", operands);
    }
}

/// What the map that serves shows, whichever texture unit holds it.
void addReading(ProgramBuild& build, const LightUniforms& uniforms, const ServingMap& serving,
                const ParameterPtr& visibility) {
    const std::array coordinates{build.vec4("coordinate"), build.vec4("coordinateDx"),
                                 build.vec4("coordinateDy")};
    const ParameterPtr unit = build.number("unit");
    std::vector<Operand> operands{In(build.ws), In(build.dx), In(build.dy)};
    for (const ParameterPtr& row : serving.rows)
        operands.push_back(In(row));
    operands.push_back(In(uniforms.firstUnit));
    operands.push_back(In(serving.index));
    for (const ParameterPtr& coordinate : coordinates)
        operands.push_back(Out(coordinate));
    operands.push_back(Out(unit));
    operands.push_back(Out(visibility));
    build.stage().callFunction("Lixel_Coordinates", operands);
    for (std::size_t i = 0; i < build.maps.size(); ++i) {
        operands = {In(build.maps[i]), In(static_cast<float>(i)), In(unit), In(serving.size)};
        for (const ParameterPtr& coordinate : coordinates)
            operands.push_back(In(coordinate));
        operands.emplace_back(visibility, Operand::OPS_INOUT);
        build.stage().callFunction("Lixel_Read", operands);
    }
}

} // namespace

void LightUniforms::bind(std::size_t index, int unit) {
    if (index != std::exchange(lightListIndex, index))
        for (const Custom& custom : customs)
            custom.uniform->updateExtraInfo(customNumber(custom.parameter, index));
    firstUnit->setGpuParameter(static_cast<Ogre::Real>(unit));
}

Function& ProgramBuild::main() const {
    return *pixel.getMain();
}

FunctionStageRef ProgramBuild::stage() const {
    return main().getStage(VisibilityStage);
}

ParameterPtr ProgramBuild::vec4(const char* name) const {
    return main().resolveLocalParameter(Ogre::GCT_FLOAT4, std::string("lixel_") + name);
}

ParameterPtr ProgramBuild::number(const std::string& name) const {
    return main().resolveLocalParameter(Ogre::GCT_FLOAT1, "lixel_" + name);
}

void addReceiver(ProgramBuild& build, std::size_t first, std::size_t count) {
    build.pixel.addDependency(ReceiverSource);
    for (std::size_t unit = first; unit < first + count; ++unit)
        build.maps.push_back(
            build.pixel.resolveParameter(Ogre::GCT_SAMPLER2D, "lixelMap", static_cast<int>(unit)));
    Function& vertexMain = *build.vertex.getMain();
    const ParameterPtr out = vertexMain.resolveOutputParameter(WorldPosition, Ogre::GCT_FLOAT3);
    build.vertex.addDependency(TransformLibrary);
    vertexMain.getStage(PositionStage)
        .callFunction(TransformFunction,
                      In(build.vertex.resolveParameter(GpuProgramParameters::ACT_WORLD_MATRIX)),
                      In(objectPositionIn(vertexMain)), Out(out));
    const ParameterPtr in = build.main().resolveInputParameter(out);
    build.ws = build.vec4("ws");
    build.dx = build.vec4("dx");
    build.dy = build.vec4("dy");
    build.stage().callFunction("Lixel_Receiver",
                               {In(in), Out(build.ws), Out(build.dx), Out(build.dy)});
}

ParameterPtr addVisibility(ProgramBuild& build, LightUniforms& uniforms, std::size_t maps) {
    const ParameterPtr visibility =
        build.number("visibility" + std::to_string(uniforms.light.index));
    if (maps == 0) {
        build.stage().assign(In(1.0F), Out(visibility));
        return visibility;
    }
    const ServingMap serving(build);
    addChoice(build, uniforms, maps, serving);
    // Sent for each object: objects that share a pass may have other lights.
    uniforms.firstUnit = build.pixel.resolveParameter(
        Ogre::GCT_FLOAT1, -1, Ogre::GPV_PER_OBJECT | Ogre::GPV_LIGHTS, "lixelFirstUnit");
    addReading(build, uniforms, serving, visibility);
    return visibility;
}

} // namespace Lixel
