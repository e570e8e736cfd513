#pragma once

#include <OgreScriptTranslator.h>

#include <set>
#include <string>
#include <utility>

namespace Lixel {

/// Has OGRE's script compiler define presets.
class PresetTranslator : public Ogre::ScriptTranslatorManager, public Ogre::ScriptTranslator {
public:
    /// From here on until the file ends, a preset that this file defined before is defined anew.
    void beginFile(const std::string& file);
    /// @return how many errors there were in it
    std::size_t endFile();

    Ogre::ScriptTranslator* getTranslator(const Ogre::AbstractNodePtr& node) override;
    void translate(Ogre::ScriptCompiler* compiler, const Ogre::AbstractNodePtr& node) override;

private:
    /// The file that is being read; empty while OGRE reads one of its own.
    std::string mFile;
    /// Presets that it has defined so far.
    std::set<std::string> mDefined;
    std::size_t mErrors = 0;
    /// Errors that were said, each with its line: a setup that inherits a wrong line has the same.
    std::set<std::pair<unsigned, std::string>> mSaid;
};

} // namespace Lixel
