#include "script/ScriptListener.h"

namespace Lixel {

using Ogre::ScriptCompiler;
using Ogre::ScriptCompilerListener;

ScriptListener::ScriptListener()
    : mNext(Ogre::ScriptCompilerManager::getSingleton().getListener()) {
    Ogre::ScriptCompilerManager::getSingleton().setListener(this);
}

ScriptListener::~ScriptListener() {
    Ogre::ScriptCompilerManager::getSingleton().setListener(mNext);
}

Ogre::ConcreteNodeListPtr ScriptListener::importFile(ScriptCompiler* compiler,
                                                     const Ogre::String& name) {
    return mNext != nullptr ? mNext->importFile(compiler, name)
                            : ScriptCompilerListener::importFile(compiler, name);
}

void ScriptListener::preConversion(ScriptCompiler* compiler, Ogre::ConcreteNodeListPtr nodes) {
    if (mNext != nullptr) mNext->preConversion(compiler, nodes);
}

bool ScriptListener::postConversion(ScriptCompiler* compiler,
                                    const Ogre::AbstractNodeListPtr& nodes) {
    return mNext == nullptr || mNext->postConversion(compiler, nodes);
}

void ScriptListener::handleError(ScriptCompiler* compiler, Ogre::uint32 code,
                                 const Ogre::String& file, int line, const Ogre::String& message) {
    if (mNext != nullptr)
        mNext->handleError(compiler, code, file, line, message);
    else
        ScriptCompilerListener::handleError(compiler, code, file, line, message);
}

bool ScriptListener::handleEvent(ScriptCompiler* compiler, Ogre::ScriptCompilerEvent* event,
                                 void* result) {
    return mNext != nullptr && mNext->handleEvent(compiler, event, result);
}

} // namespace Lixel
