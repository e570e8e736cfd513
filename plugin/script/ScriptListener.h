#pragma once

#include <OgreScriptCompiler.h>

namespace Lixel {

/** Listens to OGRE's script compiler while it lives.

    It stands before the listener that was there, which is told all the same. Several end in the
    order opposite to that in which they began.
*/
class ScriptListener : public Ogre::ScriptCompilerListener {
public:
    ScriptListener();
    ~ScriptListener() override;
    ScriptListener(const ScriptListener&) = delete;
    ScriptListener& operator=(const ScriptListener&) = delete;

    Ogre::ConcreteNodeListPtr importFile(Ogre::ScriptCompiler* compiler,
                                         const Ogre::String& name) override;
    void preConversion(Ogre::ScriptCompiler* compiler, Ogre::ConcreteNodeListPtr nodes) override;
    bool postConversion(Ogre::ScriptCompiler* compiler,
                        const Ogre::AbstractNodeListPtr& nodes) override;
    void handleError(Ogre::ScriptCompiler* compiler, Ogre::uint32 code, const Ogre::String& file,
                     int line, const Ogre::String& message) override;
    bool handleEvent(Ogre::ScriptCompiler* compiler, Ogre::ScriptCompilerEvent* event,
                     void* result) override;

private:
    Ogre::ScriptCompilerListener* mNext;
};

} // namespace Lixel
