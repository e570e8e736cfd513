// lixel-cg-survey RENDER-SYSTEM FOLDER...: which Cg and HLSL programs of a folder's scripts OGRE
// can load and draw with Plugin_LixelCg, and why not the others. For shaders that nobody here
// wrote.

#include "DrawingOgre.h"

#include <OgreException.h>
#include <OgreHighLevelGpuProgramManager.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreResourceGroupManager.h>
#include <OgreTechnique.h>
#include <OgreTextureUnitState.h>
#include <OgreUnifiedHighLevelGpuProgram.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <set>

namespace Lixel::Tests {
namespace {

bool isOurs(const Ogre::GpuProgram& program) {
    return program.getLanguage() == "cg" || program.getLanguage() == "hlsl";
}

/// The program itself, or what a unified one stands for.
const Ogre::GpuProgram* delegateOf(const Ogre::GpuProgramPtr& program) {
    if (!program || program->getLanguage() != "unified") return program.get();
    return static_cast<Ogre::UnifiedHighLevelGpuProgram&>(*program)._getDelegate().get();
}

class Survey {
public:
    explicit Survey(DrawingOgre& ogre) : mOgre(ogre) {}

    void readFolders(int count, char** folders) const {
        auto& groups = Ogre::ResourceGroupManager::getSingleton();
        // Each on its own: a script names a file without its folder.
        for (int i = 0; i < count; ++i) {
            groups.addResourceLocation(folders[i], "FileSystem");
            for (const auto& entry : std::filesystem::recursive_directory_iterator(folders[i]))
                if (entry.is_directory()) {
                    groups.addResourceLocation(entry.path().string(), "FileSystem");
                } else if (entry.path().extension() == ".zip") {
                    groups.addResourceLocation(entry.path().string(), "Zip");
                }
        }
        // Cg and HLSL rather than the GLSL that a unified program may have too.
        Ogre::UnifiedHighLevelGpuProgram::setPriority("glsl", 0);
        Ogre::UnifiedHighLevelGpuProgram::setPriority("cg", 2);
        Ogre::UnifiedHighLevelGpuProgram::setPriority("hlsl", 1);
        groups.initialiseAllResourceGroups();
    }

    void loadPrograms() {
        std::map<std::string, unsigned> loaded;
        std::map<std::string, unsigned> all;
        auto& programs = Ogre::HighLevelGpuProgramManager::getSingleton();
        std::vector<Ogre::GpuProgramPtr> ours;
        for (const auto& [handle, resource] : programs.getResourceIterator()) {
            auto program = Ogre::static_pointer_cast<Ogre::GpuProgram>(resource);
            if (isOurs(*program)) ours.push_back(program);
        }
        std::sort(ours.begin(), ours.end(), [](const auto& a, const auto& b) {
            return std::pair(a->getSourceFile(), a->getName()) <
                   std::pair(b->getSourceFile(), b->getName());
        });
        for (const auto& program : ours) {
            const std::string kind = program->getLanguage() + ' ' +
                                     Ogre::GpuProgram::getProgramTypeName(program->getType());
            ++all[kind];
            const bool known = program->isSupported() || program->hasCompileError();
            if (program->isSupported()) program->load();
            if (program->isSupported()) {
                ++loaded[kind];
                continue;
            }
            std::cout << program->getSourceFile() << ": " << program->getName() << " (" << kind
                      << "): " << (known ? reason(program->getName()) : notOurs(*program)) << '\n';
        }
        for (const auto& [kind, count] : all)
            std::cout << kind << ": " << loaded[kind] << " of " << count << " load\n";
    }

    void drawMaterials() {
        unsigned drawn = 0;
        unsigned all = 0;
        std::set<std::string> names;
        for (const auto& [handle, resource] :
             Ogre::MaterialManager::getSingleton().getResourceIterator())
            names.insert(resource->getName());
        for (const std::string& name : names) {
            const auto material = Ogre::MaterialManager::getSingleton().getByName(name);
            if (!material) continue;
            try {
                material->load();
            } catch (const Ogre::Exception&) {
                continue; // for a GLSL program that lacks its file
            }
            const Ogre::Technique* technique = material->getBestTechnique();
            if (technique == nullptr || !usesOurs(*technique)) continue;
            ++all;
            nameTextures(*technique);
            std::cout << "material " << name;
            mOgre.clearLog();
            std::string problem;
            try {
                mOgre.draw(name);
                // (OGRE takes a pipeline's number for a shader's, and logs that one's state.)
                if (mOgre.logged("pipeline validation").empty()) problem = mOgre.logged("rror");
            } catch (const Ogre::Exception& error) {
                problem = error.getDescription();
            }
            if (problem.empty()) ++drawn;
            std::cout << (problem.empty() ? " draws" : ": " + problem.substr(0, 600)) << '\n';
        }
        std::cout << "materials: " << drawn << " of " << all << " draw\n";
    }

private:
    std::string reason(const std::string& program) const {
        const std::string lines = mOgre.logged("Program '" + program + "' is not supported: ");
        return lines.substr(0, lines.find('\n'));
    }

    static std::string notOurs(const Ogre::GpuProgram& program) {
        const bool isStage = program.getType() == Ogre::GPT_VERTEX_PROGRAM ||
                             program.getType() == Ogre::GPT_FRAGMENT_PROGRAM;
        return isStage ? "no profile that is known" : "neither a vertex nor a fragment program";
    }

    /// Whether all of its vertex and fragment programs are ours: with one of another language it
    /// would not fit together.
    static bool usesOurs(const Ogre::Technique& technique) {
        bool uses = false;
        for (const Ogre::Pass* pass : technique.getPasses()) {
            for (const auto type : {Ogre::GPT_VERTEX_PROGRAM, Ogre::GPT_FRAGMENT_PROGRAM}) {
                if (!pass->hasGpuProgram(type)) continue;
                const auto* program = delegateOf(pass->getGpuProgram(type));
                if (program == nullptr || !isOurs(*program)) return false;
                uses = true;
            }
        }
        return uses;
    }

    /// There are neither compositors nor shadow maps here; an image takes their place.
    static void nameTextures(const Ogre::Technique& technique) {
        for (const Ogre::Pass* pass : technique.getPasses())
            for (Ogre::TextureUnitState* unit : pass->getTextureUnitStates())
                unit->setContentType(Ogre::TextureUnitState::CONTENT_NAMED);
    }

    DrawingOgre& mOgre;
};

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    using namespace Lixel::Tests;
    if (argc < 3) {
        std::cerr << "usage: lixel-cg-survey GL3Plus|GL FOLDER...\n";
        return 1;
    }
    DrawingOgre ogre(std::string(argv[1]) == "GL" ? LegacyGL : GL3PlusSeparate);
    ogre.root().loadPlugin(OGRE_PLUGIN_DIR "/Codec_STBI");
    Survey survey(ogre);
    survey.readFolders(argc - 2, argv + 2);
    survey.loadPrograms();
    survey.drawMaterials();
    return 0;
}
