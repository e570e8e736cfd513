#pragma once

#include "fit/geometry/Types.h"

namespace Lixel {

/// The cells of a grid over the viewer's picture, by rows from its bottom.
struct PictureCells {
    /// Columns come in fours.
    static constexpr std::size_t Columns = 20;
    static constexpr std::size_t Rows = 9;
    static constexpr std::size_t Count = Rows * Columns;

    /// The cell of a place in device coordinates, -1 to 1; Count where it is in none.
    static std::size_t at(const Vec2& ndc) {
        const double x = (ndc.x() + 1.0) / 2.0 * static_cast<double>(Columns);
        const double y = (ndc.y() + 1.0) / 2.0 * static_cast<double>(Rows);
        if (!(x >= 0.0 && x < static_cast<double>(Columns) && y >= 0.0 &&
              y < static_cast<double>(Rows)))
            return Count;
        return static_cast<std::size_t>(y) * Columns + static_cast<std::size_t>(x);
    }
};

} // namespace Lixel
