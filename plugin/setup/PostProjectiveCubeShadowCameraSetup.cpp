#include "setup/PostProjectiveCubeShadowCameraSetup.h"

#include "setup/DivisionMemory.h"

namespace Lixel {

ShadowFit PostProjectiveCubeShadowCameraSetup::fit(const ShadowProblem& problem,
                                                   FitState& state) const noexcept {
    const bool isFace = problem.part != nullptr && !problem.part->wsExit.isZero(0.0);
    return isFace ? TechniqueShadowCameraSetup::fit(problem, state)
                  : fitMap(problem, PsmOptions{.slideBack = getOptions().slideBack}, state);
}

LightPartition PostProjectiveCubeShadowCameraSetup::divide(const ShadowProblem& problem,
                                                           std::size_t maps,
                                                           DivisionMemory& memory) const noexcept {
    if (maps == 1) return FittedShadowCameraSetup::divide(problem, maps, memory);
    const LightPartition faces = facesOfView(problem.viewer, problem.light, memory.aim);
    // A light too wide for one map may still need no more than a spot.
    if (needsParts(problem.light) && faces.count > maps)
        return FittedShadowCameraSetup::divide(problem, maps, memory);
    return faces;
}

} // namespace Lixel
