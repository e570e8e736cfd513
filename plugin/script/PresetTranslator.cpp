#include "script/PresetTranslator.h"

#include "script/ShadowCameraSetupManager.h"
#include "script/ShadowPreset.h"

#include <OgreScriptCompiler.h>

#include <vector>

namespace Lixel {
namespace {

using Ogre::ScriptCompiler;

/// The values of a line, as the script has them.
std::string textOf(const Ogre::AbstractNodeList& values) {
    std::string text;
    for (const Ogre::AbstractNodePtr& value : values) {
        if (!text.empty()) text += ' ';
        text += value->getValue();
    }
    return text;
}

ShadowPreset& create(const Ogre::ObjectAbstractNode& object, const Ogre::String& group) {
    const Ogre::ResourcePtr preset =
        ShadowCameraSetupManager::getSingleton().createResource(object.name, group);
    preset->_notifyOrigin(object.file);
    return static_cast<ShadowPreset&>(*preset);
}

} // namespace

void PresetTranslator::beginFile(const std::string& file) {
    mFile = file;
    mDefined.clear();
    mSaid.clear();
    mErrors = 0;
}

std::size_t PresetTranslator::endFile() {
    mFile.clear();
    return mErrors;
}

Ogre::ScriptTranslator* PresetTranslator::getTranslator(const Ogre::AbstractNodePtr& node) {
    const bool isPreset =
        node->type == Ogre::ANT_OBJECT &&
        static_cast<const Ogre::ObjectAbstractNode&>(*node).cls == "shadow_camera_setup";
    return isPreset ? this : nullptr;
}

void PresetTranslator::translate(ScriptCompiler* compiler, const Ogre::AbstractNodePtr& node) {
    const auto& object = static_cast<const Ogre::ObjectAbstractNode&>(*node);
    bool hasErrors = false;
    const auto fail = [&](const std::string& file, unsigned line, const std::string& what,
                          Ogre::uint32 code = ScriptCompiler::CE_INVALIDPARAMETERS) {
        const bool isNew = mFile.empty() || file != mFile || mSaid.emplace(line, what).second;
        hasErrors = true;
        if (!isNew) return;
        ++mErrors;
        compiler->addError(code, file, static_cast<int>(line), what);
    };
    if (object.name.empty())
        return fail(object.file, object.line, "a shadow_camera_setup needs a name",
                    ScriptCompiler::CE_OBJECTNAMEEXPECTED);
    if (!object.values.empty())
        return fail(object.file, object.line,
                    "a shadow_camera_setup has one name, and '" + textOf(object.values) +
                        "' is more");

    const ShadowPresetPtr existing =
        ShadowCameraSetupManager::findByName(object.name, compiler->getResourceGroup());
    const bool isReadAgain = existing && existing->getOrigin() == mFile && !mFile.empty() &&
                             !mDefined.contains(object.name);
    if (existing && !isReadAgain)
        return fail(object.file, object.line,
                    "'" + object.name + "' is defined already, in " + existing->getOrigin());
    mDefined.insert(object.name);

    std::vector<PresetLine> lines;
    for (const Ogre::AbstractNodePtr& child : object.children) {
        if (child->type == Ogre::ANT_PROPERTY) {
            const auto& line = static_cast<const Ogre::PropertyAbstractNode&>(*child);
            const std::string value = textOf(line.values);
            if (value.empty())
                fail(child->file, child->line, "'" + line.name + "' has no value");
            else
                lines.push_back({line.name, value, child->file, child->line});
        } else if (child->type == Ogre::ANT_ATOM) {
            fail(child->file, child->line, "'" + child->getValue() + "' has no value");
        } else if (child->type == Ogre::ANT_OBJECT) {
            fail(child->file, child->line,
                 "'" + child->getValue() + "' does not belong into a shadow_camera_setup",
                 ScriptCompiler::CE_UNEXPECTEDTOKEN);
        }
    }
    // What is right already stays as it was.
    if (isReadAgain && hasErrors) return;
    ShadowPreset& preset = isReadAgain ? *existing : create(object, compiler->getResourceGroup());
    for (const auto& [line, what] : preset.define(lines))
        fail(line.file, line.line, what);
}

} // namespace Lixel
