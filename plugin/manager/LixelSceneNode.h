#pragma once

#include "manager/MovedNodes.h"
#include "scene/NodeStore.h"

#include <memory>
#include <utility>

#include <OgreSceneNode.h>

namespace Lixel {

/// What all nodes of a scene manager share.
struct SceneNodes {
    NodeStore store;
    MovedNodes moved;
};

/** A node of LixelSceneManager: it keeps its box in the scene manager's store up to date.

    Its box is that of the objects attached to itself, as in OGRE's octree scene manager: a node's
    children are found by themselves, whatever its own box is.
*/
class LixelSceneNode : public Ogre::SceneNode {
public:
    /// @param nodes shared: OGRE destroys nodes after the scene manager that is derived from it
    LixelSceneNode(Ogre::SceneManager& creator, std::shared_ptr<SceneNodes> nodes)
        : SceneNode(&creator), mNodes(std::move(nodes)) {}
    LixelSceneNode(Ogre::SceneManager& creator, const Ogre::String& name,
                   std::shared_ptr<SceneNodes> nodes)
        : SceneNode(&creator, name), mNodes(std::move(nodes)) {}
    ~LixelSceneNode() override;

    void attachObject(Ogre::MovableObject* object) override;
    Ogre::MovableObject* detachObject(unsigned short index) override;
    void detachObject(Ogre::MovableObject* object) override;
    Ogre::MovableObject* detachObject(const Ogre::String& name) override;
    void detachAllObjects() override;

    /// The node has moved, or must be looked at again for another reason.
    void needUpdate(bool forceParentUpdate = false) override;
    void _update(bool updateChildren, bool parentHasChanged) override;
    /// OGRE calls it whenever the node, or something attached to it, may have moved.
    void _updateBounds() override;

private:
    friend class MovedNodes;

    NodeStore& store() const { return mNodes->store; }
    /// The same, at once: when the node's place in the world is derived anew.
    void updateFromParentImpl() const override;
    /// All below it come into the scene graph or leave it with it.
    void setParent(Ogre::Node* parent) override;
    void noteObjects();

    std::shared_ptr<SceneNodes> mNodes;
    NodeStore::Slot mSlot = NodeStore::NoSlot;
    MovedNodes::Index mMovedIndex = MovedNodes::NotListed;
    /// Whether something attached may be seen: cameras and lights are not.
    bool mMatters = false;
    /// Whether the log was told of numbers that are not finite, since they last were.
    bool mReported = false;
};

} // namespace Lixel
