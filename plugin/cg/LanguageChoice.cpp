#include "cg/LanguageChoice.h"

#include <OgreHighLevelGpuProgramManager.h>
#include <OgreScriptCompiler.h>

#include <algorithm>

namespace Lixel::Cg {
namespace {

Ogre::String languageOf(const Ogre::AbstractNodePtr& node) {
    return node->type == Ogre::ANT_ATOM ? static_cast<Ogre::AtomAbstractNode&>(*node).value
                                        : Ogre::String();
}

} // namespace

Ogre::ScriptTranslator* LanguageChoice::getTranslator(const Ogre::AbstractNodePtr& node) {
    if (node->type != Ogre::ANT_OBJECT) return nullptr;
    auto& object = static_cast<Ogre::ObjectAbstractNode&>(*node);
    const bool isProgram = object.cls == "vertex_program" || object.cls == "fragment_program";
    if (!isProgram || object.values.size() < 2) return nullptr;
    const bool hasGlsl =
        std::any_of(object.values.begin(), object.values.end(),
                    [](const auto& value) { return languageOf(value) == "glsl"; }) &&
        Ogre::HighLevelGpuProgramManager::getSingleton().isLanguageSupported("glsl");
    if (hasGlsl)
        object.values.remove_if(
            [this](const auto& value) { return mLanguages.count(languageOf(value)) != 0; });
    return nullptr;
}

} // namespace Lixel::Cg
