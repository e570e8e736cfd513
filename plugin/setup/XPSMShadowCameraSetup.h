#pragma once

#include "fit/technique/Xpsm.h"
#include "setup/FittedShadowCameraSetup.h"

namespace Lixel {

/** Extended perspective shadow maps (Gusev 2007): more texels near the viewer, none lost to
    casters behind it. The defaults need no tuning to the scene's scale. Spot lights get the uniform
    map. @see fit/technique/Xpsm.h */
class LIXEL_API XPSMShadowCameraSetup : public FittedShadowCameraSetup {
public:
    static std::shared_ptr<XPSMShadowCameraSetup> create() {
        return std::make_shared<XPSMShadowCameraSetup>();
    }

    /// Strength of the warp, a pure number: 0 is uniform, 1 LiSPSM's balance of near and far.
    /// @throws Ogre::InvalidParametersException unless finite and >= 0.
    void setStrength(Ogre::Real strength);
    Ogre::Real getStrength() const { return static_cast<Ogre::Real>(mOptions.strength); }

    /// Gusev's epsilonW: the least denominator in the focus region relative to the viewer's.
    /// @throws Ogre::InvalidParametersException unless in (0, 1].
    void setEpsilonW(Ogre::Real epsilonW);
    Ogre::Real getEpsilonW() const { return static_cast<Ogre::Real>(mOptions.epsilonW); }

    /// Whether the warp is weakened where that makes texels smaller in the picture, so that it is
    /// never worse than a uniform map's; otherwise it is literally the paper's. Default true.
    void setGuarded(bool guarded) { mOptions.guarded = guarded; }
    bool getGuarded() const { return mOptions.guarded; }

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;

private:
    XpsmOptions mOptions;
};

} // namespace Lixel
