#pragma once

#include <OgreSharedPtr.h>

#include <OgreShadowCameraSetup.h>

#include <cstdint>
#include <string>

namespace Lixel::Tests {

/// A shadow camera setup that can be made again, alike and without a past.
struct SetupRecipe {
    std::uint64_t kind = 0;    ///< which class
    std::uint64_t options = 0; ///< random legal options

    Ogre::ShadowCameraSetupPtr make() const;
    /// Changes the options of a setup of this kind.
    void apply(Ogre::ShadowCameraSetup& setup) const;
    std::string name() const;
    /// Whether its shadows should be exact up to a texel: one of Lixel's that serves everything.
    bool isExact() const;
    /// Whether it serves everything only with a map for each of its parts.
    bool isCube() const;
};

} // namespace Lixel::Tests
