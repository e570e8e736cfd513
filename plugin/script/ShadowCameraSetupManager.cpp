#include "script/ShadowCameraSetupManager.h"

#include "scene/NameList.h"
#include "script/PresetTranslator.h"
#include "script/PresetUse.h"
#include "script/ScriptCheck.h"

#include <OgreArchive.h>
#include <OgreDataStream.h>
#include <OgreException.h>
#include <OgreLogManager.h>
#include <OgreResourceGroupManager.h>
#include <OgreScriptCompiler.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace Lixel {
namespace {

ShadowCameraSetupManager* theManager = nullptr;

const char* const ResourceType = "ShadowCameraSetup";
const char* const Pattern = "*.shadow";
/// OGRE's script compiler has 90: what its scripts define is there before.
constexpr Ogre::Real LoadOrder = 95;

/// As OGRE's script compiler logs its errors. @return the error as a line
std::string logScriptError(const std::string& file, unsigned line, const std::string& what) {
    Ogre::LogManager::getSingleton().logError("ScriptCompiler - " + what + " in " + file + "(" +
                                              std::to_string(line) + "); the file is left out");
    return file + "(" + std::to_string(line) + "): " + what + "; the file is left out";
}

/// Without the byte order mark that some editors begin files with, and OGRE takes for a word.
std::string withoutMark(const std::string& text) {
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

Ogre::DataStreamPtr streamOf(const std::string& text, const std::string& name) {
    // It reads from its own copy.
    auto* const stream = new Ogre::MemoryDataStream(name, text.size(), true);
    std::copy(text.begin(), text.end(), stream->getPtr());
    return Ogre::DataStreamPtr(stream);
}

/// Clears import caches that OGRE leaves filled after an exception.
void clearCompiler(const std::string& group) {
    Ogre::DataStreamPtr nothing = streamOf("", "");
    Ogre::ScriptCompilerManager::getSingleton().parseScript(nothing, group);
}

std::optional<std::string> loadText(const std::string& file, const std::string& group) {
    const Ogre::DataStreamPtr stream =
        Ogre::ResourceGroupManager::getSingleton().openResource(file, group, nullptr, false);
    return stream ? std::optional(stream->getAsString()) : std::nullopt;
}

} // namespace

ShadowCameraSetupManager::ShadowCameraSetupManager()
    : mTranslator(std::make_unique<PresetTranslator>()) {
    if (theManager != nullptr)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALID_STATE,
                    "there is a ShadowCameraSetupManager already: Plugin_Lixel makes one",
                    "ShadowCameraSetupManager");
    theManager = this;
    mResourceType = ResourceType;
    mLoadOrder = LoadOrder;
    mScriptPatterns.push_back(Pattern);
    auto& compilers = Ogre::ScriptCompilerManager::getSingleton();
    compilers.registerCustomWordId("shadow_camera_setup");
    compilers.addTranslatorManager(mTranslator.get());
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    groups._registerResourceManager(mResourceType, this);
    groups._registerScriptLoader(this);
}

ShadowCameraSetupManager::~ShadowCameraSetupManager() {
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    groups._unregisterScriptLoader(this);
    groups._unregisterResourceManager(mResourceType);
    Ogre::ScriptCompilerManager::getSingleton().removeTranslatorManager(mTranslator.get());
    theManager = nullptr;
}

ShadowCameraSetupManager& ShadowCameraSetupManager::getSingleton() {
    if (theManager == nullptr)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALID_STATE,
                    "there is no ShadowCameraSetupManager: Plugin_Lixel is not loaded",
                    "ShadowCameraSetupManager::getSingleton");
    return *theManager;
}

ShadowPresetPtr ShadowCameraSetupManager::findByName(const Ogre::String& name,
                                                     const Ogre::String& group) {
    if (theManager == nullptr) return nullptr;
    return std::static_pointer_cast<ShadowPreset>(theManager->getResourceByName(name, group));
}

