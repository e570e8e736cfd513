#pragma once

#include "scene/NodeStore.h"

#include <span>
#include <vector>

namespace Lixel {

/** Collects the objects that may touch a volume.

    Under LixelSceneManager they are found in its store. Otherwise nodes are culled by the bounds
    that OGRE culls by: those of a node with all its children in the default scene manager, those of
    octants in the octree one. What is left out is not drawn either. These bounds are this frame's
    wherever objects' boxes are: OGRE updates both at once. A scene manager of another kind may mean
    something else by them; all of its objects are collected.
*/
class NodeWalk {
public:
    struct Object {
        Ogre::MovableObject* object;
        /// Whether bounds decided on it: it need not be compared with the volume again.
        bool touches;
        /// In the scene manager's store; NoSlot for what is not the only object of a node there.
        NodeStore::Slot slot = NodeStore::NoSlot;
        /// NodeStore::Known
        unsigned known = NodeStore::NothingKnown;
    };

    /// @return good for as long as nobody else gets to change the scene
    std::span<const Object> collect(Ogre::SceneManager& manager, const NodeCuller& volume);

private:
    void collectFromStore(const NodeStore& store, const NodeCuller& volume);

    std::vector<Object> mObjects;
    std::vector<Ogre::SceneNode*> mNodes;
    NodeSearch mSearch;
};

} // namespace Lixel
