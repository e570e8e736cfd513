#include "rtss/ShadowState.h"

#include "rtss/PlacedCasters.h"
#include "rtss/Registry.h"

#include <Lixel/material/ShadowParameters.h>

#include <OgreMaterial.h>
#include <OgrePass.h>
#include <OgreRenderSystem.h>
#include <OgreRenderSystemCapabilities.h>
#include <OgreResourceGroupManager.h>
#include <OgreRoot.h>
#include <OgreTechnique.h>
#include <OgreTextureUnitState.h>
#include <RTShaderSystem/OgreShaderFunction.h>
#include <RTShaderSystem/OgreShaderGenerator.h>
#include <RTShaderSystem/OgreShaderParameter.h>
#include <RTShaderSystem/OgreShaderProgram.h>
#include <RTShaderSystem/OgreShaderProgramSet.h>
#include <RTShaderSystem/OgreShaderRenderState.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace Lixel {

using namespace Ogre::RTShader;
using Ogre::GpuProgramParameters;

const Ogre::String ShadowState::Type = "Lixel_Shadows";

namespace {

/// The source that generated programs include, without its ending.
const char* const Source = "LixelShaderSystem";

/// OGRE's own; their macros are in no public header since 14.
const char* const TransformLibrary = "FFPLib_Transform";
const char* const TransformFunction = "FFP_Transform";

/// Of pixel programs: before anything else, where the flow does not diverge.
constexpr std::uint32_t VisibilityStage = FFP_PS_PRE_PROCESS + 10;
/// Of vertex programs: after positions are bent and placed.
constexpr std::uint32_t PositionStage = FFP_VS_TRANSFORM + 50;

/// What this library hands from vertex to pixel programs, and nothing else does.
constexpr auto WorldPosition =
    static_cast<Parameter::Content>(Parameter::SPC_CUSTOM_CONTENT_BEGIN + 76);

/// A map's custom parameters of its light, in the order in which programs take them.
constexpr std::array MapParameters{LP_MAP_ROW_U,     LP_MAP_ROW_V,     LP_MAP_ROW_W,
                                   LP_MAP_ROW_DEPTH, LP_MAP_SIZE_BIAS, LP_MAP_ROW_SHARE};

/// As `light_custom` takes it: the parameter's index, and the light's place in the list.
std::uint32_t customNumber(std::size_t parameter, std::size_t place) {
    return static_cast<std::uint32_t>(parameter << 16U | place);
}

/// Why no program of the shader system can be shadowed here; empty where some can.
std::string whatKeepsFromShadowing() {
    constexpr std::uint16_t LeastVersion = 330;
    const Ogre::RenderSystem& system = *Ogre::Root::getSingleton().getRenderSystem();
    if (ShaderGenerator::getSingleton().getTargetLanguage() != "glsl" ||
        system.getNativeShadingLanguageVersion() < LeastVersion)
        return "its programs are not GLSL " + std::to_string(LeastVersion) +
               " or newer; take the GL3Plus render system";
    const std::string file = std::string(Source) + ".glsl";
    if (!Ogre::ResourceGroupManager::getSingleton().resourceExistsInAnyGroup(file))
        return "there is no " + file +
               "; add Lixel's folder materials/programs/glsl to the resource group General";
    // Whoever does that also tells lights where their maps are.
    if (!tellsCastersTheirDepth())
        return "Plugin_Lixel was not loaded before resource groups were initialised";
    return {};
}

std::size_t greatestUnits() {
    const std::size_t units =
        Ogre::Root::getSingleton().getRenderSystem()->getCapabilities()->getNumTextureUnits();
    return std::min<std::size_t>(units, OGRE_MAX_TEXTURE_LAYERS);
}

} // namespace

/// What is shared by the calls of one program's making.
struct ShadowState::Generation {
    Program& vertex;
    Program& pixel;
    std::vector<ParameterPtr> units;
    ParameterPtr ws, dx, dy;

    Function& main() const { return *pixel.getMain(); }
    FunctionStageRef stage() const { return main().getStage(VisibilityStage); }
    ParameterPtr vec4(const char* name) const {
        return main().resolveLocalParameter(Ogre::GCT_FLOAT4, std::string("lixel_") + name);
    }
    ParameterPtr number(const std::string& name) const {
        return main().resolveLocalParameter(Ogre::GCT_FLOAT1, "lixel_" + name);
    }
};

void ShadowState::copyFrom(const SubRenderState& other) {
    mOptions = static_cast<const ShadowState&>(other).mOptions;
}

bool ShadowState::setParameter(const Ogre::String& name, const Ogre::String& value) {
    if (name != "maps") return false;
    if (value == "auto") {
        mOptions.maps = 0;
        return true;
    }
    if (value.size() != 1 || value[0] < '1' ||
        value[0] > '0' + static_cast<int>(ShaderSystem::MaxMaps))
        return false;
    mOptions.maps = static_cast<std::size_t>(value[0] - '0');
    return true;
}

