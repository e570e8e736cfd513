#include "setup/PlaneOptimalShadowCameraSetup.h"

#include "scene/OgreMath.h"

#include <OgreMovablePlane.h>

namespace Lixel {
namespace {

Vec4 toDouble(const Ogre::Plane& plane) {
    Vec4 result;
    result << Lixel::toDouble(plane.normal), static_cast<double>(plane.d);
    return result;
}

} // namespace

void PlaneOptimalShadowCameraSetup::setPlane(const Ogre::Plane& plane) {
    PlaneOptimalOptions options = getOptions();
    options.wsPlane = toDouble(plane);
    setOptions(options);
    mMovablePlane = nullptr;
}

Ogre::Plane PlaneOptimalShadowCameraSetup::getPlane() const {
    if (mMovablePlane != nullptr)
        // Without a node there is nothing that it could be derived from, and OGRE leaves it empty.
        return mMovablePlane->isAttached() ? mMovablePlane->_getDerivedPlane() : *mMovablePlane;
    const Vec4& plane = getOptions().wsPlane;
    Ogre::Plane result;
    result.normal = toOgre(Vec3(plane.head<3>()));
    result.d = static_cast<Ogre::Real>(plane.w());
    return result;
}

ShadowFit PlaneOptimalShadowCameraSetup::fit(const ShadowProblem& problem,
                                             FitState& state) const noexcept {
    if (mMovablePlane == nullptr) return TechniqueShadowCameraSetup::fit(problem, state);
    PlaneOptimalOptions options = getOptions();
    options.wsPlane = toDouble(getPlane());
    return fitMap(problem, options, state);
}

} // namespace Lixel
