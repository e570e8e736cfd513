#pragma once

#include "rtss/ShadowState.h"

#include <RTShaderSystem/OgreShaderSubRenderState.h>

namespace Lixel {

class Registry;

/// Makes shadow states, for programs and for scripts that say `lixel_shadows`.
class ShadowFactory : public Ogre::RTShader::SubRenderStateFactory {
public:
    explicit ShadowFactory(Registry& registry) : mRegistry(registry) {}

    const Ogre::String& getType() const override { return ShadowState::Type; }

    using SubRenderStateFactory::createInstance;
    /// Of a line of a script; null where it is about something else, or is wrong, which is an error
    /// of the script.
    Ogre::RTShader::SubRenderState*
    createInstance(Ogre::ScriptCompiler* compiler, Ogre::PropertyAbstractNode* property,
                   Ogre::Pass* pass, Ogre::RTShader::SGScriptTranslator* translator) override;

    using SubRenderStateFactory::writeInstance;
    void writeInstance(Ogre::MaterialSerializer* serializer, Ogre::RTShader::SubRenderState* state,
                       Ogre::Pass* source, Ogre::Pass* destination) override;

    /// Whether no state is left that it made.
    bool isUnused() const { return mSubRenderStateList.empty(); }

protected:
    Ogre::RTShader::SubRenderState* createInstanceImpl() override;

private:
    Registry& mRegistry;
};

} // namespace Lixel
