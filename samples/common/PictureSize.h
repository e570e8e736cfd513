#pragma once

#include <cstdio>
#include <optional>
#include <string>

namespace Lixel::Samples {

struct PictureSize {
    int width = 0;  ///< pixels
    int height = 0; ///< pixels
};

/// "WxH", such as 800x600, both from 1 to 16384; null for any other text.
inline std::optional<PictureSize> parsePictureSize(const std::string& text) {
    char rest = 0;
    PictureSize size;
    if (std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest) != 2 ||
        size.width < 1 || size.height < 1 || size.width > 16384 || size.height > 16384)
        return std::nullopt;
    return size;
}

/// What to tell a user who gave another text.
inline std::string noPictureSize(const std::string& text) {
    return "'" + text + "' is not WIDTHxHEIGHT, such as 800x600";
}

} // namespace Lixel::Samples
