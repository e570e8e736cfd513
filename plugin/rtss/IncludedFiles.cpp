#include "rtss/IncludedFiles.h"

#include <Lixel/scene/OgreVersions.h>

#include <OgreException.h>
#include <OgreResourceGroupManager.h>
#include <RTShaderSystem/OgreShaderProgram.h>

namespace Lixel {
namespace {

/// OGRE opens files for a resource that is being loaded: this one never is.
class Reader {
public:
    Reader() = default;
    ~Reader() { programManager().remove(mProgram); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// A file's text with all that it includes.
    std::optional<std::string> read(const std::string& file) const {
        try {
            return Ogre::HighLevelGpuProgram::_resolveIncludes("#include \"" + file + "\"\n",
                                                               mProgram.get(), file);
        } catch (const Ogre::Exception&) {
            return {};
        }
    }

private:
    Ogre::GpuProgramPtr mProgram = createProgram("Lixel/IncludeReader", Ogre::RGN_INTERNAL, "glsl",
                                                 Ogre::GPT_FRAGMENT_PROGRAM);
};

} // namespace

void IncludedFiles::note(const Ogre::RTShader::Program& program) {
    for (unsigned i = 0; i < program.getDependencyCount(); ++i) {
        const std::string file = program.getDependency(i) + ".glsl";
        if (mTexts.count(file) == 0) mTexts[file] = Reader().read(file);
    }
}

std::vector<std::string> IncludedFiles::editedIn(const Ogre::String& group) const {
    const Reader reader;
    std::vector<std::string> files;
    for (const auto& [file, text] : mTexts)
        if (Ogre::ResourceGroupManager::getSingleton().resourceExists(group, file) &&
            reader.read(file) != text)
            files.push_back(file);
    return files;
}

void IncludedFiles::take(const std::vector<std::string>& files) {
    const Reader reader;
    for (const std::string& file : files)
        mTexts[file] = reader.read(file);
}

} // namespace Lixel
