#pragma once

#include <OgrePrerequisites.h>

#include <string>
#include <vector>

namespace Lixel {

/// Reads the files of a group's loaded programs again, and what they include. One that does not
/// compile stays as it was. @return a line for each of those
std::vector<std::string> reloadShaders(const Ogre::String& group);

} // namespace Lixel
