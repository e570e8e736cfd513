#pragma once

#include "rtss/MapLayout.h"
#include "rtss/ReceiverCode.h"
#include "rtss/ShaderSystem.h"

#include <RTShaderSystem/OgreShaderSubRenderState.h>

#include <string>
#include <vector>

namespace Lixel {

class Registry;

/// A part of a shader system's programs: shadows each of their lights by its own maps.
class ShadowState : public Ogre::RTShader::SubRenderState {
public:
    static const Ogre::String Type;

    explicit ShadowState(Registry& registry) : mRegistry(registry) {}

    const Ogre::String& getType() const override { return Type; }
    int getExecutionOrder() const override { return DimmingOrder; }
    void copyFrom(const SubRenderState& other) override;

    /// Whether a pass casts or receives shadows by this part. Where it could be shadowed and
    /// cannot, the log says why.
    bool preAddToRenderState(const Ogre::RTShader::RenderState* renderState, Ogre::Pass* source,
                             Ogre::Pass* destination) override;
    bool createCpuSubPrograms(Ogre::RTShader::ProgramSet* programs) override;
    /// Binds each light's maps, for the lights of the object that is about to be drawn.
    void updateGpuProgramsParams(Ogre::Renderable* renderable, const Ogre::Pass* pass,
                                 const Ogre::AutoParamDataSource* source,
                                 const Ogre::LightList* lights) override;

    /// As by a script: `maps` is its one name, with `auto`, or 1 to MaxMaps.
    bool setParameter(const Ogre::String& name, const Ogre::String& value) override;
    using SubRenderState::setParameter;

    const ShaderSystem::Options& options() const { return mOptions; }
    void setOptions(const ShaderSystem::Options& options) { mOptions = options; }

private:
    bool canReceive(const Ogre::RTShader::RenderState& renderState, const Ogre::Pass& source);
    std::size_t mapsOf(const ProgramLight& light) const;
    std::size_t addUnits();
    std::string quotedMaterialName() const;

    Registry& mRegistry;
    ShaderSystem::Options mOptions;
    /// Alive while programs are made.
    const Ogre::RTShader::RenderState* mTarget = nullptr;
    Ogre::Pass* mPass = nullptr;
    /// Alive until they are first drawn; null from then on.
    const Ogre::RTShader::ProgramSet* mPrograms = nullptr;
    MapLayout mLayout;
    bool mReceives = false;
    /// Why the material is not shadowed as it should be: logged once the material is drawn, since
    /// programs are made for materials that never are.
    std::vector<std::string> mPendingWarnings;
    std::vector<LightUniforms> mLights;
};

} // namespace Lixel