ShadowPresetPtr ShadowCameraSetupManager::getByName(const Ogre::String& name,
                                                    const Ogre::String& group) {
    getSingleton();
    if (const ShadowPresetPtr found = findByName(name, group)) return found;
    std::vector<std::string> names;
    for (const ShadowPresetPtr& preset : list())
        names.push_back(preset->getName());
    OGRE_EXCEPT(Ogre::Exception::ERR_ITEM_NOT_FOUND,
                "name: there is no shadow_camera_setup '" + name + "'; there " +
                    (names.empty() ? "are none: are materials/scripts a resource location of the "
                                     "group General, and is it initialised?"
                                   : "are: " + joinNames(names)),
                "ShadowCameraSetupManager::getByName");
}

std::vector<ShadowPresetPtr> ShadowCameraSetupManager::list(const Ogre::String& group) {
    std::vector<ShadowPresetPtr> presets;
    for (const auto& [handle, resource] : getSingleton().getResourceIterator())
        if (group.empty() || resource->getGroup() == group)
            presets.push_back(std::static_pointer_cast<ShadowPreset>(resource));
    std::ranges::sort(presets, {}, [](const ShadowPresetPtr& preset) -> const std::string& {
        return preset->getName();
    });
    return presets;
}

void ShadowCameraSetupManager::parseScript(Ogre::DataStreamPtr& stream, const Ogre::String& group) {
    readScript(*stream, group);
}

std::vector<std::string> ShadowCameraSetupManager::readScript(Ogre::DataStream& stream,
                                                              const Ogre::String& group) {
    return parseAgain(withoutMark(stream.getAsString()), stream.getName(), group);
}

std::vector<std::string> ShadowCameraSetupManager::parseAgain(const std::string& text,
                                                              const std::string& file,
                                                              const Ogre::String& group) {
    const auto fault = findScriptFault(
        text, file, [&](const std::string& imported) { return loadText(imported, group); });
    if (fault) return {logScriptError(fault->file, fault->line, fault->what)};
    mTranslator->beginFile(file);
    std::vector<std::string> thrown;
    try {
        Ogre::DataStreamPtr copy = streamOf(text, file);
        Ogre::ScriptCompilerManager::getSingleton().parseScript(copy, group);
    } catch (const Ogre::Exception& exception) {
        thrown.push_back(logScriptError(file, 1, exception.getDescription()));
        clearCompiler(group);
    }
    std::vector<std::string> errors = mTranslator->endFile();
    std::ranges::move(thrown, std::back_inserter(errors));
    return errors;
}

std::vector<std::string> ShadowCameraSetupManager::reload(const Ogre::String& group) {
    std::vector<std::pair<ShadowPresetPtr, ShadowPreset::State>> before;
    for (const ShadowPresetPtr& preset : list())
        before.emplace_back(preset, preset->state());
    std::vector<std::string> errors = readGroup(group);
    const std::string refusal = useAllPresetsAgain();
    if (refusal.empty()) return errors;
    // Each preset is valid, but they conflict.
    for (const auto& [preset, state] : before)
        preset->restore(state);
    useAllPresetsAgain();
    errors.push_back("all shadow_camera_setups stay as they were: " + refusal);
    Ogre::LogManager::getSingleton().logError("Lixel: " + errors.back());
    return errors;
}

std::vector<std::string> ShadowCameraSetupManager::readGroup(const Ogre::String& group) {
    // From the archives themselves: the group's index has only what was there at its beginning.
    const Ogre::FileInfoListPtr files =
        Ogre::ResourceGroupManager::getSingleton().findResourceFileInfo(group, Pattern);
    std::set<std::string> read;
    std::vector<std::string> errors;
    for (const Ogre::FileInfo& file : *files)
        if (read.insert(file.filename).second)
            std::ranges::move(readScript(*file.archive->open(file.filename), group),
                              std::back_inserter(errors));
    return errors;
}

Ogre::Resource* ShadowCameraSetupManager::createImpl(const Ogre::String& name,
                                                     Ogre::ResourceHandle handle,
                                                     const Ogre::String& group, bool isManual,
                                                     Ogre::ManualResourceLoader* loader,
                                                     const Ogre::NameValuePairList*) {
    return OGRE_NEW ShadowPreset(this, name, handle, group, isManual, loader);
}

} // namespace Lixel
