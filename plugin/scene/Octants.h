#pragma once

#include "scene/NodeCuller.h"

#include <vector>

namespace Ogre {
class SceneManager;
class SceneNode;
} // namespace Ogre

namespace Lixel {

/** Collects the nodes that may touch a volume from the octants of OGRE's octree scene manager.

    The plugin's headers tell how octants are laid out. Nothing of it is linked, so a program
    without that scene manager need not have it.

    @param nodes appended to
    @return false, with nothing done, for a scene manager of another kind
*/
bool collectFromOctants(Ogre::SceneManager& manager, const NodeCuller& volume,
                        std::vector<Ogre::SceneNode*>& nodes);

} // namespace Lixel
