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
    @param scheme of the viewport, for which the shader system makes programs or does not
*/
std::vector<std::string> findMissingMaterials(Ogre::SceneManager& manager,
                                              const std::string& scheme);

} // namespace Lixel
