#pragma once

#include "fit/technique/Uniform.h"
#include "setup/FittedShadowCameraSetup.h"

namespace Lixel {

/// A uniform shadow map, focused on what is visible and can be shadowed. @see fit/technique/Uniform.h
class LIXEL_API UniformShadowCameraSetup : public FittedShadowCameraSetup {
public:
    static std::shared_ptr<UniformShadowCameraSetup> create() {
        return std::make_shared<UniformShadowCameraSetup>();
    }

    /** Steady texels instead of small ones: shadows' edges stay as they are while the viewer turns
        and moves. The map covers all that is in view up to the shadow distance, which is worth
        setting low; or use it for the slices of cascades under a sun. A spot's map covers its cone,
        in every slice too; a point light's face covers the cone around it, and is stable only where
        the light has six maps. Default false. */
    void setStable(bool stable) { mOptions.stable = stable; }
    bool getStable() const { return mOptions.stable; }

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;

private:
    UniformOptions mOptions;
};

} // namespace Lixel
