#include "setup/PSMShadowCameraSetup.h"

#include <OgreException.h>

#include <cmath>

namespace Lixel {

void PSMShadowCameraSetup::setSlideBack(Ogre::Real slideBack) {
    if (!(slideBack >= 0) || !std::isfinite(slideBack))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "slideBack: the slide-back must be finite and not negative",
                    "PSMShadowCameraSetup::setSlideBack");
    mOptions.slideBack = slideBack;
}

ShadowFit PSMShadowCameraSetup::fit(const ShadowProblem& problem, FitState& state) const noexcept {
    return fitPsm(problem, mOptions, state);
}

} // namespace Lixel
