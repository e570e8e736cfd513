#pragma once

#include "fit/geometry/Types.h"

namespace Lixel {

/// The i-th point of the R2 sequence in the unit square (Roberts 2018): evenly spread, however many
/// there are.
inline Vec2 lowDiscrepancy(std::size_t i) {
    const Vec2 t = Vec2(0.7548776662466927, 0.5698402909980532) * static_cast<double>(i);
    return {t.x() - std::floor(t.x()), t.y() - std::floor(t.y())};
}

} // namespace Lixel
