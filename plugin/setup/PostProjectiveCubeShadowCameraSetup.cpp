#include "setup/PostProjectiveCubeShadowCameraSetup.h"

#include "fit/technique/Psm.h"
#include "setup/DivisionMemory.h"

#include <OgreException.h>

#include <cmath>

namespace Lixel {

void PostProjectiveCubeShadowCameraSetup::setSlideBack(Ogre::Real slideBack) {
    if (!(slideBack >= 0) || !std::isfinite(slideBack))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "slideBack: the slide-back must be finite and not negative",
                    "PostProjectiveCubeShadowCameraSetup::setSlideBack");
    mOptions.slideBack = slideBack;
}

ShadowFit PostProjectiveCubeShadowCameraSetup::fit(const ShadowProblem& problem,
                                                   FitState& state) const noexcept {
    const bool isFace = problem.part != nullptr && !problem.part->wsExit.isZero(0.0);
    if (!isFace) return fitPsm(problem, {.slideBack = mOptions.slideBack}, state);
    return fitPostProjectiveFace(problem, mOptions, state);
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
