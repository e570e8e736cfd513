#include "reload/MaterialReload.h"

#include "reload/ScriptEdit.h"
#include "scene/Log.h"
#include "scene/OgreVersions.h"
#include "script/ScriptCheck.h"

#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreResourceGroupManager.h>
#include <OgreTechnique.h>

#include <optional>
#include <utility>

namespace Lixel {
namespace {

std::string textOf(const Ogre::String& file, const Ogre::String& group) {
    return Ogre::ResourceGroupManager::getSingleton().openResource(file, group)->getAsString();
}

/// Whose pass a scene manager draws its casters or receivers with; null where it is OGRE's own.
Ogre::MaterialPtr materialOf(const Ogre::Pass* pass) {
    if (pass == nullptr) return {};
    const Ogre::Material& material = *pass->getParent()->getParent();
    return Ogre::MaterialManager::getSingleton().getByName(material.getName(), material.getGroup());
}

/// The caster and receiver materials of all scene managers. They keep pointers into them, which have
/// to be taken anew where a material loses its techniques.
class ShadowMaterialsInUse {
public:
    ShadowMaterialsInUse() {
        for (const auto& [name, manager] : Ogre::Root::getSingleton().getSceneManagers())
            mUses.push_back({manager, materialOf(shadowCasterPassOf(*manager)),
                             materialOf(shadowReceiverPassOf(*manager))});
    }
    void take() const {
        for (const Use& use : mUses) {
            if (use.caster) use.manager->setShadowTextureCasterMaterial(use.caster);
            if (use.receiver) use.manager->setShadowTextureReceiverMaterial(use.receiver);
        }
    }

private:
    struct Use {
        Ogre::SceneManager* manager;
        Ogre::MaterialPtr caster;
        Ogre::MaterialPtr receiver;
    };
    std::vector<Use> mUses;
};

/// What is wrong with the structure of a script, which OGRE's parser may not survive.
std::optional<std::string> faultOf(const Ogre::String& text, const Ogre::String& file,
                                   const Ogre::String& group) {
    // As OGRE's compiler looks for what is imported: in other groups too.
    const auto read = [&](const std::string& name) -> std::optional<std::string> {
        const Ogre::DataStreamPtr stream =
            Ogre::ResourceGroupManager::getSingleton().openResource(name, group, nullptr, false);
        return stream ? std::optional<std::string>(stream->getAsString()) : std::nullopt;
    };
    const std::optional<ScriptFault> fault = findScriptFault(text, file, read);
    if (!fault) return std::nullopt;
    return fault->file + "(" + std::to_string(fault->line) + "): " + fault->what;
}

std::vector<std::string> reloadScript(const Ogre::String& file, const Ogre::String& group,
                                      const std::function<void(Ogre::Material&)>& changes) {
    const Ogre::String text = textOf(file, group);
    if (const std::optional<std::string> fault = faultOf(text, file, group)) {
        logWarning(*fault + "; what it defines stays as it was");
        return {*fault};
    }
    ScriptEdit edit(changes);
    std::vector<std::string> errors = edit.parse(text, file, group);
    if (!errors.empty()) edit.undo();
    return errors;
}

} // namespace

std::vector<std::string>
reloadMaterials(const Ogre::String& group,
                const std::function<void(Ogre::Material&)>& materialChanges) {
    const ShadowMaterialsInUse shadowMaterials;
    std::vector<std::string> errors;
    for (const char* const pattern : {"*.program", "*.material"}) {
        const Ogre::StringVectorPtr files =
            Ogre::ResourceGroupManager::getSingleton().findResourceNames(group, pattern);
        for (const Ogre::String& file : *files) {
            // Listed from the disk, but OGRE opens what was there when it looked into the location.
            if (!Ogre::ResourceGroupManager::getSingleton().resourceExists(group, file)) continue;
            for (std::string& error : reloadScript(file, group, materialChanges))
                errors.push_back(std::move(error));
        }
    }
    shadowMaterials.take();
    return errors;
}

} // namespace Lixel
