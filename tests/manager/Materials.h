#pragma once

#include <string>
#include <vector>

namespace Lixel::Tests {

/// Materials of all kinds that the render queue tells apart, made on first use: solid, transparent,
/// in several passes, with levels of detail, with and without shadows received. All draw one
/// colour.
const std::vector<std::string>& materials();

} // namespace Lixel::Tests
