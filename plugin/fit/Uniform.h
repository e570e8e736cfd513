#pragma once

#include "fit/FitState.h"

namespace Lixel {

/** The uniform shadow map (Williams 1978), focused: warp 0.

    Texels are equal rectangles on any plane across the light: the focus region's smallest rectangle
    in as many parts as the map has texels. What a warped technique must not do worse than.

    @return one map, or the reason why there is none. @see ShadowFit
*/
LIXEL_API ShadowFit fitUniform(const ShadowProblem& problem, FitState& state) noexcept;

} // namespace Lixel
