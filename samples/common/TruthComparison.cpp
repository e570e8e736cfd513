#include "common/TruthComparison.h"

#include <array>
#include <stdexcept>

namespace Lixel::Samples {
namespace {

using Colour = std::array<std::uint8_t, 3>;

void requireSameSize(const ShadowTruth& truth, std::span<const std::uint8_t> visibility) {
    if (truth.pixels.size() != visibility.size())
        throw std::invalid_argument("the picture and the truth differ in size");
}

double percent(std::size_t part, std::size_t whole) {
    return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

Colour colourOf(PixelClass truth, bool drawnLit) {
    switch (truth) {
    case PixelClass::Background:
        return {0, 0, 0};
    case PixelClass::Lit:
        return drawnLit ? Colour{205, 205, 205} : Colour{230, 30, 30};
    case PixelClass::Shadowed:
        return drawnLit ? Colour{30, 60, 235} : Colour{75, 75, 75};
    case PixelClass::GrazingLit:
        return drawnLit ? Colour{225, 222, 205} : Colour{240, 160, 150};
    case PixelClass::GrazingShadowed:
        return drawnLit ? Colour{150, 165, 240} : Colour{110, 108, 95};
    case PixelClass::NotReceiver:
    case PixelClass::BeyondShadowDistance:
    case PixelClass::Unlit:
        break;
    }
    return {52, 50, 30};
}

void append(std::vector<std::uint8_t>& picture, const Colour& colour) {
    picture.insert(picture.end(), colour.begin(), colour.end());
}

} // namespace

ClassificationError compareWithTruth(const ShadowTruth& truth,
                                     std::span<const std::uint8_t> visibility) {
    requireSameSize(truth, visibility);
    ClassificationError result;
    for (std::size_t i = 0; i < visibility.size(); ++i) {
        const bool drawnLit = visibility[i] >= LitVisibility;
        switch (truth.pixels[i]) {
        case PixelClass::Lit:
            ++result.lit;
            result.acnePixels += drawnLit ? 0 : 1;
            break;
        case PixelClass::Shadowed:
            ++result.shadowed;
            result.leakPixels += drawnLit ? 1 : 0;
            break;
        case PixelClass::GrazingLit:
            ++result.grazing;
            result.grazingWrong += drawnLit ? 0 : 1;
            break;
        case PixelClass::GrazingShadowed:
            ++result.grazing;
            result.grazingWrong += drawnLit ? 1 : 0;
            break;
        default:
            break;
        }
    }
    result.acne = percent(result.acnePixels, result.counted());
    result.leak = percent(result.leakPixels, result.counted());
    result.error = percent(result.acnePixels + result.leakPixels, result.counted());
    result.grazingError = percent(result.grazingWrong, result.grazing);
    return result;
}

std::vector<std::uint8_t> paintComparison(const ShadowTruth& truth,
                                          std::span<const std::uint8_t> visibility) {
    requireSameSize(truth, visibility);
    std::vector<std::uint8_t> picture;
    picture.reserve(visibility.size() * 3);
    for (std::size_t i = 0; i < visibility.size(); ++i)
        append(picture, colourOf(truth.pixels[i], visibility[i] >= LitVisibility));
    return picture;
}

std::vector<std::uint8_t> paintTruth(const ShadowTruth& truth) {
    std::vector<std::uint8_t> picture;
    picture.reserve(truth.pixels.size() * 3);
    for (const PixelClass pixel : truth.pixels)
        append(picture,
               colourOf(pixel, pixel == PixelClass::Lit || pixel == PixelClass::GrazingLit));
    return picture;
}

} // namespace Lixel::Samples
