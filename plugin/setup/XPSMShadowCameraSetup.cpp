#include "setup/XPSMShadowCameraSetup.h"

#include <OgreException.h>

#include <cmath>

namespace Lixel {

void XPSMShadowCameraSetup::setStrength(Ogre::Real strength) {
    if (!(strength >= 0) || !std::isfinite(strength))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "strength: the warp's strength must be finite and not negative",
                    "XPSMShadowCameraSetup::setStrength");
    mOptions.strength = strength;
}

void XPSMShadowCameraSetup::setEpsilonW(Ogre::Real epsilonW) {
    if (!(epsilonW > 0) || epsilonW > 1)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "epsilonW: the least denominator must be above 0 and at most 1",
                    "XPSMShadowCameraSetup::setEpsilonW");
    mOptions.epsilonW = epsilonW;
}

ShadowFit XPSMShadowCameraSetup::fit(const ShadowProblem& problem, FitState& state) const noexcept {
    return fitXpsm(problem, mOptions, state);
}

} // namespace Lixel
