#pragma once

#include "fit/parts/CascadeSplits.h"
#include "setup/FittedShadowCameraSetup.h"

#include <vector>

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/** Several maps for one directional or spot light, one for each slice of the view by depth, each
    by a technique of its own choice.

    There are as many slices as the light has maps
    (SceneManager::setShadowTextureCountPerLightType), under an integrated shadow technique and with
    a material that reads as many, such as `Lixel/Surface/Integrated/Maps3`. Materials learn by
    themselves which map serves a point, and where slices end. A light that shines too wide for one
    map, a point light above all, is divided by directions instead, as all setups do.

    @see CascadeOptions
*/
class LIXEL_API CascadesShadowCameraSetup : public FittedShadowCameraSetup {
public:
    /// @param technique of each slice's map; its filter radius, bias and visible points do not
    /// count, this setup's do
    /// @throws Ogre::InvalidParametersException if `technique` is null, not one of Lixel's setups,
    /// or a cascades setup; or if an option's value is not valid
    static std::shared_ptr<CascadesShadowCameraSetup>
    create(const Ogre::ShadowCameraSetupPtr& technique, const CascadeOptions& options = {}) {
        return std::make_shared<CascadesShadowCameraSetup>(technique, options);
    }
    /// With Optimal in each slice.
    static std::shared_ptr<CascadesShadowCameraSetup> create(const CascadeOptions& options = {});
    /// Use create().
    explicit CascadesShadowCameraSetup(const Ogre::ShadowCameraSetupPtr& technique,
                                       const CascadeOptions& options = {});

    const CascadeOptions& getOptions() const { return mOptions; }
    /// Sets all options of the cascades; what is not named has its default.
    /// @throws Ogre::InvalidParametersException if an option's value is not valid.
    void setOptions(const CascadeOptions& options);
    /// Sets the option `split_depths`, to what PSSMShadowCameraSetup::getSplitPoints() returns.
    /// @throws Ogre::InvalidParametersException unless positive, finite and ascending.
    void setSplitDepths(const std::vector<Ogre::Real>& depths);

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;
    LightPartition divide(const ShadowProblem& problem, std::size_t maps,
                          DivisionMemory& memory) const noexcept override;
    std::unique_ptr<DivisionMemory> makeDivisionMemory() const override;
    std::size_t mapsOfSun(std::size_t maps) const noexcept override;

private:
    std::shared_ptr<const FittedShadowCameraSetup> mTechnique;
    CascadeOptions mOptions;
};

/// @}
} // namespace Lixel
