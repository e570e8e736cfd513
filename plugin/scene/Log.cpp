#include "scene/Log.h"

#include <OgreLogManager.h>

namespace Lixel {

void logWarning(const std::string& message) {
    Ogre::LogManager::getSingleton().logWarning("Lixel: " + message);
}

} // namespace Lixel
