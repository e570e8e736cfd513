#include "fit/Uniform.h"

#include "fit/Fit.h"

namespace Lixel {

ShadowFit fitUniform(const ShadowProblem& problem, FitState& state) noexcept {
    return fitWithRule(problem, state, [](const WarpContext&) { return WarpChoice{}; });
}

} // namespace Lixel