std::string ShadowState::materialName() const {
    return "'" + mPass->getParent()->getParent()->getName() + "'";
}

bool ShadowState::preAddToRenderState(const RenderState* renderState, Ogre::Pass* source,
                                      Ogre::Pass* destination) {
    mTarget = renderState;
    mPass = destination;
    Ogre::SceneManager* const manager = ShaderGenerator::getSingleton().getActiveSceneManager();
    if (manager != nullptr) mRegistry.scenes().of(*manager);
    mLayout = mRegistry.scenes().layout();
    mRegistry.noteProgram(destination->getParent()->getSchemeName());
    if (mLayout.textures > 0) {
        mReceives = canReceive(*renderState, *source);
        return true;
    }
    if (manager != nullptr && manager->isShadowTechniqueTextureBased() &&
        !manager->isShadowTechniqueIntegrated())
        mRegistry.sayOnce(
            "the shader system's materials are shadowed by Lixel's maps only under an integrated "
            "shadow technique, and that of scene manager '" +
            manager->getName() +
            "' is another: setShadowTechnique(SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED)");
    return false;
}

bool ShadowState::canReceive(const RenderState& renderState, const Ogre::Pass& source) {
    if (!source.getLightingEnabled() || !source.getParent()->getParent()->getReceiveShadows() ||
        lightCountOf(renderState) == 0)
        return false;
    if (const std::string reason = whatKeepsFromShadowing(); !reason.empty()) {
        mRegistry.sayOnce("the shader system's materials are not shadowed by Lixel's maps: " +
                          reason);
        return false;
    }
    if (source.getIteratePerLight()) {
        mUnsaid = "nothing casts shadows on material " + materialName() +
                  ", which has a pass that is drawn once for each light: take its `iteration` out; "
                  "the shader system lights a pass by all lights at once";
        return false;
    }
    return true;
}

/// What is bent or placed by its vertex program casts the shadow of that.
void ShadowState::giveCaster(Program& vertexProgram) {
    Ogre::Technique& technique = *mPass->getParent();
    if (technique.getShadowCasterMaterial()) return;
    if (const Ogre::MaterialPtr caster = casterFor(placingOf(vertexProgram)))
        technique.setShadowCasterMaterial(caster);
}

std::size_t ShadowState::mapsOf(const ProgramLight& light) const {
    const std::size_t all = light.type ? mLayout.mapsOfType[*light.type] : mLayout.mostMaps();
    return std::min(all, mOptions.maps == 0 ? ShaderSystem::MaxMaps : mOptions.maps);
}

/// @return how many of the pass's units hold shadow maps; they are its last
std::size_t ShadowState::addUnits() {
    const std::size_t used = mPass->getNumTextureUnitStates();
    const std::size_t free = greatestUnits() - std::min(used, greatestUnits());
    const std::size_t units = std::min(mLayout.textures, free);
    if (units < mLayout.textures)
        mUnsaid = "material " + materialName() + " has " + std::to_string(used) +
                  " textures, which leaves units for " + std::to_string(units) + " of " +
                  std::to_string(mLayout.textures) +
                  " shadow maps: what only the others show in shadow is lit. Give lights "
                  "fewer maps (SceneManager::setShadowTextureCountPerLightType), or the "
                  "material fewer textures";
    for (std::size_t i = 0; i < units; ++i) {
        Ogre::TextureUnitState& unit = *mPass->createTextureUnitState();
        unit.setContentType(Ogre::TextureUnitState::CONTENT_SHADOW);
        unit.setTextureAddressingMode(Ogre::TextureUnitState::TAM_CLAMP);
        unit.setTextureFiltering(Ogre::TFO_NONE);
    }
    return units;
}

bool ShadowState::createCpuSubPrograms(ProgramSet* programs) {
    Generation generation{*programs->getCpuProgram(Ogre::GPT_VERTEX_PROGRAM),
                          *programs->getCpuProgram(Ogre::GPT_FRAGMENT_PROGRAM),
                          {},
                          {},
                          {},
                          {}};
    giveCaster(generation.vertex);
    if (!mReceives) return true;
    const std::vector<ProgramLight> lights = lightsIn(generation.pixel, *mTarget);
    if (lights.empty()) {
        mUnsaid = "nothing casts shadows on material " + materialName() +
                  ", which is lit per vertex: say `lighting_stage per_pixel` in its "
                  "rtshader_system, in place of `ffp`";
        return true;
    }
    const std::size_t units = addUnits();
    if (units == 0) return true;
    const std::size_t first = mPass->getNumTextureUnitStates() - units;
    for (std::size_t i = 0; i < units; ++i)
        generation.units.push_back(generation.pixel.resolveParameter(
            Ogre::GCT_SAMPLER2D, "lixelMap", static_cast<int>(first + i)));
    generation.pixel.addDependency(Source);
    generation.pixel.addPreprocessorDefines("LIXEL_UNITS=" + std::to_string(units));
    addReceiver(generation);
    std::vector<ParameterPtr> visibilities;
    for (const ProgramLight& light : lights) {
        Slot& slot = mSlots.emplace_back();
        slot.light = light;
        slot.place = light.index;
        visibilities.push_back(addVisibility(generation, slot));
    }
    dimLights(generation.pixel, lights, visibilities, VisibilityStage);
    return true;
}

