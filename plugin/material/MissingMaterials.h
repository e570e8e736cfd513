#pragma once

#include <string>
#include <vector>

namespace Ogre {
class SceneManager;
} // namespace Ogre

namespace Lixel {

/** Says which of a scene manager's shadow materials are missing, where OGRE's own cannot stand in.

    OGRE's own have no programs, and can be drawn by a fixed function or by the shader system's
    programs; without either OGRE throws in the midst of a frame. One line for each, for the log.
    None with OGRE 14 and newer, which does not let it be known.
*/
std::vector<std::string> findMissingMaterials(Ogre::SceneManager& manager);

} // namespace Lixel
