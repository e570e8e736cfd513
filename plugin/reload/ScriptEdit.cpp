#include "reload/ScriptEdit.h"

#include "reload/ProgramSettings.h"
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

void loadAgain(Ogre::GpuProgram& program) {
    program.unload();
    loadIfPossible(program);
}

} // namespace

ScriptEdit::ScriptEdit(std::function<void(Ogre::Material&)> materialChanges)
    : mMaterialChanges(std::move(materialChanges)) {}

ScriptEdit::~ScriptEdit() {
    for (const auto& [material, before] : mMaterials)
        Ogre::MaterialManager::getSingleton().remove(before);
}

std::vector<std::string> ScriptEdit::parse(const Ogre::String& text, const Ogre::String& file,
                                           const Ogre::String& group) {
    auto& setups = ShadowCameraSetupManager::getSingleton();
    std::vector<std::string> errors = setups.parseAgain(text, file, group);
    // Lines of parameters are about the uniforms that a program had when it was compiled.
    if (readChangedProgramsAgain()) errors = setups.parseAgain(text, file, group);
    for (const ProgramCopy& before : mPrograms)
        if (isUnusable(before))
            errors.push_back(file + ": program '" + before.program->getName() +
                             "' does not compile, or its file is not there (see the log)");
    return errors;
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
    return ScriptListener::handleEvent(compiler, event, result);
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
        setSettings(program, before.settings);
        if (changed) {
            program.setSourceFile(before.sourceFile);
            if (before.wasLoaded) loadAgain(program);
        }
        if (before.defaults) program.getDefaultParameters()->copyConstantsFrom(*before.defaults);
    }
    mNewMaterials.clear();
}

} // namespace Lixel
