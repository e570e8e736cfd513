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

void fail(ScriptCompiler& compiler, const Ogre::AbstractNode& node, const std::string& what,
          Ogre::uint32 code = ScriptCompiler::CE_INVALIDPARAMETERS) {
    compiler.addError(code, node.file, static_cast<int>(node.line), what);
}

} // namespace

void PresetTranslator::beginFile(const std::string& file) {
    mFile = file;
    mDefined.clear();
    // The last one first: it puts back the listener that it found.
    mErrors.reset();
    mErrors = std::make_unique<ScriptErrors>();
}

std::vector<std::string> PresetTranslator::endFile() {
    mFile.clear();
    std::vector<std::string> lines = mErrors->lines();
    mErrors.reset();
    return lines;
}

Ogre::ScriptTranslator* PresetTranslator::getTranslator(const Ogre::AbstractNodePtr& node) {
    const bool isPreset =
        node->type == Ogre::ANT_OBJECT &&
        static_cast<const Ogre::ObjectAbstractNode&>(*node).cls == "shadow_camera_setup";
    return isPreset ? this : nullptr;
}

void PresetTranslator::translate(ScriptCompiler* compiler, const Ogre::AbstractNodePtr& node) {
    const auto& object = static_cast<const Ogre::ObjectAbstractNode&>(*node);
    const std::string& group = compiler->getResourceGroup();
    if (object.name.empty())
        return fail(*compiler, object, "a shadow_camera_setup needs a name",
                    ScriptCompiler::CE_OBJECTNAMEEXPECTED);
    if (!object.values.empty())
        return fail(*compiler, object,
                    "a shadow_camera_setup has one name, and '" + textOf(object.values) +
                        "' is more");

    const ShadowPresetPtr existing = ShadowCameraSetupManager::findByName(object.name, group);
    // Another group may have a file of that name.
    const bool isReadAgain = existing && !mFile.empty() && existing->getOrigin() == mFile &&
                             existing->getGroup() == group && !mDefined.contains(object.name);
    if (existing && !isReadAgain)
        return fail(*compiler, object,
                    "'" + object.name + "' is defined already, in " + existing->getOrigin() +
                        (existing->getGroup() == group ? "" : " of group " + existing->getGroup()));
    mDefined.insert(object.name);

    const auto [lines, areRight] = linesOf(*compiler, object);
    // What is right already stays as it was.
    if (isReadAgain && !areRight) return;
    ShadowPreset& preset = isReadAgain ? *existing : create(object, group);
    for (const auto& [line, what] : preset.define(lines))
        compiler->addError(ScriptCompiler::CE_INVALIDPARAMETERS, line.file,
                           static_cast<int>(line.line), what);
}

std::pair<std::vector<PresetLine>, bool>
PresetTranslator::linesOf(ScriptCompiler& compiler, const Ogre::ObjectAbstractNode& object) const {
    std::vector<PresetLine> lines;
    bool areRight = mErrors == nullptr || !mErrors->hasHiddenUnsetVariable();
    for (const Ogre::AbstractNodePtr& child : object.children) {
        if (child->type == Ogre::ANT_PROPERTY) {
            const auto& line = static_cast<const Ogre::PropertyAbstractNode&>(*child);
            const std::string value = textOf(line.values);
            const bool isCut = mErrors && mErrors->hasUnsetVariable(line.file, line.line);
            areRight = areRight && !isCut && !value.empty();
            if (isCut) continue;
            if (value.empty())
                fail(compiler, *child, "'" + line.name + "' has no value");
            else
                lines.push_back({line.name, value, child->file, child->line});
        } else if (child->type == Ogre::ANT_ATOM) {
            areRight = false;
            fail(compiler, *child, "'" + child->getValue() + "' has no value");
        } else if (child->type == Ogre::ANT_OBJECT) {
            areRight = false;
            fail(compiler, *child,
                 "'" + child->getValue() + "' does not belong into a shadow_camera_setup",
                 ScriptCompiler::CE_UNEXPECTEDTOKEN);
        }
    }
    return {lines, areRight};
}

} // namespace Lixel
