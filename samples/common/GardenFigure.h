#pragma once

#include <Ogre.h>

#include <string>

namespace Lixel::Samples {

/** A gardener of 13 bones and five materials, 1.8 m tall with the hat.

    The mesh stands at the origin and faces +z, its arms stretched out to both sides.
    @param name of the mesh and, with "/bones" after it, of its skeleton; others of the name are
    replaced
*/
Ogre::MeshPtr gardenerMesh(const std::string& name);

/// Has a gardener walk: bones of this entity stay where they are put.
void poseWalking(Ogre::Entity& gardener);

/// Where the gardener's left hand is in the pose, relative to the entity's node.
Ogre::Vector3 leftHandOf(Ogre::Entity& gardener);

} // namespace Lixel::Samples
