#pragma once

#include <OgrePrerequisites.h>

#include <functional>
#include <string>
#include <vector>

namespace Lixel {

/** Parses a group's `.program` and `.material` scripts again, into the materials and programs that
    there are.

    @param materialChanges is told of each material before it loses its techniques
    @return what is wrong, a line each; what a script with an error defines stays as it was
*/
std::vector<std::string>
reloadMaterials(const Ogre::String& group,
                const std::function<void(Ogre::Material&)>& materialChanges);

} // namespace Lixel
