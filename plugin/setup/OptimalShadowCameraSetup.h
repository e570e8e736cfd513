#pragma once

#include "fit/technique/Optimal.h"
#include "setup/FittedShadowCameraSetup.h"

namespace Lixel {

/** Texels as small as a single map can make them where the viewer looks, for suns and spots, from
    any side. Nothing has to be tuned to the scene; `setSamples` and `setEvaluations` trade time for
    accuracy. @see fit/technique/Optimal.h */
class LIXEL_API OptimalShadowCameraSetup : public FittedShadowCameraSetup {
public:
    static std::shared_ptr<OptimalShadowCameraSetup> create() {
        return std::make_shared<OptimalShadowCameraSetup>();
    }

    /// Points of the picture by which warps are judged, at most; about half as many where shadows
    /// fill little of it. Default 64.
    /// @throws Ogre::InvalidParametersException unless in 1 to 4096.
    void setSamples(int samples);
    int getSamples() const { return mOptions.samples; }

    /// Warps judged where nothing is known of the frame before; a quarter, and at least 8, in a
    /// frame that follows another. Default 32.
    /// @throws Ogre::InvalidParametersException unless in 8 to 4096.
    void setEvaluations(int evaluations);
    int getEvaluations() const { return mOptions.evaluations; }

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;

private:
    OptimalOptions mOptions;
};

} // namespace Lixel
