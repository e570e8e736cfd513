#pragma once

#include <string>

namespace Lixel::Samples {

/// The options of all of Lixel's setups, as a table in Markdown: the README's.
std::string optionsTable();

} // namespace Lixel::Samples
