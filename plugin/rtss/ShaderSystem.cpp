#include "rtss/ShaderSystem.h"

#include "rtss/Registry.h"
#include "rtss/ShadowState.h"
#include "rtss/TakeOff.h"

#include <Lixel/scene/NameList.h>

#include <OgreException.h>
#include <RTShaderSystem/OgreShaderGenerator.h>
#include <RTShaderSystem/OgreShaderRenderState.h>

#include <string>

namespace Lixel::ShaderSystem {

using Ogre::RTShader::RenderState;
using Ogre::RTShader::ShaderGenerator;

namespace {

/// The name of a scheme that there is. @throws where there is none of the name
Ogre::String existingScheme(const ShaderGenerator& generator, const Ogre::String& scheme,
                            const char* function) {
    const Ogre::String& name = scheme.empty() ? ShaderGenerator::DEFAULT_SCHEME_NAME : scheme;
    if (generator.hasRenderState(name)) return name;
    OGRE_EXCEPT(Ogre::Exception::ERR_ITEM_NOT_FOUND,
                "scheme: the shader generator has none of the name '" + name + "'; it has " +
                    joinNames(schemesOf(generator)) +
                    ", and ShaderGenerator::createScheme makes others",
                function);
}

} // namespace

void install(ShaderGenerator& generator) {
    Registry::get().install(generator);
}

void enable(ShaderGenerator& generator, const Ogre::String& scheme, const Options& options) {
    const Ogre::String name = existingScheme(generator, scheme, "ShaderSystem::enable");
    if (options.maps > MaxMaps)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "options.maps: " + std::to_string(options.maps) +
                        " is too many; a program reads 1 to " + std::to_string(MaxMaps) +
                        " of a light, and 0 means as many as the scene manager has",
                    "ShaderSystem::enable");
    install(generator);
    auto* const state =
        static_cast<ShadowState*>(generator.createSubRenderState(ShadowState::Type));
    state->setOptions(options);
    generator.getRenderState(name)->addTemplateSubRenderState(state); // in place of an older one
    generator.invalidateScheme(name);
}

void disable(ShaderGenerator& generator, const Ogre::String& scheme) {
    const Ogre::String name = existingScheme(generator, scheme, "ShaderSystem::disable");
    if (takeOff(*generator.getRenderState(name), ShadowState::Type))
        generator.invalidateScheme(name);
}

void shutdown() {
    Registry::get().shutdown();
}

} // namespace Lixel::ShaderSystem
