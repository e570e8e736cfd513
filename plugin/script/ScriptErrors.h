#pragma once

#include "script/ScriptListener.h"

#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace Lixel {

/// Collects the errors of OGRE's script compiler while it lives.
class ScriptErrors : public ScriptListener {
public:
    /// A line each, with file and line.
    const std::vector<std::string>& lines() const { return mLines; }
    /// Whether a line has a variable that is not set, which OGRE drops. All variables are expanded
    /// before the first object is translated.
    bool hasUnsetVariable(const std::string& file, unsigned line) const;
    /// Whether there is one in another variable's value: OGRE does not know where that is used.
    bool hasHiddenUnsetVariable() const { return mHasHidden; }

    void handleError(Ogre::ScriptCompiler* compiler, Ogre::uint32 code, const Ogre::String& file,
                     int line, const Ogre::String& message) override;

private:
    /// Errors already logged; a child repeats its parent's wrong lines.
    std::set<std::tuple<std::string, int, Ogre::uint32, std::string>> mLogged;
    std::vector<std::string> mLines;
    std::set<std::pair<std::string, int>> mUnset;
    bool mHasHidden = false;
};

} // namespace Lixel
