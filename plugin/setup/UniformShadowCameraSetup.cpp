#include "setup/UniformShadowCameraSetup.h"

#include "fit/technique/Uniform.h"

namespace Lixel {

ShadowFit UniformShadowCameraSetup::fit(const ShadowProblem& problem,
                                        FitState& state) const noexcept {
    return fitUniform(problem, mOptions, state);
}

} // namespace Lixel
