#pragma once

#include <string>

namespace Lixel {

/// Writes a warning to OGRE's log, as Lixel's.
void logWarning(const std::string& message);

} // namespace Lixel
