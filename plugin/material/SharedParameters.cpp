#include "material/SharedParameters.h"

#include <OgreGpuProgramManager.h>
#include <OgreGpuProgramParams.h>
#include <OgreSceneManager.h>
#include <OgreTextureManager.h>

#include <algorithm>
#include <map>
#include <vector>

namespace Lixel {
namespace {

const char* const CasterSet = "Lixel/Caster";
const char* const FogSet = "Lixel/Fog";
const char* const ModulativeSet = "Lixel/ModulativeReceiver";

Ogre::GpuSharedParametersPtr find(const char* name) {
    Ogre::GpuProgramManager* const programs = Ogre::GpuProgramManager::getSingletonPtr();
    if (programs == nullptr) return {};
    const auto& sets = programs->getAvailableSharedParameters();
    const auto found = sets.find(name);
    return found == sets.end() ? Ogre::GpuSharedParametersPtr() : found->second;
}

/// The sets and their constants, vectors of four.
const std::map<std::string, std::vector<std::string>>& sets() {
    static const std::map<std::string, std::vector<std::string>> all{
        {CasterSet, {"lixelCasterDepth"}},
        {FogSet, {"lixelFog", "lixelFogColour"}},
        {ModulativeSet,
         {"lixelRowU", "lixelRowV", "lixelRowW", "lixelRowDepth", "lixelSizeBias", "lixelLight"}},
    };
    return all;
}

} // namespace

SharedParameters::SharedParameters() {
    Ogre::ResourceGroupManager::getSingleton().addResourceGroupListener(this);
}

SharedParameters::~SharedParameters() {
    Ogre::ResourceGroupManager::getSingleton().removeResourceGroupListener(this);
}

void SharedParameters::resourceGroupScriptingStarted(const Ogre::String&, std::size_t) {
    // Made by the render system, and so not there before its first window.
    if (Ogre::GpuProgramManager::getSingletonPtr() == nullptr) return;
    for (const auto& [name, constants] : sets()) {
        if (find(name.c_str())) continue;
        const Ogre::GpuSharedParametersPtr set =
            Ogre::GpuProgramManager::getSingleton().createSharedParameters(name);
        for (const std::string& constant : constants)
            set->addConstantDefinition(constant, Ogre::GCT_FLOAT4);
    }
}

void SharedParameters::resourceGroupScriptingEnded(const Ogre::String&) {
    if (Ogre::GpuProgramManager::getSingletonPtr() == nullptr) return;
    // OGRE binds the warning texture to units without one, as a surface's DiffuseMap may be. Made
    // when it is first wanted, in the midst of a pass, it would unbind that pass's first texture.
    Ogre::TextureManager::getSingleton()._getWarningTexture();
}

const char* SharedParameters::setOf(const std::string& constant) {
    for (const auto& [name, constants] : sets())
        if (std::find(constants.begin(), constants.end(), constant) != constants.end())
            return name.c_str();
    return nullptr;
}

void SharedParameters::setCasterDepth(const ShadowFit& fit) {
    if (const Ogre::GpuSharedParametersPtr set = find(CasterSet))
        set->setNamedConstant("lixelCasterDepth",
                              Ogre::Vector4(static_cast<Ogre::Real>(fit.depthScale),
                                            static_cast<Ogre::Real>(fit.depthOffset), 0, 0));
}

void SharedParameters::setFog(const Ogre::SceneManager& manager) {
    const Ogre::GpuSharedParametersPtr set = find(FogSet);
    if (!set) return;
    set->setNamedConstant("lixelFog", Ogre::Vector4(static_cast<Ogre::Real>(manager.getFogMode()),
                                                    manager.getFogDensity(), manager.getFogStart(),
                                                    manager.getFogEnd()));
    set->setNamedConstant("lixelFogColour", manager.getFogColour());
}

void SharedParameters::setModulativeReceiver(const ReceiverParameters& parameters,
                                             const Ogre::Vector4& light) {
    const Ogre::GpuSharedParametersPtr set = find(ModulativeSet);
    if (!set) return;
    set->setNamedConstant("lixelRowU", parameters.rowU);
    set->setNamedConstant("lixelRowV", parameters.rowV);
    set->setNamedConstant("lixelRowW", parameters.rowW);
    set->setNamedConstant("lixelRowDepth", parameters.rowDepth);
    set->setNamedConstant("lixelSizeBias", parameters.sizeBias);
    set->setNamedConstant("lixelLight", light);
}

} // namespace Lixel
