#include "material/ScriptReading.h"

#include <OgreScriptCompiler.h>

namespace Lixel {
namespace {

/// How many objects are being made, one within the other.
int openObjects = 0;

struct OpenObject {
    OpenObject() { ++openObjects; }
    ~OpenObject() { --openObjects; }
    OpenObject(const OpenObject&) = delete;
    OpenObject& operator=(const OpenObject&) = delete;
};

} // namespace

ScriptReading::ScriptReading() {
    Ogre::ScriptCompilerManager::getSingleton().addTranslatorManager(this);
}

ScriptReading::~ScriptReading() {
    Ogre::ScriptCompilerManager::getSingleton().removeTranslatorManager(this);
}

bool ScriptReading::isOpen() {
    return openObjects > 0;
}

Ogre::ScriptTranslator* ScriptReading::getTranslator(const Ogre::AbstractNodePtr& node) {
    return !isOpen() && node->type == Ogre::ANT_OBJECT ? this : nullptr;
}

void ScriptReading::translate(Ogre::ScriptCompiler* compiler, const Ogre::AbstractNodePtr& node) {
    const OpenObject open;
    if (Ogre::ScriptTranslator* const translator =
            Ogre::ScriptCompilerManager::getSingleton().getTranslator(node))
        translator->translate(compiler, node);
}

} // namespace Lixel
