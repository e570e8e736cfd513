#include "rtss/ProgramLights.h"

#include <OgreGpuProgramParams.h>
#include <RTShaderSystem/OgreShaderFunction.h>
#include <RTShaderSystem/OgreShaderFunctionAtom.h>
#include <RTShaderSystem/OgreShaderParameter.h>
#include <RTShaderSystem/OgreShaderProgram.h>
#include <RTShaderSystem/OgreShaderRenderState.h>

#include <algorithm>
#include <map>

namespace Lixel {

using namespace Ogre::RTShader;
using Ogre::GpuProgramParameters;

std::string whyWithoutLights(const RenderState& state) {
    const bool isMetalRoughness =
        std::ranges::any_of(state.getSubRenderStates(), [](const SubRenderState* part) {
            return part->getType() == "CookTorranceLighting"; // in no public header of OGRE's
        });
    if (isMetalRoughness)
        return "is lit by `lighting_stage metal_roughness`, which shadows no light of its own "
               "before OGRE 14.1: take that, or another lighting_stage";
    return "is lit per vertex: say `lighting_stage per_pixel` in its rtshader_system, in place of "
           "`ffp`";
}

#if OGRE_VERSION_MAJOR >= 14

std::size_t ProgramLight::lightListIndex(const GpuProgramParameters&) const {
    return index;
}

std::size_t lightCountOf(const RenderState& state) {
    return static_cast<std::size_t>(std::max(state.getLightCount(), 0));
}

std::vector<ProgramLight> lightsIn(Program&, const RenderState& state) {
    if (state.getSubRenderState(SRS_PER_VERTEX_LIGHTING) != nullptr) return {};
    std::vector<ProgramLight> lights(lightCountOf(state));
    for (std::size_t i = 0; i < lights.size(); ++i)
        lights[i].index = i;
    return lights;
}

void dimLights(Program& pixelProgram, const std::vector<ProgramLight>& lights,
               const std::vector<ParameterPtr>& visibilities, std::uint32_t stage) {
    if (lights.empty()) return;
    Function& main = *pixelProgram.getMain();
    const ParameterPtr factors =
        main.resolveLocalParameter(Ogre::GCT_FLOAT1, "lShadowFactor", lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i)
        main.getStage(stage).assign(
            {In(visibilities[i]), Out(factors), At(static_cast<int>(lights[i].index))});
    pixelProgram.addPreprocessorDefines("SHADOWLIGHT_COUNT=" + std::to_string(lights.size()));
}

ParameterPtr objectPositionIn(Function& vertexMain) {
    const ParameterPtr local = vertexMain.getLocalParameter(Parameter::SPC_POSITION_OBJECT_SPACE);
    return local ? local : vertexMain.resolveInputParameter(Parameter::SPC_POSITION_OBJECT_SPACE);
}

#else

namespace {

bool isColourOfLight(GpuProgramParameters::AutoConstantType type) {
    return type == GpuProgramParameters::ACT_DERIVED_LIGHT_DIFFUSE_COLOUR ||
           type == GpuProgramParameters::ACT_DERIVED_LIGHT_SPECULAR_COLOUR ||
           type == GpuProgramParameters::ACT_LIGHT_DIFFUSE_COLOUR_POWER_SCALED ||
           type == GpuProgramParameters::ACT_LIGHT_SPECULAR_COLOUR_POWER_SCALED;
}

/// Lamps fade with their distance, and spots towards their edge besides.
Ogre::Light::LightTypes typeOf(std::size_t light, Program& pixelProgram) {
    bool fades = false;
    for (const UniformParameterPtr& uniform : pixelProgram.getParameters()) {
        if (!uniform->isAutoConstantIntParameter() || uniform->getAutoConstantIntData() != light)
            continue;
        if (uniform->getAutoConstantType() == GpuProgramParameters::ACT_SPOTLIGHT_PARAMS)
            return Ogre::Light::LT_SPOTLIGHT;
        fades |= uniform->getAutoConstantType() == GpuProgramParameters::ACT_LIGHT_ATTENUATION;
    }
    return fades ? Ogre::Light::LT_POINT : Ogre::Light::LT_DIRECTIONAL;
}

/// Has all calls take one parameter in place of another.
void substitute(Function& main, const ParameterPtr& old, const ParameterPtr& replacement) {
    for (FunctionAtom* call : main.getAtomInstances())
        for (Operand& operand : call->getOperandList())
            if (operand.getParameter() == old)
                operand = Operand(replacement, operand.getSemantic(), operand.getMask(),
                                  operand.getIndirectionLevel());
}

} // namespace

std::size_t ProgramLight::lightListIndex(const GpuProgramParameters& pixelParameters) const {
    // OGRE's own part of the program has just set it, for this object.
    const auto* const bound = pixelParameters.findAutoConstantEntry(colourName);
    return bound != nullptr ? bound->data : index;
}

std::size_t lightCountOf(const RenderState& state) {
    const Ogre::Vector3i& count = state.getLightCount();
    return static_cast<std::size_t>(count[0] + count[1] + count[2]);
}

std::vector<ProgramLight> lightsIn(Program& pixelProgram, const RenderState&) {
    std::map<std::size_t, ProgramLight> lights;
    for (const UniformParameterPtr& uniform : pixelProgram.getParameters()) {
        if (!uniform->isAutoConstantIntParameter() ||
            !isColourOfLight(uniform->getAutoConstantType()))
            continue;
        ProgramLight& light = lights[uniform->getAutoConstantIntData()];
        light.index = uniform->getAutoConstantIntData();
        light.colours.push_back(uniform);
        light.colourName = light.colours.front()->getName();
    }
    std::vector<ProgramLight> sorted;
    for (auto& [index, light] : lights) {
        light.type = typeOf(index, pixelProgram);
        sorted.push_back(std::move(light));
    }
    return sorted;
}

void dimLights(Program& pixelProgram, const std::vector<ProgramLight>& lights,
               const std::vector<ParameterPtr>& visibilities, std::uint32_t stage) {
    Function& main = *pixelProgram.getMain();
    for (std::size_t i = 0; i < lights.size(); ++i)
        for (const UniformParameterPtr& colour : lights[i].colours) {
            // Not the uniform itself: one that is written to is no longer sent anew for objects
            // with other lights.
            const ParameterPtr dimmed =
                main.resolveLocalParameter(Ogre::GCT_FLOAT4, "lixel_" + colour->getName());
            substitute(main, colour, dimmed);
            main.getStage(stage).mul(In(colour), In(visibilities[i]), Out(dimmed));
        }
}

ParameterPtr objectPositionIn(Function& vertexMain) {
    return vertexMain.resolveInputParameter(Parameter::SPC_POSITION_OBJECT_SPACE);
}

#endif

} // namespace Lixel
