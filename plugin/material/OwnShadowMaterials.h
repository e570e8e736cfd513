#pragma once

#include <string>
#include <vector>

namespace Lixel {

/** Takes from all materials the shadow caster and receiver materials of their own that cannot be
    drawn, most often because a program of theirs did not compile: OGRE uses them unasked, and
    crashes.

    The scene manager's are used instead. @return a line for the log of each
*/
std::vector<std::string> dropUnusableShadowMaterials();

} // namespace Lixel
