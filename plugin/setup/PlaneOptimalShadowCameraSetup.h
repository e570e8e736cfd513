#pragma once

#include "setup/TechniqueShadowCameraSetup.h"

#include <OgrePlane.h>

namespace Ogre {
class MovablePlane;
}

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/// A map made for one plane, such as the ground, which may move. @see PlaneOptimalOptions
class LIXEL_API PlaneOptimalShadowCameraSetup
    : public TechniqueShadowCameraSetup<PlaneOptimalOptions> {
public:
    /// @throws Ogre::InvalidParametersException where an option has none of its values.
    static std::shared_ptr<PlaneOptimalShadowCameraSetup>
    create(const PlaneOptimalOptions& options = {}) {
        return std::make_shared<PlaneOptimalShadowCameraSetup>(options);
    }
    using TechniqueShadowCameraSetup::TechniqueShadowCameraSetup;

    /// A plane in the world, as the option `plane`.
    /// @throws Ogre::InvalidParametersException unless finite, with a normal of some length.
    void setPlane(const Ogre::Plane& plane);
    /// A plane that moves with its node, instead of the option's; it must outlive its use here.
    /// Null for the option's again.
    void setMovablePlane(const Ogre::MovablePlane* plane) { mMovablePlane = plane; }
    /// The plane as it is now, in the world.
    Ogre::Plane getPlane() const;

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;

private:
    const Ogre::MovablePlane* mMovablePlane = nullptr;
};

/// @}
} // namespace Lixel
