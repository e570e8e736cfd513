#pragma once

#include "fit/technique/Trapezoidal.h"
#include "setup/FittedShadowCameraSetup.h"

namespace Lixel {

/** Trapezoidal shadow maps (Martin and Tan 2004): what is seen up to a focus distance takes 80 % of
    the map. @see fit/technique/Trapezoidal.h */
class LIXEL_API TrapezoidalShadowCameraSetup : public FittedShadowCameraSetup {
public:
    static std::shared_ptr<TrapezoidalShadowCameraSetup> create() {
        return std::make_shared<TrapezoidalShadowCameraSetup>();
    }

    /// Up to where the focus reaches, as a fraction of the distance from the viewer to the farthest
    /// receiver that matters. Default 0.25.
    /// @throws Ogre::InvalidParametersException unless in (0, 1).
    void setFocusDistance(Ogre::Real fraction);
    Ogre::Real getFocusDistance() const { return static_cast<Ogre::Real>(mOptions.focusDistance); }

    /// How much of the map that takes. Default 0.8, the paper's 80 % rule.
    /// @throws Ogre::InvalidParametersException unless in (0, 1).
    void setFocusShare(Ogre::Real share);
    Ogre::Real getFocusShare() const { return static_cast<Ogre::Real>(mOptions.focusShare); }

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;

private:
    TrapezoidalOptions mOptions;
};

} // namespace Lixel
