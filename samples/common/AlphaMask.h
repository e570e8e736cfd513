#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace Lixel::Samples {

/** The alpha of a texture that cuts holes, as a program that reads the full-size picture sees it.

    Smaller mip levels do not count: they blur the alpha, so that what they cut depends on the
    distance. Far away a picture therefore differs from this by a fringe of about a pixel.
*/
struct AlphaMask {
    /// What lies beyond texture coordinates 0 and 1.
    enum class Wrap : std::uint8_t { Repeat, Mirror, Clamp, Border };

    int width = 0;                   ///< texels
    int height = 0;                  ///< texels
    std::vector<std::uint8_t> alpha; ///< row by row, the first at v = 0
    std::array<Wrap, 2> wrap{};      ///< of u and of v
    std::uint8_t borderAlpha = 255;  ///< what Wrap::Border finds beyond the borders
    bool bilinear = true;            ///< between texel centres; else the nearest texel's
    double least = 128.0;            ///< of 255: what has less is a hole

    /// Between 0 and 255, at finite texture coordinates.
    double alphaAt(const Eigen::Vector2d& uv) const;

    bool isHole(const Eigen::Vector2d& uv) const { return alphaAt(uv) < least; }

    /// Whether any texture coordinates are in a hole.
    bool hasHoles() const;
};

} // namespace Lixel::Samples
