#pragma once

#include <cstddef>
#include <string>

namespace Lixel {

/// Why no program of the shader system can be shadowed here; empty where some can.
std::string whatKeepsFromShadowing();

/// How many texture units a pass may have here.
std::size_t greatestUnits();

} // namespace Lixel
