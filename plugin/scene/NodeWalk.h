#pragma once

#include "scene/NodeCuller.h"

#include <vector>

namespace Ogre {
class SceneManager;
class SceneNode;
} // namespace Ogre

namespace Lixel {

/** Collects the scene nodes whose objects may touch a volume.

    Nodes are culled by the bounds that OGRE culls by: those of a node with all its children in the
    default scene manager, those of octants in the octree one. What is left out is not drawn either.
    These bounds are this frame's wherever objects' boxes are: OGRE updates both at once. A scene
    manager of another kind may mean something else by them; all of its nodes are collected.

    @param nodes overwritten; good for as long as nobody else gets to change the scene
    @return whether bounds decided: an object whose box is all of its node's need not be asked again
*/
bool collectNodes(Ogre::SceneManager& manager, const NodeCuller& volume,
                  std::vector<Ogre::SceneNode*>& nodes);

} // namespace Lixel
