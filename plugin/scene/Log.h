#pragma once

#include "fit/geometry/Types.h"

#include <string>

namespace Lixel {

/// Writes a warning to OGRE's log, as Lixel's.
LIXEL_API void logWarning(const std::string& message);

} // namespace Lixel
