#pragma once

#include <string>
#include <vector>

namespace Lixel {

/** Clears the shadow caster and receiver materials of techniques that cannot be drawn, most often
    because a program of theirs did not compile: OGRE would draw with them, and crash.

    The scene manager's are used instead. @return a line for the log of each
*/
std::vector<std::string> dropUnusableShadowMaterials();

} // namespace Lixel
