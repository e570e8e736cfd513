#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace Lixel::Samples {

/// Writes RGB bytes, row 0 at the top, as a PNG file. There has to be a Root.
/// @exception std::runtime_error where it cannot be written
void savePicture(const std::vector<std::uint8_t>& rgb, int width, int height,
                 const std::string& file);

} // namespace Lixel::Samples
