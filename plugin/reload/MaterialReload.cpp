#include "reload/MaterialReload.h"

#include "reload/ScriptEdit.h"
#include "scene/OgreVersions.h"

#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreResourceGroupManager.h>
#include <OgreTechnique.h>

#include <algorithm>
#include <iterator>

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

std::vector<std::string> reloadScript(const Ogre::String& file, const Ogre::String& group,
                                      const std::function<void(Ogre::Material&)>& changes) {
    ScriptEdit edit(changes);
    std::vector<std::string> errors = edit.parse(textOf(file, group), file, group);
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
            std::ranges::move(reloadScript(file, group, materialChanges),
                              std::back_inserter(errors));
        }
    }
    shadowMaterials.take();
    return errors;
}

} // namespace Lixel
