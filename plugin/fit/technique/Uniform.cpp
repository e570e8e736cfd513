#include "fit/technique/Uniform.h"

#include "fit/core/Fit.h"
#include "fit/technique/StableUniform.h"

namespace Lixel {

ShadowFit fitUniform(const ShadowProblem& problem, const UniformOptions& options,
                     FitState& state) noexcept {
    return fitWithRule(problem, state, [&](const WarpContext& context) {
        return options.stable ? stableMap(context) : WarpChoice{};
    });
}

ShadowFit fitUniform(const ShadowProblem& problem, FitState& state) noexcept {
    return fitUniform(problem, UniformOptions(), state);
}

} // namespace Lixel
