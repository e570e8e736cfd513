#pragma once

#include "fit/FitState.h"

namespace Lixel {

/** The uniform shadow map (Williams 1978), focused: warp 0.

    Texels are squares of one size on any plane across the light. What a warped technique must not
    do worse than.

    @return one map, or the reason why there is none. @see ShadowFit
*/
LIXEL_API ShadowFit fitUniform(const ShadowProblem& problem, FitState& state) noexcept;

} // namespace Lixel
