#include "reload/ScriptEdit.h"

#include "scene/OgreVersions.h"
#include "script/ShadowCameraSetupManager.h"

#include <OgreGpuProgramManager.h>
#include <OgreMaterialManager.h>
#include <OgreTechnique.h>

#include <algorithm>
#include <utility>

namespace Lixel {
namespace {

using Ogre::CreateGpuProgramScriptCompilerEvent;
using Ogre::CreateMaterialScriptCompilerEvent;

/// Ogre's Material::copyDetailsTo takes a reference to a pointer.
void copy(const Ogre::Material& from, Ogre::MaterialPtr to) {
    from.copyDetailsTo(to);
}

Ogre::MaterialPtr copyOf(const Ogre::Material& material) {
    Ogre::MaterialPtr made = Ogre::MaterialManager::getSingleton().create(
        material.getName() + "/Lixel/Before", material.getGroup());
    copy(material, made);
    return made;
}

Ogre::NameValuePairList settingsOf(const Ogre::GpuProgram& program) {
    Ogre::NameValuePairList settings;
    for (const auto& setting : program.getParameters()) {
        const Ogre::String& name = settingName(setting);
        settings[name] = program.getParameter(name);
    }
    return settings;
}

/// Where its file is not there, it counts as one that does not compile.
void loadAgain(Ogre::GpuProgram& program) {
    program.unload();
    try {
        program.load();
    } catch (const Ogre::Exception&) {
        // It is in the log.
    }
}

} // namespace

ScriptEdit::ScriptEdit(std::function<void(Ogre::Material&)> materialChanges)
    : mMaterialChanges(std::move(materialChanges)),
      mOthers(Ogre::ScriptCompilerManager::getSingleton().getListener()) {
    Ogre::ScriptCompilerManager::getSingleton().setListener(this);
}

ScriptEdit::~ScriptEdit() {
    Ogre::ScriptCompilerManager::getSingleton().setListener(mOthers);
    for (const auto& [material, before] : mMaterials)
        Ogre::MaterialManager::getSingleton().remove(before);
}

std::vector<std::string> ScriptEdit::parse(const Ogre::String& text, const Ogre::String& file,
                                           const Ogre::String& group) {
    const auto once = [&] {
        mErrors.clear();
        // It has a copy of its own, which it may change.
        Ogre::String own = text;
        Ogre::DataStreamPtr stream =
            std::make_shared<Ogre::MemoryDataStream>(file, own.data(), own.size(), false, true);
        ShadowCameraSetupManager::getSingleton().parseMaterialsAgain(stream, group);
    };
    once();
    // Lines of parameters are about the uniforms that a program had when it was compiled.
    if (readChangedProgramsAgain()) once();
    for (const ProgramCopy& before : mPrograms)
        if (isUnusable(before))
            mErrors.push_back(file + ": program '" + before.program->getName() +
                              "' does not compile, or its file is not there (see the log)");
    return mErrors;
}

bool ScriptEdit::isUnusable(const ProgramCopy& before) {
    return !before.wasBroken &&
           (before.program->hasCompileError() || (before.wasLoaded && !before.program->isLoaded()));
}

bool ScriptEdit::hasChanged(const ProgramCopy& before) {
    return before.program->getSourceFile() != before.sourceFile ||
           settingsOf(*before.program) != before.settings;
}

bool ScriptEdit::readChangedProgramsAgain() {
    bool any = false;
    for (const ProgramCopy& before : mPrograms) {
        if (!before.wasLoaded || !hasChanged(before)) continue;
        loadAgain(*before.program);
        any = true;
    }
    return any;
}

bool ScriptEdit::handleEvent(Ogre::ScriptCompiler* compiler, Ogre::ScriptCompilerEvent* event,
                             void* result) {
    if (event->mType == CreateMaterialScriptCompilerEvent::eventType) {
        const auto& created = static_cast<const CreateMaterialScriptCompilerEvent&>(*event);
        if (Ogre::Material* found = changeMaterial(created.mName, created.mResourceGroup)) {
            *static_cast<Ogre::Material**>(result) = found;
            return true;
        }
    } else if (event->mType == CreateGpuProgramScriptCompilerEvent::eventType) {
        const auto& created = static_cast<const CreateGpuProgramScriptCompilerEvent&>(*event);
        if (Ogre::GpuProgram* found =
                changeProgram(created.mName, created.mResourceGroup, created.mSource)) {
            *static_cast<Ogre::GpuProgram**>(result) = found;
            return true;
        }
    }
    return mOthers != nullptr && mOthers->handleEvent(compiler, event, result);
}

Ogre::Material* ScriptEdit::changeMaterial(const Ogre::String& name, const Ogre::String& group) {
    auto& materials = Ogre::MaterialManager::getSingleton();
    const Ogre::MaterialPtr found = materials.getByName(name, group);
    if (!found) {
        mNewMaterials.emplace_back(name, group);
        return nullptr;
    }
    if (mMaterials.count(found) == 0) mMaterials[found] = copyOf(*found);
    mMaterialChanges(*found);
    // What the script no longer says is to be as if it had never been said.
    const Ogre::MaterialPtr plain = materials.create(name + "/Lixel/Plain", group);
    copy(*plain, found);
    materials.remove(plain);
    return found.get();
}

Ogre::GpuProgram* ScriptEdit::changeProgram(const Ogre::String& name, const Ogre::String& group,
                                            const Ogre::String& sourceFile) {
    const Ogre::GpuProgramPtr found =
        Ogre::GpuProgramManager::getSingleton().getByName(name, group);
    if (!found) return nullptr;
    if (std::ranges::find(mPrograms, found, &ProgramCopy::program) == mPrograms.end()) {
        ProgramCopy before{found,
                           found->getSourceFile(),
                           settingsOf(*found),
                           found->isLoaded(),
                           found->hasCompileError(),
                           nullptr};
        if (found->hasDefaultParameters())
            before.defaults =
                std::make_shared<Ogre::GpuProgramParameters>(*found->getDefaultParameters());
        mPrograms.push_back(std::move(before));
    }
    if (found->hasDefaultParameters()) {
        found->getDefaultParameters()->clearAutoConstants();
        found->getDefaultParameters()->removeAllSharedParameters();
    }
    // One that did not compile is to be tried again.
    if (found->hasCompileError()) found->unload();
    if (found->getSourceFile() != sourceFile || found->hasCompileError())
        found->setSourceFile(sourceFile);
    return found.get();
}

void ScriptEdit::undo() {
    auto& materials = Ogre::MaterialManager::getSingleton();
    for (const auto& [material, before] : mMaterials) {
        mMaterialChanges(*material);
        copy(*before, material);
    }
    for (const auto& [name, group] : mNewMaterials)
        if (const Ogre::MaterialPtr made = materials.getByName(name, group)) materials.remove(made);
    for (const ProgramCopy& before : mPrograms) {
        Ogre::GpuProgram& program = *before.program;
        const bool changed = hasChanged(before);
        for (const auto& [setting, value] : before.settings)
            if (program.getParameter(setting) != value) program.setParameter(setting, value);
        if (changed) {
            program.setSourceFile(before.sourceFile);
            if (before.wasLoaded) loadAgain(program);
        }
        if (before.defaults) program.getDefaultParameters()->copyConstantsFrom(*before.defaults);
    }
    mNewMaterials.clear();
}

void ScriptEdit::handleError(Ogre::ScriptCompiler* compiler, Ogre::uint32 code,
                             const Ogre::String& file, int line, const Ogre::String& message) {
    if (code != Ogre::ScriptCompiler::CE_DEPRECATEDSYMBOL)
        mErrors.push_back(file + "(" + std::to_string(line) +
                          "): " + Ogre::ScriptCompiler::formatErrorCode(code) + ": " + message);
    Ogre::ScriptCompilerListener& said = mOthers != nullptr ? *mOthers : mLogs;
    said.handleError(compiler, code, file, line, message);
}

Ogre::ConcreteNodeListPtr ScriptEdit::importFile(Ogre::ScriptCompiler* compiler,
                                                 const Ogre::String& name) {
    return mOthers != nullptr ? mOthers->importFile(compiler, name) : Ogre::ConcreteNodeListPtr();
}

} // namespace Lixel
