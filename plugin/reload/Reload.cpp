#include "reload/Reload.h"

#include "reload/MaterialReload.h"
#include "reload/ShaderReload.h"
#include "script/ShadowCameraSetupManager.h"
#include "setup/MapPlan.h"

#include <OgreException.h>
#include <OgreResourceGroupManager.h>
#include <OgreRoot.h>

#include <algorithm>
#include <iterator>

namespace Lixel {
namespace {

std::vector<ReloadListener*>& listeners() {
    static std::vector<ReloadListener*> all;
    return all;
}

} // namespace

void addReloadListener(ReloadListener& listener) {
    removeReloadListener(listener);
    listeners().push_back(&listener);
}

void removeReloadListener(ReloadListener& listener) {
    std::erase(listeners(), &listener);
}

std::vector<std::string> reload(const Ogre::String& group) {
    if (Ogre::Root::getSingletonPtr() == nullptr)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALID_STATE, "there is no Ogre::Root", "Lixel::reload");
    if (!Ogre::ResourceGroupManager::getSingleton().resourceGroupExists(group))
        OGRE_EXCEPT(Ogre::Exception::ERR_ITEM_NOT_FOUND,
                    "group: there is no resource group '" + group + "'", "Lixel::reload");
    // Programs first: materials bind what these have now.
    std::vector<std::string> errors = reloadShaders(group);
    for (ReloadListener* const listener : listeners())
        std::ranges::move(listener->shadersChange(group), std::back_inserter(errors));
    std::ranges::move(reloadMaterials(group,
                                      [](Ogre::Material& material) {
                                          for (ReloadListener* const listener : listeners())
                                              listener->materialChanges(material);
                                      }),
                      std::back_inserter(errors));
    std::ranges::move(ShadowCameraSetupManager::getSingleton().reload(group),
                      std::back_inserter(errors));
    // Materials and programs changed in place.
    redrawShadowMaps();
    return errors;
}

} // namespace Lixel
