#pragma once

#include "fit/problem/ShadowProblem.h"

namespace Ogre {
class Camera;
} // namespace Ogre

namespace Lixel {

/** Who looks through a camera: matrices relative to wsOrigin, which the viewer's position is.
    Shadow distance is left 0. */
ShadowViewer viewerOf(const Ogre::Camera& camera, Vec3& wsOrigin);

} // namespace Lixel
