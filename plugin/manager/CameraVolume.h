#pragma once

#include "scene/NodeCuller.h"

namespace Ogre {
class Camera;
} // namespace Ogre

namespace Lixel {

/// What a camera culls by.
struct CameraVolume {
    NodeCuller planes;
    /// Whether the planes say all: false for cameras of an application's own class, and for culling
    /// frusta of one, which have to be asked about every box.
    bool complete = true;
};

/// The volume that Camera::isVisible compares boxes with.
CameraVolume volumeOf(const Ogre::Camera& camera);

} // namespace Lixel
