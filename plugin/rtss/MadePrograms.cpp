#include "rtss/MadePrograms.h"

#include <Lixel/scene/OgreVersions.h>

#include <OgreException.h>
#include <OgreResourceGroupManager.h>
#include <RTShaderSystem/OgreShaderGenerator.h>
#include <RTShaderSystem/OgreShaderProgramManager.h>
#include <RTShaderSystem/OgreShaderRenderState.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace Lixel {

using Ogre::RTShader::RenderState;
using Ogre::RTShader::ShaderGenerator;

namespace {

std::vector<Ogre::GpuProgramPtr> allPrograms() {
    std::vector<Ogre::GpuProgramPtr> programs;
    for (const auto& [handle, resource] : programManager().getResourceIterator())
        programs.push_back(std::static_pointer_cast<Ogre::GpuProgram>(resource));
    return programs;
}

std::vector<Ogre::GpuProgramPtr> programsWith(const std::string& define) {
    std::vector<Ogre::GpuProgramPtr> programs = allPrograms();
    std::erase_if(programs, [&](const Ogre::GpuProgramPtr& program) {
        return program->getParameter("preprocessor_defines").find(define) == std::string::npos;
    });
    return programs;
}

/// While it exists, schemes keep the numbers of lights that their programs were made for. Between
/// frames the scene manager's list of lights may name some that are gone.
class KeptLightCounts {
public:
    KeptLightCounts(ShaderGenerator& generator, const std::vector<Ogre::String>& schemes) {
        for (const Ogre::String& scheme : schemes)
            if (RenderState& state = *generator.getRenderState(scheme);
                state.getLightCountAutoUpdate()) {
                state.setLightCountAutoUpdate(false);
                mStates.push_back(&state);
            }
    }
    ~KeptLightCounts() {
        for (RenderState* state : mStates)
            state->setLightCountAutoUpdate(true);
    }
    KeptLightCounts(const KeptLightCounts&) = delete;
    KeptLightCounts& operator=(const KeptLightCounts&) = delete;

private:
    std::vector<RenderState*> mStates;
};

/// Makes all programs of schemes at once. Before OGRE 13 it ends at one that does not compile.
/// @return whether it came to the end
bool makeNow(ShaderGenerator& generator, const std::vector<Ogre::String>& schemes) {
    try {
        for (const Ogre::String& scheme : schemes) {
            generator.invalidateScheme(scheme);
            generator.validateScheme(scheme);
        }
    } catch (const Ogre::Exception&) {
        return false; // it is in the log
    }
    return true;
}

bool areUsable(const std::vector<Ogre::GpuProgramPtr>& programs) {
    return std::ranges::all_of(programs, [](const Ogre::GpuProgramPtr& program) {
        return program->isLoaded() && !program->hasCompileError();
    });
}

using WeakPrograms = std::vector<std::weak_ptr<Ogre::GpuProgram>>;

#if OGRE_VERSION_MAJOR >= 13

/// The shader system has done it since 13.4. Before, its lists are private: they stay to its end.
void destroyUnused(const WeakPrograms&) {}

#else

/// The shader system's own lists of programs, by name.
class ListedPrograms : public Ogre::RTShader::ProgramManager {
public:
    static std::array<GpuProgramsMap*, 2> all() {
        auto& manager = getSingleton();
        return {&(manager.*&ListedPrograms::mVertexShaderMap),
                &(manager.*&ListedPrograms::mFragmentShaderMap)};
    }
};

/// Destroys programs that the shader system has made and nothing uses. It looks for such ones
/// itself, but never finds any: it forgets to count its own references.
void destroyUnused(const WeakPrograms& programs) {
    constexpr long InListAndHere = 2;
    for (const auto& weak : programs)
        for (auto* const listed : ListedPrograms::all()) {
            const Ogre::GpuProgramPtr program = weak.lock();
            if (program == nullptr || listed->count(program->getName()) == 0 ||
                program.use_count() >
                    Ogre::ResourceGroupManager::RESOURCE_SYSTEM_NUM_REFERENCE_COUNTS +
                        InListAndHere)
                continue;
            listed->erase(program->getName());
            programManager().remove(program);
        }
}

#endif

} // namespace

bool MadePrograms::makeAnew(ShaderGenerator& generator, const std::vector<Ogre::String>& schemes) {
    const KeptLightCounts kept(generator, schemes);
    const std::string next = "LIXEL_EDITS=" + std::to_string(mEdits + 1);
    const std::string now = std::exchange(mDefine, next);
    // The shader system may destroy programs as soon as nothing uses them. These are used again: if
    // the next ones do not compile, and otherwise to be destroyed by it afterwards, which it does
    // to no program that something else held when it was last used.
    std::vector<Ogre::GpuProgramPtr> held = allPrograms();
    const bool compile = makeNow(generator, schemes) && areUsable(programsWith(next));
    mDefine = now;
    makeNow(generator, schemes);
    if (!compile) {
        for (const Ogre::GpuProgramPtr& program : programsWith(next))
            programManager().remove(program);
        return false;
    }
    const WeakPrograms before(held.begin(), held.end());
    held.clear();
    mDefine = next;
    ++mEdits;
    makeNow(generator, schemes);
    destroyUnused(before);
    return true;
}

} // namespace Lixel
