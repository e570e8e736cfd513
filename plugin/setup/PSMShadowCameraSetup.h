#pragma once

#include "fit/technique/Psm.h"
#include "setup/FittedShadowCameraSetup.h"

namespace Lixel {

/** Perspective shadow maps (Stamminger and Drettakis 2002) as Kozlov (2004, "Care and Feeding")
   mends them: a map in the viewer's post-projective space, without virtual cameras for lights
   behind the viewer. @see fit/technique/Psm.h */
class LIXEL_API PSMShadowCameraSetup : public FittedShadowCameraSetup {
public:
    static std::shared_ptr<PSMShadowCameraSetup> create() {
        return std::make_shared<PSMShadowCameraSetup>();
    }

    /// How far the virtual viewer slides back to balance near and far (Kozlov's Figure 14-6),
    /// relative to the geometric mean of the nearest and the farthest receiver's depth: 0 favours
    /// the near most. Default 0.25.
    /// @throws Ogre::InvalidParametersException unless finite and >= 0.
    void setSlideBack(Ogre::Real slideBack);
    Ogre::Real getSlideBack() const { return static_cast<Ogre::Real>(mOptions.slideBack); }

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;

private:
    PsmOptions mOptions;
};

} // namespace Lixel
