#pragma once

#include "fit/parts/CascadeSplits.h"
#include "setup/FittedShadowCameraSetup.h"

#include <vector>

namespace Ogre {
class PSSMShadowCameraSetup;
} // namespace Ogre

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/** Several maps for one directional or spot light, one for each slice of the view by depth, each
    by a technique of its own choice.

    There are as many slices as the light has maps
    (SceneManager::setShadowTextureCountPerLightType), under an integrated shadow technique and with
    a material that reads as many, such as `Lixel/Surface/Integrated/Maps3`. Materials learn by
    themselves which map serves a point, and where slices end. A light that shines too wide for one
    map, a point light above all, is divided by directions instead, as all setups do; where a single
    cone serves it, or is all that its maps are for, that cone is divided as a spot's.

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
    /** In place of OGRE's PSSM, for receivers that have its split points.

        As OGRE's, slices meet at these points, and there are as many of them. Each map reaches over
        the border by PSSM's padding, and at least by twice the viewer's near distance, whatever the
        option `split_padding` says: OGRE's receivers choose a slice by clip z, which is less than
        the depth by up to that. PSSM's optimal adjust factors have no counterpart: what warps a
        slice's map fits itself to what is seen. Points and padding are copied: after
        calculateSplitPoints, create another.
        @param pssm not kept
        @param technique as above; null: Optimal
        @throws Ogre::InvalidParametersException if `pssm` is null, or its split points are not
        positive, finite and ascending, or its padding is negative or not finite; or if `technique`
        is none of Lixel's
    */
    static std::shared_ptr<CascadesShadowCameraSetup>
    create(const Ogre::PSSMShadowCameraSetup* pssm,
           const Ogre::ShadowCameraSetupPtr& technique = {});
    static std::shared_ptr<CascadesShadowCameraSetup>
    create(const std::shared_ptr<Ogre::PSSMShadowCameraSetup>& pssm,
           const Ogre::ShadowCameraSetupPtr& technique = {}) {
        return create(pssm.get(), technique);
    }
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
    bool dependsOnlyOnOptions() const noexcept override { return true; }
    const FittedShadowCameraSetup* technique() const noexcept override { return mTechnique.get(); }

private:
    std::shared_ptr<const FittedShadowCameraSetup> mTechnique;
    CascadeOptions mOptions;
    /// Whether receivers choose slices by clip z.
    bool mServesOgresReceivers = false;
};

/// @}
} // namespace Lixel
