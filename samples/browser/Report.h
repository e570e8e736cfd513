#pragma once

#include "browser/Options.h"
#include "common/Measurement.h"

namespace Lixel::Samples {

/// Draws, measures, and writes what the options ask for; prints a line per file.
/// @exception std::runtime_error where a file cannot be written
void drawHeadless(Stage& stage, const SampleScene& scene, const BrowserOptions& options);

} // namespace Lixel::Samples
