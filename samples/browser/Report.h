#pragma once

#include "browser/Options.h"
#include "common/Measurement.h"

namespace Lixel::Samples {

/// Draws, measures, and writes what the options ask for; prints a line per file.
/// @exception std::runtime_error where a file cannot be written
void drawHeadless(Stage& stage, const SampleScene& scene, const BrowserOptions& options);

/// Writes RGB bytes, row 0 at the top, as a PNG file.
void savePicture(const std::vector<std::uint8_t>& rgb, int width, int height,
                 const std::string& file);

} // namespace Lixel::Samples
