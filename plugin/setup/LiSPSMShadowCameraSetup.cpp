#include "setup/LiSPSMShadowCameraSetup.h"

#include <OgreException.h>

#include <cmath>

namespace Lixel {

void LiSPSMShadowCameraSetup::setDistanceFactor(Ogre::Real factor) {
    if (!(factor > 0) || !std::isfinite(factor))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "factor: the multiple of n_opt must be finite and above 0",
                    "LiSPSMShadowCameraSetup::setDistanceFactor");
    mOptions.distanceFactor = factor;
}

ShadowFit LiSPSMShadowCameraSetup::fit(const ShadowProblem& problem,
                                       FitState& state) const noexcept {
    return fitLiSPSM(problem, mOptions, state);
}

} // namespace Lixel
