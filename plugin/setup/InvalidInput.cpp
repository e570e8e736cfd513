#include "setup/InvalidInput.h"

#include "fit/Fit.h"
#include "fit/MapPlacement.h"

#include <OgreMath.h>
#include <OgreStringConverter.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace Lixel {
namespace {

std::string number(double value) {
    return Ogre::StringConverter::toString(static_cast<Ogre::Real>(value));
}

std::string describeMap(const ShadowProblem& problem) {
    const double borders = 2.0 * (leastBorder(problem.filterRadius) + GreatestBorderRounding);
    if (borders < std::min(problem.mapWidth, problem.mapHeight)) return {};
    return "the shadow texture is " + std::to_string(problem.mapWidth) + " x " +
           std::to_string(problem.mapHeight) +
           " pixels, and the border of a map with a filter radius of " +
           number(problem.filterRadius) + " takes " + number(std::ceil(borders)) +
           " (SceneManager::setShadowTextureSize, setFilterRadius)";
}

std::string describeLight(const ShadowLight& light) {
    if (!light.wsDirection.allFinite() || light.wsDirection.isZero(0.0))
        return "its direction is zero or not finite";
    if (light.kind == LightKind::Directional) return {};
    if (!light.wsPosition.allFinite() || light.wsPosition.cwiseAbs().maxCoeff() > GreatestExtent)
        return "its position is not finite, or farther than " + number(GreatestExtent);
    if (!(light.nearDistance > 0.0) || !(light.nearDistance <= GreatestExtent))
        return "its shadows begin at " + number(light.nearDistance) +
               ", which has to be positive (Light::setShadowNearClipDistance, else the viewer's "
               "near plane)";
    if (!(light.range > light.nearDistance))
        return "its range is " + number(light.range) + ", and its shadows begin at " +
               number(light.nearDistance) +
               " (Light::setAttenuation; Light::setShadowNearClipDistance, else the viewer's near "
               "plane)";
    if (light.kind == LightKind::Point) return {}; // its maps have angles of their own
    if (!(light.outerHalfAngle > 0.0) || !(light.outerHalfAngle < std::numbers::pi))
        return "its outer angle is " +
               number(static_cast<double>(Ogre::Math::RadiansToDegrees(
                   static_cast<Ogre::Real>(2.0 * light.outerHalfAngle)))) +
               " degrees (Light::setSpotlightOuterAngle)";
    return {};
}

} // namespace

std::string describeInvalidInput(const ShadowProblem& problem) {
    if (std::string map = describeMap(problem); !map.empty()) return map;
    if (!(problem.viewer.shadowDistance >= 0.0))
        return "its shadow distance is " + number(problem.viewer.shadowDistance) +
               " (Light::setShadowFarDistance, SceneManager::setShadowFarDistance)";
    if (std::string light = describeLight(problem.light); !light.empty()) return light;
    if (problem.casters != nullptr && problem.casters->invalid() != 0)
        return "the bounding box of something that casts shadows is not a number";
    if (problem.receivers != nullptr && problem.receivers->invalid() != 0)
        return "the bounding box of something that receives shadows is not a number";
    ShadowProblem known = problem;
    if (known.light.kind == LightKind::Point) known.light.outerHalfAngle = 1.0;
    if (!isValid(known))
        return "the viewer's view matrix scales, shears or is not finite, or its projection has no "
               "inverse";
    return {};
}

} // namespace Lixel
