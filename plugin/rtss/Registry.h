#pragma once

#include "rtss/SceneTextures.h"

#include <OgreFrameListener.h>

#include <map>
#include <set>
#include <string>

namespace Ogre::RTShader {
class ShaderGenerator;
} // namespace Ogre::RTShader

namespace Lixel {

class ShadowFactory;

/** What this library has hung into OGRE.

    There is one, and it is never destroyed: OGRE may destroy programs after everything else of this
    library's is gone.
*/
class Registry : public Ogre::FrameListener {
public:
    static Registry& get();

    void install(Ogre::RTShader::ShaderGenerator& generator);
    void shutdown();

    AllSceneTextures& scenes() { return mScenes; }
    /// A program of a scheme is made for scenes().layout(), or is not because of it.
    void noteProgram(const Ogre::String& scheme);
    /// Writes a line to the log, unless it was written before.
    void sayOnce(const std::string& message);

    /// Scene managers that are new, before they draw with programs that there are already.
    bool frameStarted(const Ogre::FrameEvent& event) override;

private:
    Registry();
    void makeProgramsAnew();
    static void watchAll(AllSceneTextures& scenes);

    ShadowFactory* mFactory = nullptr;
    AllSceneTextures mScenes;
    /// The layout for which the first of a scheme's programs was made.
    std::map<Ogre::String, MapLayout> mMadeFor;
    std::set<std::string> mSaid;
};

} // namespace Lixel
