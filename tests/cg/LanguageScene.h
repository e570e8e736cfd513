#pragma once

#include "DrawingOgre.h"

#include <OgreSceneManager.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Lixel::Tests {

/// How the scene's shadows are drawn.
struct Way {
    const char* name;
    Ogre::ShadowTechnique technique;
    const char* receiver; ///< null under an integrated technique
    const char* surface;
    std::size_t maps;
    /// Scripts that hold the receiver and a caster; null for Lixel's.
    const char* folder = nullptr;
    const char* caster = "Lixel/Caster";
    /// The only techniques of caster and receiver that are kept; null for all.
    const char* kept = nullptr;
    float unit = 1; ///< how large the scene is
    bool hasFence = true;
    bool fenceFirst = false; ///< whether the fence is drawn before all else
};

/// A ground, two bodies and a fence with holes, by one light, in Lixel's programs of one language.
/// @returns the picture as RGB, row by row. It is also written into the folder that the environment
/// names as LIXEL_PICTURES.
std::vector<std::uint8_t> pictureIn(const std::string& language, const RenderPath& path,
                                    const Way& way);

/// The share of pixels that differ in any channel.
double share(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b);

} // namespace Lixel::Tests
