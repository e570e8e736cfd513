#include "setup/PlaneOptimalShadowCameraSetup.h"

#include "scene/OgreMath.h"

#include <OgreException.h>
#include <OgreMovablePlane.h>

#include <cmath>

namespace Lixel {

void PlaneOptimalShadowCameraSetup::setPlane(const Ogre::Plane& plane) {
    const Vec3 normal = toDouble(plane.normal);
    if (!normal.allFinite() || normal.isZero(0.0) || !std::isfinite(plane.d))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "plane: the plane must be finite, and its normal must have a length",
                    "PlaneOptimalShadowCameraSetup::setPlane");
    mPlane = plane;
    mMovablePlane = nullptr;
}

void PlaneOptimalShadowCameraSetup::setPlane(const Ogre::MovablePlane* plane) {
    if (plane == nullptr)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "plane: there must be one",
                    "PlaneOptimalShadowCameraSetup::setPlane");
    mMovablePlane = plane;
}

Ogre::Plane PlaneOptimalShadowCameraSetup::getPlane() const {
    if (mMovablePlane == nullptr) return mPlane;
    // Without a node there is nothing that it could be derived from, and OGRE leaves it empty.
    return mMovablePlane->isAttached() ? mMovablePlane->_getDerivedPlane() : *mMovablePlane;
}

ShadowFit PlaneOptimalShadowCameraSetup::fit(const ShadowProblem& problem,
                                             FitState& state) const noexcept {
    const Ogre::Plane plane = getPlane();
    const Vec3 normal = toDouble(plane.normal);
    // The fit's origin is not the world's.
    const double offset = static_cast<double>(plane.d) + normal.dot(problem.wsOrigin);
    return fitPlaneOptimal(problem, {.wsNormal = normal, .offset = offset, .exact = mExact}, state);
}

} // namespace Lixel
