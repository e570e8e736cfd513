#pragma once

#include "script/ScriptErrors.h"
#include "script/ShadowPreset.h"

#include <OgreScriptTranslator.h>

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Lixel {

/// Has OGRE's script compiler define presets.
class PresetTranslator : public Ogre::ScriptTranslatorManager, public Ogre::ScriptTranslator {
public:
    /// From here on until the file ends, a preset that this file defined before is defined anew.
    void beginFile(const std::string& file);
    /// @return its errors, a line each
    std::vector<std::string> endFile();

    Ogre::ScriptTranslator* getTranslator(const Ogre::AbstractNodePtr& node) override;
    void translate(Ogre::ScriptCompiler* compiler, const Ogre::AbstractNodePtr& node) override;

private:
    /// An object's lines without those that are wrong, and whether none is.
    std::pair<std::vector<PresetLine>, bool> linesOf(Ogre::ScriptCompiler& compiler,
                                                     const Ogre::ObjectAbstractNode& object) const;

    /// The file that is being read; empty while OGRE reads one of its own.
    std::string mFile;
    /// Presets that it has defined so far.
    std::set<std::string> mDefined;
    /// Those of that file; null while OGRE reads one of its own.
    std::unique_ptr<ScriptErrors> mErrors;
};

} // namespace Lixel
