#pragma once

#include <string>

namespace Lixel::Samples {

/// The options of all of Lixel's setups, as a table in Markdown: the README's.
std::string optionsTable();

/// What scripts may say beside these, as another.
std::string settingsTable();

} // namespace Lixel::Samples
