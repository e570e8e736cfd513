#include "script/ScriptErrors.h"

namespace Lixel {

using Ogre::ScriptCompiler;
using Ogre::ScriptCompilerListener;

ScriptErrors::ScriptErrors() : mNext(Ogre::ScriptCompilerManager::getSingleton().getListener()) {
    Ogre::ScriptCompilerManager::getSingleton().setListener(this);
}

ScriptErrors::~ScriptErrors() {
    Ogre::ScriptCompilerManager::getSingleton().setListener(mNext);
}

bool ScriptErrors::hasUnsetVariable(const std::string& file, unsigned line) const {
    return mUnset.contains({file, static_cast<int>(line)});
}

Ogre::ConcreteNodeListPtr ScriptErrors::importFile(ScriptCompiler* compiler,
                                                   const Ogre::String& name) {
    return mNext != nullptr ? mNext->importFile(compiler, name)
                            : ScriptCompilerListener::importFile(compiler, name);
}

void ScriptErrors::preConversion(ScriptCompiler* compiler, Ogre::ConcreteNodeListPtr nodes) {
    if (mNext != nullptr) mNext->preConversion(compiler, nodes);
}

bool ScriptErrors::postConversion(ScriptCompiler* compiler,
                                  const Ogre::AbstractNodeListPtr& nodes) {
    return mNext == nullptr || mNext->postConversion(compiler, nodes);
}

void ScriptErrors::handleError(ScriptCompiler* compiler, Ogre::uint32 code,
                               const Ogre::String& file, int line, const Ogre::String& message) {
    if (code == ScriptCompiler::CE_UNDEFINEDVARIABLE) {
        mUnset.emplace(file, line);
        // Lines of a value are counted from 1 anew.
        mHasHidden = mHasHidden || line == 1;
    }
    const bool isError = code != ScriptCompiler::CE_DEPRECATEDSYMBOL;
    if (isError) {
        if (!mLogged.emplace(file, line, code, message).second) return;
        mLines.push_back(file + "(" + std::to_string(line) +
                         "): " + ScriptCompiler::formatErrorCode(code) + ": " + message);
    }
    if (mNext != nullptr)
        mNext->handleError(compiler, code, file, line, message);
    else
        ScriptCompilerListener::handleError(compiler, code, file, line, message);
}

bool ScriptErrors::handleEvent(ScriptCompiler* compiler, Ogre::ScriptCompilerEvent* event,
                               void* result) {
    return mNext != nullptr && mNext->handleEvent(compiler, event, result);
}

} // namespace Lixel