/// Hands the position in the world to the pixel program, which takes its derivatives.
void ShadowState::addReceiver(Generation& generation) {
    Function& vertexMain = *generation.vertex.getMain();
    const ParameterPtr out = vertexMain.resolveOutputParameter(WorldPosition, Ogre::GCT_FLOAT3);
    generation.vertex.addDependency(TransformLibrary);
    vertexMain.getStage(PositionStage)
        .callFunction(
            TransformFunction,
            In(generation.vertex.resolveParameter(GpuProgramParameters::ACT_WORLD_MATRIX)),
            In(objectPositionIn(vertexMain)), Out(out));
    const ParameterPtr in = generation.main().resolveInputParameter(out);
    generation.ws = generation.vec4("ws");
    generation.dx = generation.vec4("dx");
    generation.dy = generation.vec4("dy");
    generation.stage().callFunction(
        "Lixel_Receiver", {In(in), Out(generation.ws), Out(generation.dx), Out(generation.dy)});
}

/// @return the variable that holds how much of the light there is
ParameterPtr ShadowState::addVisibility(Generation& generation, Slot& slot) {
    const ParameterPtr visibility =
        generation.number("visibility" + std::to_string(slot.light.index));
    const std::size_t maps = mapsOf(slot.light);
    if (maps == 0) {
        generation.stage().assign(In(1.0F), Out(visibility));
        return visibility;
    }
    const ParameterPtr greatest = generation.number("greatest");
    const ParameterPtr serving = generation.number("serving");
    const std::array chosen{generation.vec4("u"), generation.vec4("v"), generation.vec4("w"),
                            generation.vec4("depth"), generation.vec4("size")};
    for (std::size_t map = 0; map < maps; ++map) {
        std::vector<Operand> operands{In(generation.ws)};
        if (map > 0) operands.push_back(In(static_cast<float>(map)));
        for (const LightParameter first : MapParameters) {
            const std::size_t parameter = first + LP_MAP_STEP * map;
            slot.customs.push_back(
                {generation.pixel.resolveParameter(GpuProgramParameters::ACT_LIGHT_CUSTOM,
                                                   customNumber(parameter, slot.place)),
                 parameter});
            operands.push_back(In(slot.customs.back().uniform));
        }
        // They are written by the first map, and kept or written by the others.
        const auto semantic = map == 0 ? Operand::OPS_OUT : Operand::OPS_INOUT;
        for (const ParameterPtr& part : chosen)
            operands.emplace_back(part, semantic);
        operands.emplace_back(greatest, semantic);
        operands.emplace_back(serving, semantic);
        generation.stage().callFunction(map == 0 ? "Lixel_FirstMap" : "Lixel_NextMap", operands);
    }
    // Sent for each object: objects that share a pass may have other lights.
    slot.firstUnit = generation.pixel.resolveParameter(
        Ogre::GCT_FLOAT1, -1, Ogre::GPV_PER_OBJECT | Ogre::GPV_LIGHTS, "lixelFirstUnit");
    std::vector<Operand> operands{In(generation.ws), In(generation.dx), In(generation.dy)};
    for (const ParameterPtr& part : chosen)
        operands.push_back(In(part));
    operands.push_back(In(slot.firstUnit));
    operands.push_back(In(serving));
    for (const ParameterPtr& unit : generation.units)
        operands.push_back(In(unit));
    operands.push_back(Out(visibility));
    generation.stage().callFunction("Lixel_Visibility", operands);
    return visibility;
}

void ShadowState::updateGpuProgramsParams(Ogre::Renderable*, const Ogre::Pass* pass,
                                          const Ogre::AutoParamDataSource*,
                                          const Ogre::LightList* lights) {
    if (!mUnsaid.empty()) mRegistry.sayOnce(std::exchange(mUnsaid, {}));
    Ogre::SceneManager* const manager = ShaderGenerator::getSingleton().getActiveSceneManager();
    if (mSlots.empty() || manager == nullptr || lights == nullptr) return;
    const SceneTextures& textures = mRegistry.scenes().of(*manager);
    const GpuProgramParameters& parameters = *pass->getFragmentProgramParameters();
    for (Slot& slot : mSlots) {
        if (!slot.firstUnit) continue; // a kind of light that has no maps
        const std::size_t place = slot.light.placeIn(parameters);
        if (place != std::exchange(slot.place, place))
            for (const Slot::Custom& custom : slot.customs)
                custom.uniform->updateExtraInfo(customNumber(custom.parameter, place));
        const int unit = place < lights->size()
                             ? textures.firstUnit(*(*lights)[place], pass->getStartLight())
                             : -1;
        slot.firstUnit->setGpuParameter(static_cast<Ogre::Real>(unit));
    }
}

} // namespace Lixel
