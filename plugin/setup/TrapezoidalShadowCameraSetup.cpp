#include "setup/TrapezoidalShadowCameraSetup.h"

#include <OgreException.h>

namespace Lixel {

void TrapezoidalShadowCameraSetup::setFocusDistance(Ogre::Real fraction) {
    if (!(fraction > 0 && fraction < 1))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "fraction: the focus distance must be above 0 and below 1",
                    "TrapezoidalShadowCameraSetup::setFocusDistance");
    mOptions.focusDistance = fraction;
}

void TrapezoidalShadowCameraSetup::setFocusShare(Ogre::Real share) {
    if (!(share > 0 && share < 1))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "share: the focus' share of the map must be above 0 and below 1",
                    "TrapezoidalShadowCameraSetup::setFocusShare");
    mOptions.focusShare = share;
}

ShadowFit TrapezoidalShadowCameraSetup::fit(const ShadowProblem& problem,
                                            FitState& state) const noexcept {
    return fitTrapezoidal(problem, mOptions, state);
}

} // namespace Lixel
