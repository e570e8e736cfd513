#pragma once

#include "manager/VisibleObjects.h"
#include "scene/OgreVersions.h"

#include <memory>

namespace Lixel {
/// @addtogroup LixelSceneManager
/// @{

/** A scene manager that knows the bounds of all nodes in flat memory.

        Ogre::SceneManager* scene = root->createSceneManager("LixelSceneManager");

    It draws what OGRE's default scene manager draws, in less time: what a camera sees, and what
    casts shadows on it, is found by a scan of boxes that are kept up to date as nodes move. Lixel's
    setups find receivers and casters in them too.

    What is different from OGRE's default scene manager:
    - `SceneNode::_getWorldAABB()` is the box of the objects of that node alone, as in OGRE's octree
      scene manager. A node is drawn where that box is in view: what is attached to a parent is not
      drawn only because a child is in view.
    - Debug drawing (setDisplaySceneNodes, showBoundingBoxes) shows nodes with objects of their own.
    - A node at a place that is not finite is not drawn, and named in the log once; OGRE aborts.
    - Objects are queued in the order in which their nodes first had something attached, not in the
      order of the graph. It makes a difference only between surfaces of one material at one depth.
*/
class LIXEL_API LixelSceneManager : public Ogre::SceneManager {
public:
    /// What the factory is registered as.
    static constexpr const char* TypeName = "LixelSceneManager";

    explicit LixelSceneManager(const Ogre::String& name);
    ~LixelSceneManager() override;

    const Ogre::String& getTypeName() const override;
    void _updateSceneGraph(Ogre::Camera* camera) override;
    void _findVisibleObjects(Ogre::Camera* camera, Ogre::VisibleObjectsBoundsInfo* visibleBounds,
                             bool onlyShadowCasters) override;

private:
    Ogre::SceneNode* createSceneNodeImpl() override;
    Ogre::SceneNode* createSceneNodeImpl(const Ogre::String& name) override;

    std::shared_ptr<NodeStore> mStore;
    VisibleObjects mVisible;
};

/// Makes LixelSceneManager; the plugin registers one.
class LIXEL_API LixelSceneManagerFactory : public NamedSceneManagerFactory {
public:
    LixelSceneManagerFactory() : NamedSceneManagerFactory(LixelSceneManager::TypeName) {}
    Ogre::SceneManager* createInstance(const Ogre::String& name) override;
    void destroyInstance(Ogre::SceneManager* instance) override;
};

/// @}
} // namespace Lixel
