#pragma once

#include "fit/problem/ShadowFit.h"
#include "fit/problem/ShadowProblem.h"

namespace Ogre {
class Camera;
class Light;
} // namespace Ogre

/// Between OGRE's lights and cameras and the fit's.
namespace Lixel {

/// OGRE's light as a fit takes it, relative to an origin in the world.
ShadowLight shadowLightOf(const Ogre::Light& light, const Ogre::Camera& viewer,
                          const Vec3& wsOrigin);

/// Puts a fit's matrices into the shadow camera. @param wsOrigin the fit's, in the world
void placeShadowCamera(Ogre::Camera& camera, const ShadowFit& fit, const Vec3& wsOrigin);

} // namespace Lixel
