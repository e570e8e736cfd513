#include "rtss/Registry.h"

#include "rtss/ShadowFactory.h"
#include "rtss/ShadowState.h"
#include "rtss/TakeOff.h"

#include <Lixel/scene/Log.h>
#include <Lixel/scene/NameList.h>

#include <OgreException.h>
#include <OgreMaterial.h>
#include <OgreRoot.h>
#include <RTShaderSystem/OgreShaderGenerator.h>
#include <RTShaderSystem/OgreShaderProgramSet.h>

namespace Lixel {

using Ogre::RTShader::ShaderGenerator;

Registry& Registry::get() {
    static Registry& registry = *new Registry;
    return registry;
}

Registry::Registry() : mScenes([this] { makeProgramsAnew(); }) {}

void Registry::install(ShaderGenerator& generator) {
    const auto* const known = generator.getSubRenderStateFactory(ShadowState::Type);
    if (known != nullptr && known != mFactory)
        OGRE_EXCEPT(Ogre::Exception::ERR_DUPLICATE_ITEM,
                    "generator: another copy of libLixelRTSS has installed '" + ShadowState::Type +
                        "'; link it once, as a shared library",
                    "ShaderSystem::install");
    if (mFactory == nullptr) mFactory = new ShadowFactory(*this);
    if (known == nullptr) {
        generator.addSubRenderStateFactory(mFactory);
        mMadeFor.clear();
    }
    Ogre::Root::getSingleton().addFrameListener(this); // once, however often it is called
    addReloadListener(*this);
    watchAll(mScenes);
}

void Registry::shutdown() {
    if (ShaderGenerator* const generator = ShaderGenerator::getSingletonPtr();
        generator != nullptr && mFactory != nullptr &&
        generator->getSubRenderStateFactory(ShadowState::Type) == mFactory) {
        takeOffAllStates(*generator, ShadowState::Type);
        generator->removeSubRenderStateFactory(mFactory);
    }
    removeReloadListener(*this);
    mScenes.clear();
    if (Ogre::Root* const root = Ogre::Root::getSingletonPtr()) root->removeFrameListener(this);
    mMadeFor.clear();
    mIncludedFiles = {};
    mSaid.clear();
    // States that something else still holds need it.
    if (mFactory == nullptr || !mFactory->isUnused()) return;
    delete mFactory;
    mFactory = nullptr;
}

void Registry::noteProgram(const Ogre::String& scheme) {
    mMadeFor.try_emplace(scheme, mScenes.layout());
}

void Registry::sayOnce(const std::string& message) {
    if (mSaid.insert(message).second) logWarning(message);
}

bool Registry::frameStarted(const Ogre::FrameEvent&) {
    watchAll(mScenes);
    return true;
}

void Registry::makeProgramsAnew() {
    ShaderGenerator* const generator = ShaderGenerator::getSingletonPtr();
    if (generator == nullptr) return;
    std::erase_if(mMadeFor, [&](const auto& scheme) {
        if (scheme.second == mScenes.layout()) return false;
        generator->invalidateScheme(scheme.first);
        return true;
    });
}

void Registry::materialChanges(Ogre::Material& material) {
    if (ShaderGenerator* const generator = ShaderGenerator::getSingletonPtr())
        generator->removeAllShaderBasedTechniques(material.getName(), material.getGroup());
}

void Registry::noteIncludes(const Ogre::RTShader::ProgramSet& programs) {
    for (const auto type : {Ogre::GPT_VERTEX_PROGRAM, Ogre::GPT_FRAGMENT_PROGRAM})
        mIncludedFiles.note(*programs.getCpuProgram(type));
}

std::vector<std::string> Registry::shadersChange(const Ogre::String& group) {
    ShaderGenerator* const generator = ShaderGenerator::getSingletonPtr();
    if (generator == nullptr || mMadeFor.empty()) return {};
    const std::vector<std::string> edited = mIncludedFiles.editedIn(group);
    if (edited.empty()) return {};
    std::vector<Ogre::String> schemes;
    for (const auto& [scheme, layout] : mMadeFor)
        if (generator->hasRenderState(scheme)) schemes.push_back(scheme);
    // Without a scene manager OGRE's own parts of programs cannot be made.
    const bool canDraw = generator->getActiveSceneManager() != nullptr;
    if (canDraw && mMadePrograms.makeAnew(*generator, schemes)) {
        mIncludedFiles.take(edited);
        return {};
    }
    const std::string error =
        "programs of OGRE's shader system: " + joinNames(edited) +
        (canDraw ? ", or what is included there, does not compile or is missing"
                 : " was edited, and no scene manager draws with them now") +
        "; all of these programs stay as they were" + (canDraw ? " (the log has more)" : "");
    logWarning(error);
    return {error};
}

void Registry::watchAll(AllLightUnits& scenes) {
    for (const auto& [name, manager] : Ogre::Root::getSingleton().getSceneManagers())
        scenes.watch(*manager);
}

} // namespace Lixel
