#pragma once

#include <OgreMesh.h>

#include <string>

namespace Lixel::Samples {

/// A post, 4 high about the y axis and 1 wide, of eight boxes.
Ogre::MeshPtr makePost(const std::string& name);

/** One whose upper half is on a bone of its own, at (0, 2, 0), and whose animation "bend" turns
    that bone by 90 degrees about z in one second.
    @param shared whether the mesh has the vertices, instead of its part
*/
Ogre::MeshPtr makeJointedPost(const std::string& name, bool shared);

} // namespace Lixel::Samples
