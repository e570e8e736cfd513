#pragma once

#include <OgreCommon.h>

#include <array>
#include <string_view>

/// Words of shadow_camera_setup scripts that code asks for.
namespace Lixel {

/// The one technique that has slices, and several maps unless it says otherwise.
inline constexpr std::string_view CascadesWord = "Cascades";

/// Instead of a material's name: no material.
inline constexpr std::string_view NoMaterialWord = "none";

struct ShadowTechniqueWord {
    std::string_view name;
    Ogre::ShadowTechnique technique;
};

inline constexpr std::array ShadowTechniqueWords{
    ShadowTechniqueWord{"texture_additive", Ogre::SHADOWTYPE_TEXTURE_ADDITIVE},
    ShadowTechniqueWord{"texture_additive_integrated",
                        Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED},
    ShadowTechniqueWord{"texture_modulative", Ogre::SHADOWTYPE_TEXTURE_MODULATIVE},
    ShadowTechniqueWord{"texture_modulative_integrated",
                        Ogre::SHADOWTYPE_TEXTURE_MODULATIVE_INTEGRATED},
};

} // namespace Lixel
