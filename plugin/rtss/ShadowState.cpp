#include "rtss/ShadowState.h"

#include "rtss/ReceiverCode.h"
#include "rtss/Registry.h"
#include "rtss/Requirements.h"
#include "rtss/ShadowUnits.h"
#include "rtss/TransformedCasters.h"

#include <Lixel/material/DrawnPass.h>

#include <OgreMaterial.h>
#include <OgrePass.h>
#include <OgreSceneManager.h>
#include <OgreTechnique.h>
#include <OgreTextureUnitState.h>
#include <OgreUserObjectBindings.h>
#include <RTShaderSystem/OgreShaderGenerator.h>
#include <RTShaderSystem/OgreShaderProgram.h>
#include <RTShaderSystem/OgreShaderProgramSet.h>
#include <RTShaderSystem/OgreShaderRenderState.h>

#include <algorithm>
#include <utility>

namespace Lixel {

using namespace Ogre::RTShader;

const Ogre::String ShadowState::Type = "Lixel_Shadows";

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

std::string ShadowState::quotedMaterialName() const {
    return "'" + mPass->getParent()->getParent()->getName() + "'";
}

bool ShadowState::preAddToRenderState(const RenderState* renderState, Ogre::Pass* source,
                                      Ogre::Pass* destination) {
    mTarget = renderState;
    mPass = destination;
    destination->getUserObjectBindings().setUserAny(ShaderSystemMark, Ogre::Any(true));
    Ogre::SceneManager* const manager = ShaderGenerator::getSingleton().getActiveSceneManager();
    if (manager != nullptr) mRegistry.scenes().watch(*manager);
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
        mPendingWarnings.push_back(
            "nothing casts shadows on material " + quotedMaterialName() +
            ", which has a pass that is drawn once for each light: take its `iteration` out; the "
            "shader system lights a pass by all lights at once");
        return false;
    }
    return true;
}

std::size_t ShadowState::mapsOf(const ProgramLight& light) const {
    const std::size_t all = light.type ? mLayout.mapsOfType[*light.type] : mLayout.mostMaps();
    return std::min(all, mOptions.maps == 0 ? ShaderSystem::MaxMaps : mOptions.maps);
}

/// @return how many of the pass's units hold shadow maps; they are its last
std::size_t ShadowState::addUnits() {
    if (hasShadowUnits(*mPass)) {
        // OGRE gives the k-th map to the k-th of these.
        mPendingWarnings.push_back(
            "no light of a Lixel setup shadows material " + quotedMaterialName() +
            ", which has texture units of content_type shadow already: take them out of its "
            "script, or the part of the shader system that adds them, `integrated_pssm4` in "
            "scripts or the sub-render state IntegratedPSSM3 of the scheme");
        return 0;
    }
    const std::size_t used = mPass->getNumTextureUnitStates();
    const std::size_t free = greatestUnits() - std::min(used, greatestUnits());
    const std::size_t units = std::min(mLayout.textures, free);
    if (units < mLayout.textures)
        mPendingWarnings.push_back(
            "material " + quotedMaterialName() + " has " + std::to_string(used) +
            " textures, which leaves units for " + std::to_string(units) + " of " +
            std::to_string(mLayout.textures) +
            " shadow maps: shadows in the remaining maps are missing. Give lights fewer maps "
            "(SceneManager::setShadowTextureCountPerLightType), or the material fewer textures");
    for (std::size_t i = 0; i < units; ++i) {
        Ogre::TextureUnitState& unit = *mPass->createTextureUnitState();
        unit.setContentType(Ogre::TextureUnitState::CONTENT_SHADOW);
        unit.setTextureAddressingMode(Ogre::TextureUnitState::TAM_CLAMP);
        unit.setTextureFiltering(Ogre::TFO_NONE);
    }
    return units;
}

bool ShadowState::createCpuSubPrograms(ProgramSet* programs) {
    mPrograms = programs;
    ProgramBuild build{*programs->getCpuProgram(Ogre::GPT_VERTEX_PROGRAM),
                       *programs->getCpuProgram(Ogre::GPT_FRAGMENT_PROGRAM),
                       {},
                       {},
                       {},
                       {}};
    if (const std::string& define = mRegistry.editDefine(); !define.empty())
        for (Program* const program : {&build.vertex, &build.pixel})
            program->addPreprocessorDefines(define);
    if (std::string warning = setCaster(*mPass, build.vertex); !warning.empty())
        mPendingWarnings.push_back(std::move(warning));
    if (!mReceives) return true;
    const std::vector<ProgramLight> lights = lightsIn(build.pixel, *mTarget);
    if (lights.empty()) {
        mPendingWarnings.push_back("nothing casts shadows on material " + quotedMaterialName() +
                                   ", which " + whyWithoutLights(*mTarget));
        return true;
    }
    const std::size_t units = addUnits();
    if (units == 0) return true;
    addReceiver(build, mPass->getNumTextureUnitStates() - units, units);
    std::vector<ParameterPtr> visibilities;
    for (const ProgramLight& light : lights) {
        LightUniforms& uniforms = mLights.emplace_back();
        uniforms.light = light;
        uniforms.lightListIndex = light.index;
        visibilities.push_back(addVisibility(build, uniforms, mapsOf(light)));
    }
    dimLights(build.pixel, lights, visibilities, VisibilityStage);
    mRegistry.noteIncludes(*programs);
    return true;
}

void ShadowState::updateGpuProgramsParams(Ogre::Renderable*, const Ogre::Pass* pass,
                                          const Ogre::AutoParamDataSource*,
                                          const Ogre::LightList* lights) {
    for (const std::string& warning : std::exchange(mPendingWarnings, {}))
        mRegistry.sayOnce(warning);
    if (const ProgramSet* const programs = std::exchange(mPrograms, nullptr))
        mRegistry.noteIncludes(*programs);
    Ogre::SceneManager* const manager = ShaderGenerator::getSingleton().getActiveSceneManager();
    if (mLights.empty() || manager == nullptr || lights == nullptr) return;
    const LightUnits& units = mRegistry.scenes().watch(*manager);
    const Ogre::GpuProgramParameters& parameters = *pass->getFragmentProgramParameters();
    for (LightUniforms& uniforms : mLights) {
        if (!uniforms.firstUnit) continue; // a kind of light that has no maps
        const std::size_t index = uniforms.light.lightListIndex(parameters);
        const int unit =
            index < lights->size() ? units.firstUnit(*(*lights)[index], pass->getStartLight()) : -1;
        uniforms.bind(index, unit);
    }
}

} // namespace Lixel
