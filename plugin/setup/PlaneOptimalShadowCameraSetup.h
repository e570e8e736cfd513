#pragma once

#include "fit/technique/PlaneOptimal.h"
#include "setup/FittedShadowCameraSetup.h"

#include <OgrePlane.h>

namespace Ogre {
class MovablePlane;
}

namespace Lixel {

/** Plane optimal shadow maps (Chong and Gortler 2004): made for one plane, such as the ground.

    By default the plane picks the warp, and everything that is seen is served. With setExact the
   map is the viewer's picture of the plane: with as many texels as the viewport has pixels, shadows
   on the plane are free of aliasing; what the map has no place for is lit, and ShadowFit::wsServed
    says where that is. Whether a side of the plane is up does not matter. @see fit/technique/PlaneOptimal.h
 */
class LIXEL_API PlaneOptimalShadowCameraSetup : public FittedShadowCameraSetup {
public:
    /// For the plane y = 0.
    PlaneOptimalShadowCameraSetup() = default;
    static std::shared_ptr<PlaneOptimalShadowCameraSetup> create() {
        return std::make_shared<PlaneOptimalShadowCameraSetup>();
    }

    /// A plane in the world.
    /// @throws Ogre::InvalidParametersException unless finite, with a normal of some length.
    void setPlane(const Ogre::Plane& plane);
    /// A plane that moves with its node; it must outlive its use here.
    /// @throws Ogre::InvalidParametersException if null.
    void setPlane(const Ogre::MovablePlane* plane);
    /// The plane as it is now, in the world.
    Ogre::Plane getPlane() const;

    /// Whether the map is exactly the viewer's picture of the plane. Default false.
    void setExact(bool exact) { mExact = exact; }
    bool getExact() const { return mExact; }

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override;

private:
    Ogre::Plane mPlane{Ogre::Vector3::UNIT_Y, 0};
    const Ogre::MovablePlane* mMovablePlane = nullptr;
    bool mExact = false;
};

} // namespace Lixel
