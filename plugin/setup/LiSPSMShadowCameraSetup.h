#pragma once

#include "fit/technique/LiSPSM.h"
#include "setup/FittedShadowCameraSetup.h"

namespace Lixel {

/** Light space perspective shadow maps (Wimmer, Scherzer, Purgathofer 2004): a perspective across
   the light that makes the perspective error alike near and far, and fades out as the view turns
   into the light. @see fit/technique/LiSPSM.h */
class LIXEL_API LiSPSMShadowCameraSetup : public FittedShadowCameraSetup {
public:
    static std::shared_ptr<LiSPSMShadowCameraSetup> create() {
        return std::make_shared<LiSPSMShadowCameraSetup>();
    }

    /// The perspective's near distance as a multiple of the paper's n_opt: smaller gives more
    /// texels to the near, larger comes closer to a uniform map. Default 1.
    /// @throws Ogre::InvalidParametersException unless finite and > 0.
    void setDistanceFactor(Ogre::Real factor);
    Ogre::Real getDistanceFactor() const {
        return static_cast<Ogre::Real>(mOptions.distanceFactor);
    }

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;

private:
    LiSPSMOptions mOptions;
};

} // namespace Lixel
