#include "common/AlphaMask.h"

#include <algorithm>
#include <cmath>

namespace Lixel::Samples {
namespace {

/// The texel that a program is given for one beyond the texture; -1 for the border.
int wrappedTexel(AlphaMask::Wrap wrap, std::int64_t texel, int size) {
    const auto wrapped = [&](std::int64_t period) {
        const std::int64_t rest = texel % period;
        return static_cast<int>(rest < 0 ? rest + period : rest);
    };
    switch (wrap) {
    case AlphaMask::Wrap::Repeat:
        return wrapped(size);
    case AlphaMask::Wrap::Mirror: {
        const int there = wrapped(2 * std::int64_t{size});
        return there < size ? there : 2 * size - 1 - there;
    }
    case AlphaMask::Wrap::Clamp:
        return static_cast<int>(std::clamp<std::int64_t>(texel, 0, size - 1));
    case AlphaMask::Wrap::Border:
        break;
    }
    return texel >= 0 && texel < size ? static_cast<int>(texel) : -1;
}

double texelAlpha(const AlphaMask& mask, std::int64_t column, std::int64_t row) {
    const int x = wrappedTexel(mask.wrap[0], column, mask.width);
    const int y = wrappedTexel(mask.wrap[1], row, mask.height);
    if (x < 0 || y < 0) return mask.borderAlpha;
    return mask.alpha[static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) +
                      static_cast<std::size_t>(x)];
}

/// Farther out than this, floats no longer tell neighbouring texels apart anyway.
constexpr double FarthestTexel = 1e15;

} // namespace

double AlphaMask::alphaAt(const Eigen::Vector2d& uv) const {
    const double half = bilinear ? 0.5 : 0.0;
    const double x = std::clamp(uv.x() * width - half, -FarthestTexel, FarthestTexel);
    const double y = std::clamp(uv.y() * height - half, -FarthestTexel, FarthestTexel);
    const auto column = static_cast<std::int64_t>(std::floor(x));
    const auto row = static_cast<std::int64_t>(std::floor(y));
    if (!bilinear) return texelAlpha(*this, column, row);
    const double right = x - std::floor(x);
    const double below = y - std::floor(y);
    // Exact between equal ends, which `least` may equal too.
    const auto between = [](double a, double b, double share) { return a + share * (b - a); };
    const auto ofRow = [&](std::int64_t r) {
        return between(texelAlpha(*this, column, r), texelAlpha(*this, column + 1, r), right);
    };
    return between(ofRow(row), ofRow(row + 1), below);
}

bool AlphaMask::hasHoles() const {
    const bool bordered = std::ranges::count(wrap, Wrap::Border) > 0;
    if (bordered && borderAlpha < least) return true;
    // Between texels that are all drawn there is no hole.
    return std::ranges::any_of(alpha, [&](std::uint8_t texel) { return texel < least; });
}

} // namespace Lixel::Samples
