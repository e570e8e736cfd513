#pragma once

#include "rtss/IncludedFiles.h"
#include "rtss/LightUnits.h"
#include "rtss/MadePrograms.h"

#include <Lixel/reload/Reload.h>

#include <OgreFrameListener.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace Ogre::RTShader {
class ProgramSet;
class ShaderGenerator;
} // namespace Ogre::RTShader

namespace Lixel {

class ShadowFactory;

/** What this library has hung into OGRE.

    There is one, and it is never destroyed: OGRE may destroy programs after everything else of this
    library's is gone.
*/
class Registry : public Ogre::FrameListener, private ReloadListener {
public:
    static Registry& get();

    void install(Ogre::RTShader::ShaderGenerator& generator);
    void shutdown();

    AllLightUnits& scenes() { return mScenes; }
    /// Records the layout of a scheme's first program, even if no shadow code was added.
    void noteProgram(const Ogre::String& scheme);
    /// Records what programs include, so that an edit of it is seen. Call it when they are made,
    /// and again when the parts of others are in them too.
    void noteIncludes(const Ogre::RTShader::ProgramSet& programs);
    /// A define that all programs are to have; or empty.
    const std::string& editDefine() const { return mMadePrograms.define(); }
    /// Writes a line to the log, unless it was written before.
    void sayOnce(const std::string& message);

    /// Registers new scene managers before they draw with existing programs.
    bool frameStarted(const Ogre::FrameEvent& event) override;

private:
    Registry();
    void makeProgramsAnew();
    static void watchAll(AllLightUnits& scenes);
    /// The shader system keeps pointers to the techniques that it has made others of.
    void materialChanges(Ogre::Material& material) override;
    std::vector<std::string> shadersChange(const Ogre::String& group) override;

    ShadowFactory* mFactory = nullptr;
    AllLightUnits mScenes;
    /// The layout for which the first of a scheme's programs was made.
    std::map<Ogre::String, MapLayout> mMadeFor;
    IncludedFiles mIncludedFiles;
    MadePrograms mMadePrograms;
    std::set<std::string> mSaid;
};

} // namespace Lixel
