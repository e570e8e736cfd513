#pragma once

#include "script/ScriptListener.h"

#include <OgreGpuProgram.h>
#include <OgreMaterial.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Lixel {

/** While it exists, scripts that OGRE parses change the materials and programs that there are,
    instead of failing to define them twice.
*/
class ScriptEdit : public ScriptListener {
public:
    /// @param materialChanges is told of each material before it loses its techniques
    explicit ScriptEdit(std::function<void(Ogre::Material&)> materialChanges);
    ~ScriptEdit() override;

    /** Parses a script.
        @return what was wrong, a line each; then it has to be undone */
    std::vector<std::string> parse(const Ogre::String& text, const Ogre::String& file,
                                   const Ogre::String& group);
    /// Puts back all materials and programs, and removes new ones.
    void undo();

    bool handleEvent(Ogre::ScriptCompiler* compiler, Ogre::ScriptCompilerEvent* event,
                     void* result) override;

private:
    /// What a program had before.
    struct ProgramCopy {
        Ogre::GpuProgramPtr program;
        Ogre::String sourceFile;
        Ogre::NameValuePairList settings;
        bool wasLoaded;
        bool wasBroken; ///< did not compile
        /// Null where it had none.
        Ogre::GpuProgramParametersSharedPtr defaults;
    };

    static bool hasChanged(const ProgramCopy& before);
    static bool isUnusable(const ProgramCopy& before);
    /// @return whether there were any
    bool readChangedProgramsAgain();
    Ogre::Material* changeMaterial(const Ogre::String& name, const Ogre::String& group);
    Ogre::GpuProgram* changeProgram(const Ogre::String& name, const Ogre::String& group,
                                    const Ogre::String& sourceFile);

    std::function<void(Ogre::Material&)> mMaterialChanges;
    /// Copies, by the material that they are of.
    std::map<Ogre::MaterialPtr, Ogre::MaterialPtr> mMaterials;
    std::vector<ProgramCopy> mPrograms;
    /// Names of what did not exist.
    std::vector<std::pair<Ogre::String, Ogre::String>> mNewMaterials; ///< with their group
};

} // namespace Lixel
