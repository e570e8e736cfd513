#pragma once

#include "fit/technique/PostProjectiveCube.h"
#include "setup/TechniqueShadowCameraSetup.h"

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/** Kozlov's cube map of post-projective space (2004, §14.2.2): the light's maps are the faces of
    the viewer's volume through which its rays leave, one to five for a directional light, up to six
    for a light in view.

    Give the light six maps (SceneManager::setShadowTextureCountPerLightType), under an integrated
    shadow technique and with a material that reads as many, such as
    `Lixel/Surface/Integrated/Maps6`; faces without shadows are not drawn. With one map it is a
    perspective shadow map (PSM) of a light that one map is enough for.
*/
class LIXEL_API PostProjectiveCubeShadowCameraSetup
    : public TechniqueShadowCameraSetup<CubeOptions> {
public:
    /// @throws Ogre::InvalidParametersException if an option's value is not valid.
    static std::shared_ptr<PostProjectiveCubeShadowCameraSetup>
    create(const CubeOptions& options = {}) {
        return std::make_shared<PostProjectiveCubeShadowCameraSetup>(options);
    }
    using TechniqueShadowCameraSetup::TechniqueShadowCameraSetup;

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;
    LightPartition divide(const ShadowProblem& problem, std::size_t maps,
                          DivisionMemory& memory) const noexcept override;
    std::size_t mapsOfSun(std::size_t maps) const noexcept override { return maps; }
};

/// @}
} // namespace Lixel
