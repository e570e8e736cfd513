#pragma once

#include <OgreScriptTranslator.h>

namespace Lixel {

/// Knows, while it lives, whether OGRE's script compiler is making what a script says.
class ScriptReading : public Ogre::ScriptTranslatorManager, public Ogre::ScriptTranslator {
public:
    ScriptReading();
    ~ScriptReading() override;
    ScriptReading(const ScriptReading&) = delete;
    ScriptReading& operator=(const ScriptReading&) = delete;

    static bool isOpen();

    /// Takes each outermost object of a script, and hands it to who would have it without this.
    Ogre::ScriptTranslator* getTranslator(const Ogre::AbstractNodePtr& node) override;
    void translate(Ogre::ScriptCompiler* compiler, const Ogre::AbstractNodePtr& node) override;
};

} // namespace Lixel
