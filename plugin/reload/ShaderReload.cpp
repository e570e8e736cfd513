#include "reload/ShaderReload.h"

#include "material/OnDemandPrograms.h"
#include "reload/ProgramSettings.h"
#include "scene/OgreVersions.h"

#include <OgreGpuProgram.h>

namespace Lixel {
namespace {

/// A group's programs whose text is a file's.
std::vector<Ogre::GpuProgramPtr> programsFrom(const Ogre::String& group) {
    std::vector<Ogre::GpuProgramPtr> programs;
    for (const auto& [handle, resource] : programManager().getResourceIterator()) {
        auto program = std::static_pointer_cast<Ogre::GpuProgram>(resource);
        if (program->getGroup() == group && !program->getSourceFile().empty())
            programs.push_back(std::move(program));
    }
    return programs;
}

/// A program as another one would be if it were loaded now. Not registered by that one's name.
class Attempt {
public:
    explicit Attempt(const Ogre::GpuProgram& program)
        : mMade(createProgram(program.getName() + "/Lixel/Attempt", program.getGroup(),
                              program.getLanguage(), program.getType())) {
        setSettings(*mMade, settingsOf(program));
        mMade->setSourceFile(program.getSourceFile());
        loadIfPossible(*mMade);
    }
    ~Attempt() { programManager().remove(mMade); }
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;

    bool compiles() const { return mMade->isLoaded() && !mMade->hasCompileError(); }
    const Ogre::String& text() const { return mMade->getSource(); }

private:
    Ogre::GpuProgramPtr mMade;
};

} // namespace

std::vector<std::string> reloadShaders(const Ogre::String& group) {
    std::vector<std::string> errors;
    for (const Ogre::GpuProgramPtr& program : programsFrom(group)) {
        if (!program->isLoaded()) {
            // Of those in use by nothing, what was read for their parameters is read again.
            if (!isCompiled(*program)) program->unload();
            continue;
        }
        // A program that fails loses its parameters, and so do the passes that use it. So the new
        // text is tried by another one.
        const Attempt attempt(*program);
        if (!attempt.compiles())
            errors.push_back("program '" + program->getName() + "': " + program->getSourceFile() +
                             " does not compile, or a file is missing; the program stays as it was "
                             "(the log has more)");
        else if (attempt.text() != program->getSource())
            program->reload();
    }
    return errors;
}

} // namespace Lixel
