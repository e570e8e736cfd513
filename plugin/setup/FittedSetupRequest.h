#pragma once

#include "setup/FittedShadowCameraSetup.h"

#include <cstddef>
#include <functional>

// What the parts of FittedShadowCameraSetup hand to each other.
namespace Lixel {

class CasterFingerprint;

/// What OGRE asks for one map.
struct FittedShadowCameraSetup::Request {
    const Ogre::Camera& viewer;
    const Ogre::Viewport& viewport;
    const Ogre::Light& light;
    Ogre::Camera& shadowCamera;
    std::size_t iteration;
};

/// In microseconds.
struct FittedShadowCameraSetup::FitTimes {
    double survey = 0.0;
    double casters = 0.0;
    double fit = 0.0;
};

/// How a map's casters are read, where it matters.
struct FittedShadowCameraSetup::MapCasters {
    /// As planMap.
    bool readsAtOnce;
    std::function<const CasterFingerprint&()> read;
    /// Each of them, once they were read; null where they are known together alone.
    const CasterFingerprint* each = nullptr;
};

} // namespace Lixel
