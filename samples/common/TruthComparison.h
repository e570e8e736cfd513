#pragma once

#include "common/ShadowOracle.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace Lixel::Samples {

/** How a rendered picture's shadows differ from the truth.

    Percentages are of the counted pixels, those that are truly Lit or Shadowed; of the grazing ones
    for grazingError. 0 where there is no such pixel.
*/
struct ClassificationError {
    double error = 0.0;        ///< percent, acne + leak
    double acne = 0.0;         ///< percent drawn in shadow that are truly lit
    double leak = 0.0;         ///< percent drawn lit that are truly in shadow
    double grazingError = 0.0; ///< percent of grazing pixels drawn wrongly either way

    std::size_t lit = 0;      ///< truly Lit pixels
    std::size_t shadowed = 0; ///< truly Shadowed pixels
    std::size_t acnePixels = 0;
    std::size_t leakPixels = 0;
    std::size_t grazing = 0;
    std::size_t grazingWrong = 0;

    std::size_t counted() const { return lit + shadowed; }
};

/// A visibility from here on counts as lit: a filtered shadow is decided at one half.
constexpr std::uint8_t LitVisibility = 128;

/** Compares a picture with the truth.
    @param visibility one byte per pixel, row 0 at the top: how much of the light is seen, 0 to 255
    @exception std::invalid_argument unless there is a byte for each of the truth's pixels
*/
ClassificationError compareWithTruth(const ShadowTruth& truth,
                                     std::span<const std::uint8_t> visibility);

/** A picture of the differences: RGB bytes, row 0 at the top.

    Light grey: lit, rightly. Dark grey: in shadow, rightly. Red: acne. Blue: leak. Grazing pixels
    are the same, paler. Olive: unlit, no receiver or beyond the shadow distance. Black: background.
    @exception std::invalid_argument as compareWithTruth
*/
std::vector<std::uint8_t> paintComparison(const ShadowTruth& truth,
                                          std::span<const std::uint8_t> visibility);

/// The picture of the truth alone, in the same colours.
std::vector<std::uint8_t> paintTruth(const ShadowTruth& truth);

} // namespace Lixel::Samples
