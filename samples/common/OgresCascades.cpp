#include "common/OgresCascades.h"

#include "common/StartedShaderSystem.h"

#include <Lixel/material/ShadowMaterials.h>
#include <Lixel/rtss/ShaderSystem.h>

#include <OgreShadowCameraSetupPSSM.h>
#include <RTShaderSystem/OgreShaderGenerator.h>
#include <RTShaderSystem/OgreShaderRenderState.h>
#if OGRE_VERSION_MAJOR < 14
#include <RTShaderSystem/OgreShaderExIntegratedPSSM3.h>
#endif

#include <algorithm>

namespace Lixel::Samples {
namespace {

using Ogre::RTShader::ShaderGenerator;
using Ogre::RTShader::SubRenderState;

constexpr unsigned short Maps = 3;

#if OGRE_VERSION_MAJOR >= 14
const Ogre::String& StateType = Ogre::RTShader::SRS_SHADOW_MAPPING;
#else
const Ogre::String& StateType = Ogre::RTShader::IntegratedPSSM3::Type;
#endif

SubRenderState* makeState(const Ogre::PSSMShadowCameraSetup& splits) {
    SubRenderState* const state = ShaderGenerator::getSingleton().createSubRenderState(StateType);
#if OGRE_VERSION_MAJOR >= 14
    state->setParameter("split_points", splits.getSplitPoints());
#else
    static_cast<Ogre::RTShader::IntegratedPSSM3*>(state)->setSplitPoints(splits.getSplitPoints());
#endif
    return state;
}

/// As OGRE's sample ShaderSystem has it.
std::shared_ptr<Ogre::PSSMShadowCameraSetup> makeSplits(Stage& stage) {
    const Ogre::Real near = stage.camera().getNearClipDistance();
    auto splits = std::make_shared<Ogre::PSSMShadowCameraSetup>();
    splits->calculateSplitPoints(Maps, near, stage.sceneManager().getShadowFarDistance());
    splits->setSplitPadding(2 * near);
    splits->setOptimalAdjustFactor(0, 2);
    splits->setOptimalAdjustFactor(1, 1);
    splits->setOptimalAdjustFactor(2, 0.5F);
    return splits;
}

} // namespace

OgresCascades::OgresCascades(Stage& stage, int mapSize) : mStage(stage), mMapSize(mapSize) {
    ShaderGenerator& generator = ShaderGenerator::getSingleton();
    const auto splits = makeSplits(stage);
    SubRenderState* const state = makeState(*splits);
    ShaderSystem::disable(generator);
    generator.getRenderState(StartedShaderSystem::Scheme)->addTemplateSubRenderState(state);
    stage.setShadowSetup(splits, Maps);
    Ogre::SceneManager& sceneManager = stage.sceneManager();
    sceneManager.setShadowTextureSettings(static_cast<unsigned short>(mapSize), Maps,
                                          Ogre::PF_DEPTH32F);
    sceneManager.setShadowTextureCasterMaterial(Ogre::MaterialPtr());
    generator.invalidateScheme(StartedShaderSystem::Scheme);
}

OgresCascades::~OgresCascades() {
    ShaderGenerator& generator = ShaderGenerator::getSingleton();
    Ogre::RTShader::RenderState& scheme = *generator.getRenderState(StartedShaderSystem::Scheme);
    const auto& states = scheme.getSubRenderStates();
    const auto ours = std::ranges::find(states, StateType, &SubRenderState::getType);
    if (ours != states.end()) scheme.removeSubRenderState(*ours);
    mStage.sceneManager().setShadowTextureCasterMaterial(
        Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster"));
    mStage.usePresets();
    mStage.setShadowMapSize(mMapSize);
    ShaderSystem::enable(generator);
}

} // namespace Lixel::Samples
