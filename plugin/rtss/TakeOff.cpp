#include "rtss/TakeOff.h"

#include <OgreMaterial.h>
#include <OgreMaterialManager.h>
#include <OgreTechnique.h>
#include <RTShaderSystem/OgreShaderGenerator.h>
#include <RTShaderSystem/OgreShaderRenderState.h>

#include <algorithm>

namespace Lixel {

using Ogre::RTShader::RenderState;
using Ogre::RTShader::ShaderGenerator;
using Ogre::RTShader::SubRenderState;

namespace {

std::size_t mostPasses(const Ogre::Material& material) {
    std::size_t most = 0;
    for (const Ogre::Technique* technique : material.getTechniques())
        most = std::max<std::size_t>(most, technique->getNumPasses());
    return most;
}

} // namespace

std::vector<Ogre::String> schemesOf(const ShaderGenerator& generator) {
    std::vector<Ogre::String> schemes;
    for (std::size_t i = 0; i < generator.getRTShaderSchemeCount(); ++i)
        schemes.push_back(generator.getRTShaderScheme(i));
    return schemes;
}

bool takeOff(RenderState& state, const Ogre::String& type) {
    const auto& all = state.getSubRenderStates();
    const auto found = std::ranges::find_if(
        all, [&](const SubRenderState* one) { return one->getType() == type; });
    if (found == all.end()) return false;
    state.removeSubRenderState(*found);
    return true;
}

void takeOffAllStates(ShaderGenerator& generator, const Ogre::String& type) {
    for (const Ogre::String& scheme : schemesOf(generator)) {
        takeOff(*generator.getRenderState(scheme), type);
        for (const auto& [handle, resource] :
             Ogre::MaterialManager::getSingleton().getResourceIterator()) {
            const auto& material = static_cast<const Ogre::Material&>(*resource);
            for (unsigned short pass = 0; pass < mostPasses(material); ++pass)
                if (RenderState* const own = generator.getRenderState(scheme, material.getName(),
                                                                      material.getGroup(), pass))
                    takeOff(*own, type);
        }
    }
    // Programs hold copies of the states.
    generator.flushShaderCache();
}

} // namespace Lixel
