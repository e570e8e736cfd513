#include "setup/InvalidInput.h"

#include "fit/core/MapPlacement.h"
#include "fit/core/Validity.h"

#include <OgreMath.h>
#include <OgreStringConverter.h>

#include <cmath>

namespace Lixel {
namespace {

std::string number(double value) {
    return Ogre::StringConverter::toString(static_cast<Ogre::Real>(value));
}

InvalidInput inputOf(ShadowProblem problem) {
    // A point light's maps have angles of their own.
    if (problem.light.kind == LightKind::Point) problem.light.outerHalfAngle = 1.0;
    return invalidInputOf(problem);
}

std::string describeMap(const ShadowProblem& problem) {
    const double borders = 2.0 * (leastBorder(problem.filterRadius) + GreatestBorderRounding);
    return "the shadow texture is " + std::to_string(problem.mapWidth) + " x " +
           std::to_string(problem.mapHeight) +
           " pixels, and the border of a map with a filter radius of " +
           number(problem.filterRadius) + " takes " + number(std::ceil(borders)) +
           " (SceneManager::setShadowTextureSize, setFilterRadius)";
}

} // namespace

std::string describeInvalidInput(const ShadowProblem& problem) {
    const ShadowLight& light = problem.light;
    switch (inputOf(problem)) {
    case InvalidInput::Map:
        return describeMap(problem);
    case InvalidInput::ShadowDistance:
        return "its shadow distance is " + number(problem.viewer.shadowDistance) +
               " (Light::setShadowFarDistance, SceneManager::setShadowFarDistance)";
    case InvalidInput::LightDirection:
        return "its direction is zero or not finite";
    case InvalidInput::LightPosition:
        return "its position is not finite, or farther than " + number(GreatestExtent);
    case InvalidInput::NearDistance:
        return "its shadows begin at " + number(light.nearDistance) +
               ", which has to be positive (Light::setShadowNearClipDistance, else the viewer's "
               "near plane)";
    case InvalidInput::Range:
        return "its range is " + number(light.range) + ", and its shadows begin at " +
               number(light.nearDistance) +
               " (Light::setAttenuation; Light::setShadowNearClipDistance, else the viewer's near "
               "plane)";
    case InvalidInput::Angle:
        return "its outer angle is " +
               number(static_cast<double>(Ogre::Math::RadiansToDegrees(
                   static_cast<Ogre::Real>(2.0 * light.outerHalfAngle)))) +
               " degrees (Light::setSpotlightOuterAngle)";
    case InvalidInput::CasterBox:
        return "the bounding box of something that casts shadows is not a number";
    case InvalidInput::ReceiverBox:
        return "the bounding box of something that receives shadows is not a number";
    case InvalidInput::View:
        return "the viewer's view matrix scales, shears or is not finite, or its projection has no "
               "inverse";
    case InvalidInput::None:
    case InvalidInput::Bodies: // setups always have them
        break;
    }
    return {};
}

} // namespace Lixel
