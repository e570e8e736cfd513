#pragma once

#include "fit/parts/CascadeSplits.h"
#include "setup/FittedShadowCameraSetup.h"

#include <vector>

namespace Lixel {

/** Several maps for one directional or spot light, one for each slice of the view by depth, each
    by a technique of its own choice.

    There are as many slices as the light has maps
    (SceneManager::setShadowTextureCountPerLightType), under an integrated shadow technique and with
    a material that reads as many, such as `Lixel/Surface/Integrated/Maps3`. Materials learn by
    themselves which map serves a point, and where slices end. A light that shines too wide for one
    map, a point light above all, is divided by directions instead, as all setups do.

    @see fit/parts/CascadeSplits.h
*/
class LIXEL_API CascadesShadowCameraSetup : public FittedShadowCameraSetup {
public:
    /// @param technique of each slice's map; its filter radius, bias and visible points do not
    /// count, this setup's do
    /// @throws Ogre::InvalidParametersException unless it is one of Lixel's, and no cascades
    explicit CascadesShadowCameraSetup(const Ogre::ShadowCameraSetupPtr& technique);

    /// With Optimal in each slice.
    static std::shared_ptr<CascadesShadowCameraSetup> create();
    static std::shared_ptr<CascadesShadowCameraSetup>
    create(const Ogre::ShadowCameraSetupPtr& technique) {
        return std::make_shared<CascadesShadowCameraSetup>(technique);
    }

    /** How slices are deep: 0 for one ratio of their ends' depths, which makes near and far alike;
        1 for equal depths. Default 0.
        @throws Ogre::InvalidParametersException unless in 0 to 1. */
    void setUniformity(Ogre::Real uniformity);
    Ogre::Real getUniformity() const { return static_cast<Ogre::Real>(mOptions.uniformity); }

    /** Whether slices follow what is seen and can be shadowed (default), or stay between the
       viewer's near plane and the far end of shadows, whatever is there. With stable maps
        (UniformShadowCameraSetup::setStable) they should stay. */
    void setFollowReceivers(bool follow) { mOptions.followReceivers = follow; }
    bool getFollowReceivers() const { return mOptions.followReceivers; }

    /** Where slices meet, as depths in front of the viewer in world units, instead of the above.
        Those up to the viewer's near plane do not count, and of the others as many as there are
        maps but one: so these may be all that PSSMShadowCameraSetup::getSplitPoints() returns.
        None, the default, for the above.
        @throws Ogre::InvalidParametersException unless positive, finite and ascending. */
    void setSplitDepths(const std::vector<Ogre::Real>& depths);
    const std::vector<Ogre::Real>& getSplitDepths() const { return mSplitDepths; }

    /** How much farther each slice's map reaches than to where slices meet, in world units. Default
        0, which is enough for Lixel's materials. Others may find slices by another depth: OGRE's
        receivers compare clip z, which is less by up to twice the viewer's near distance.
        @throws Ogre::InvalidParametersException unless finite and not negative. */
    void setSplitPadding(Ogre::Real worldUnits);
    Ogre::Real getSplitPadding() const { return mSplitPadding; }

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;
    LightPartition divide(const ShadowProblem& problem, std::size_t maps,
                          DivisionMemory& memory) const noexcept override;
    std::size_t mapsOfSun(std::size_t maps) const noexcept override;

private:
    std::shared_ptr<const FittedShadowCameraSetup> mTechnique;
    CascadeOptions mOptions;
    std::vector<Ogre::Real> mSplitDepths;
    Ogre::Real mSplitPadding = 0;
};

} // namespace Lixel
