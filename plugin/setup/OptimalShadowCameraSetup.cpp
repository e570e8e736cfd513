#include "setup/OptimalShadowCameraSetup.h"

#include <OgreException.h>

namespace Lixel {

void OptimalShadowCameraSetup::setSamples(int samples) {
    if (samples < 1 || samples > 4096)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "samples: there must be between 1 and 4096",
                    "OptimalShadowCameraSetup::setSamples");
    mOptions.samples = samples;
}

void OptimalShadowCameraSetup::setEvaluations(int evaluations) {
    if (evaluations < 8 || evaluations > 4096)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "evaluations: there must be between 8 and 4096",
                    "OptimalShadowCameraSetup::setEvaluations");
    mOptions.evaluations = evaluations;
}

ShadowFit OptimalShadowCameraSetup::fit(const ShadowProblem& problem,
                                        FitState& state) const noexcept {
    return fitOptimal(problem, mOptions, state);
}

} // namespace Lixel
