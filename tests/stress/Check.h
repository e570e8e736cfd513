#pragma once

#include "Application.h"

#include <string>

namespace Lixel::Tests {

/// What checks have seen so far.
struct CheckCounts {
    std::size_t lights = 0;      ///< lights in pictures that were judged
    std::size_t shadowed = 0;    ///< of these, with 30 pixels or more in shadow
    std::size_t lookedTwice = 0; ///< that were drawn again to judge them
};

/** Compares the frame that was just drawn with exact shadows, on every screen.

    @param pictureFile PPM file for what is wrong and how: red should be lit, blue dark
    @return what is wrong; empty where nothing is, or where nothing is known of the picture (OGRE's
    own setups, textures that Lixel's materials cannot read, stencil shadows, ...)
*/
std::string findWrongShadow(Application& application, CheckCounts& counts,
                            const std::string& pictureFile);

} // namespace Lixel::Tests
