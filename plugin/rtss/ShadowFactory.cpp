#include "rtss/ShadowFactory.h"

#include <OgreMaterialSerializer.h>
#include <OgreScriptCompiler.h>

#include <string>
#include <vector>

namespace Lixel {
namespace {

const char* const Keyword = "lixel_shadows";

std::vector<std::string> wordsOf(const Ogre::PropertyAbstractNode& property) {
    std::vector<std::string> words;
    for (const Ogre::AbstractNodePtr& node : property.values)
        if (node->type == Ogre::ANT_ATOM)
            words.push_back(static_cast<const Ogre::AtomAbstractNode&>(*node).value);
    return words;
}

/// What is wrong with the words after the keyword; empty where nothing is.
std::string applyTo(ShadowState& state, const std::vector<std::string>& words) {
    const std::string known = "; it takes `maps auto`, or `maps` and a number from 1 to " +
                              std::to_string(ShaderSystem::MaxMaps);
    for (std::size_t i = 0; i < words.size(); i += 2) {
        const std::string begin = std::string(Keyword) + ": ";
        if (words[i] != "maps") return begin + "there is no '" + words[i] + "'" + known;
        if (i + 1 == words.size()) return begin + "'maps' has no value" + known;
        if (!state.setParameter(words[i], words[i + 1]))
            return begin + "maps cannot be '" + words[i + 1] + "'" + known;
    }
    return {};
}

} // namespace

Ogre::RTShader::SubRenderState* ShadowFactory::createInstance(Ogre::ScriptCompiler* compiler,
                                                              Ogre::PropertyAbstractNode* property,
                                                              Ogre::Pass*,
                                                              Ogre::RTShader::SGScriptTranslator*) {
    if (property->name != Keyword) return nullptr;
    auto* const state = static_cast<ShadowState*>(createInstance());
    const std::string wrong = applyTo(*state, wordsOf(*property));
    if (wrong.empty()) return state;
    compiler->addError(Ogre::ScriptCompiler::CE_INVALIDPARAMETERS, property->file,
                       static_cast<int>(property->line), wrong);
    destroyInstance(state);
    return nullptr;
}

void ShadowFactory::writeInstance(Ogre::MaterialSerializer* serializer,
                                  Ogre::RTShader::SubRenderState* state, Ogre::Pass*, Ogre::Pass*) {
    constexpr unsigned short Level = 4; // of indentation, inside of rtshader_system
    const std::size_t maps = static_cast<const ShadowState*>(state)->options().maps;
    serializer->writeAttribute(Level, Keyword);
    // Never without a value: OGRE drops such a line when it reads it.
    serializer->writeValue("maps");
    serializer->writeValue(maps == 0 ? "auto" : std::to_string(maps));
}

Ogre::RTShader::SubRenderState* ShadowFactory::createInstanceImpl() {
    return OGRE_NEW ShadowState(mRegistry);
}

} // namespace Lixel
