#pragma once

#include "setup/FittedShadowCameraSetup.h"

namespace Lixel {

/// A uniform shadow map, focused on what is visible and can be shadowed. @see fit/Uniform.h
class LIXEL_API UniformShadowCameraSetup : public FittedShadowCameraSetup {
public:
    static Ogre::ShadowCameraSetupPtr create() {
        return std::make_shared<UniformShadowCameraSetup>();
    }

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;
};

} // namespace Lixel
