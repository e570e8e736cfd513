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
    /// @throws Ogre::InvalidParametersException if an option's value is not valid.
    static std::shared_ptr<PlaneOptimalShadowCameraSetup>
    create(const PlaneOptimalOptions& options = {}) {
        return std::make_shared<PlaneOptimalShadowCameraSetup>(options);
    }
    using TechniqueShadowCameraSetup::TechniqueShadowCameraSetup;

    /// A plane in the world, as the option `plane`, instead of one that moves.
    /// @throws Ogre::InvalidParametersException unless finite, with a normal of some length.
    void setPlane(const Ogre::Plane& plane);
    /// A plane that moves with its node. It takes the place of the option `plane`, whatever that is
    /// set to, until setPlane or null. It must outlive its use here.
    void setMovablePlane(const Ogre::MovablePlane* plane) { mMovablePlane = plane; }
    /// The plane as it is now, in the world.
    Ogre::Plane getPlane() const;

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;
    bool dependsOnlyOnOptions() const noexcept override { return mMovablePlane == nullptr; }

private:
    const Ogre::MovablePlane* mMovablePlane = nullptr;
};

/// @}
} // namespace Lixel
