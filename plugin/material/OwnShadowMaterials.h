#pragma once

#include <string>
#include <vector>

namespace Ogre {
class SceneManager;
} // namespace Ogre

namespace Lixel {

/** Clears the shadow caster and receiver materials that cannot be drawn, most often because a program
    of theirs did not compile: OGRE would draw with them, and crash.

    Of the techniques that a scene manager is about to draw; the scene manager's materials are used
    instead. Others are left alone: looking at them would compile their programs.
    @return a line for the log of each
*/
std::vector<std::string> dropUnusableShadowMaterials(Ogre::SceneManager& manager);

} // namespace Lixel
