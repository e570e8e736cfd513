#pragma once

#include <OgrePrerequisites.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Ogre::RTShader {
class Program;
} // namespace Ogre::RTShader

namespace Lixel {

/** Texts of the files that programs of the shader system include, as they were when these programs
    were made.

    OGRE puts the included text in place of a program's own text when the program is loaded: which
    files it came from is known only while the shader system makes programs.
*/
class IncludedFiles {
public:
    /// Reads what a program includes, except files that are known already.
    void note(const Ogre::RTShader::Program& program);
    /// Names of those files of a resource group that have another text now, by themselves or by
    /// what they include, or cannot be read any more.
    std::vector<std::string> editedIn(const Ogre::String& group) const;
    /// Takes these files' texts as they are now for those that programs are made of.
    void take(const std::vector<std::string>& files);

private:
    /// By file. None where a file, or one that it includes, cannot be read.
    std::map<std::string, std::optional<std::string>> mTexts;
};

} // namespace Lixel
