#pragma once

// OgreRenderQueueSortingGrouping.h of 14 needs it and does not include it.
#include <OgreIteratorWrapper.h>

#include <OgreRenderQueueSortingGrouping.h>
#include <OgreRenderSystem.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreViewport.h>

#include <string_view>
#include <typeinfo>

/** What differs between OGRE 1.12 and 14, under one name each.

    Whatever else Lixel calls is the same in all of these versions. For CMake it is in
    cmake/LixelOgre.cmake.
*/
namespace Lixel {

/// MovableObject::getMovableType of lights.
inline constexpr const char* LightTypeName = "Light";

#if OGRE_VERSION_MAJOR >= 13

/// Listens to a scene manager and to its shadow textures, which have a listener of their own since 13.
class SceneManagerListener : public Ogre::SceneManager::Listener, public Ogre::ShadowTextureListener {
};

inline void addSceneManagerListener(Ogre::SceneManager& manager, SceneManagerListener& listener) {
    manager.addListener(&listener);
    manager.addShadowTextureListener(&listener);
}

inline void removeSceneManagerListener(Ogre::SceneManager& manager,
                                       SceneManagerListener& listener) {
    manager.removeListener(&listener);
    manager.removeShadowTextureListener(&listener);
}

#else

class SceneManagerListener : public Ogre::SceneManager::Listener {};

inline void addSceneManagerListener(Ogre::SceneManager& manager, SceneManagerListener& listener) {
    manager.addListener(&listener);
}

inline void removeSceneManagerListener(Ogre::SceneManager& manager,
                                       SceneManagerListener& listener) {
    manager.removeListener(&listener);
}

#endif

/// Whether a scene manager is OGRE's default one, and of no class derived from it, which may draw by
/// other rules. Asked by name, because the class is in no public header since 14.
inline bool isDefaultSceneManager(const Ogre::SceneManager& manager) {
    return std::string_view(typeid(manager).name()) == "N4Ogre19DefaultSceneManagerE";
}

/// Clears all of a viewport at once. Viewport::clear is deprecated since 13.
inline void clearViewport(Ogre::Viewport& viewport, unsigned int buffers,
                          const Ogre::ColourValue& colour) {
    Ogre::RenderSystem& system = *Ogre::Root::getSingleton().getRenderSystem();
    Ogre::Viewport* const current = system._getViewport();
    system._setViewport(&viewport);
    system.clearFrameBuffer(buffers, colour);
    if (current != nullptr && current != &viewport) system._setViewport(current);
}

/// Calls `visit` with each priority's renderables of a queue group.
template <typename Visit>
void forPriorityGroups(const Ogre::RenderQueueGroup& group, const Visit& visit) {
#if OGRE_VERSION_MAJOR >= 13
    for (const auto& [priority, renderables] : group.getPriorityGroups())
        visit(*renderables);
#else
    for (auto groups = group.getIterator(); groups.hasMoreElements();)
        visit(*groups.getNext());
#endif
}

/// Whether a scene manager was given a shadow caster and receiver material. True where OGRE does not
/// let it be known, from 14 on.
struct ShadowMaterialAccess : Ogre::SceneManager {
#if OGRE_VERSION_MAJOR >= 14
    static bool hasCaster(Ogre::SceneManager&) { return true; }
    static bool hasReceiver(Ogre::SceneManager&) { return true; }
#else
    static bool hasCaster(Ogre::SceneManager& manager) {
        return (manager.*(&ShadowMaterialAccess::mShadowRenderer)).mShadowTextureCustomCasterPass !=
               nullptr;
    }
    static bool hasReceiver(Ogre::SceneManager& manager) {
        return (manager.*(&ShadowMaterialAccess::mShadowRenderer))
                   .mShadowTextureCustomReceiverPass != nullptr;
    }
#endif
};

} // namespace Lixel
