#pragma once

#include <string>
#include <vector>

namespace Lixel {

/** Clears the shadow caster and receiver materials of techniques that cannot be drawn, most often
    because a program of theirs did not compile: OGRE would draw with them, and crash.

    The scene manager's are used instead. Materials that nothing has worn are left for later: looking
    at them would compile their programs. @return a line for the log of each
*/
std::vector<std::string> dropUnusableShadowMaterials();

} // namespace Lixel
