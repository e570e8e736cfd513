#include "script/ScriptErrors.h"

namespace Lixel {

using Ogre::ScriptCompiler;

bool ScriptErrors::hasUnsetVariable(const std::string& file, unsigned line) const {
    return mUnset.contains({file, static_cast<int>(line)});
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
    ScriptListener::handleError(compiler, code, file, line, message);
}

} // namespace Lixel
