#pragma once

#include <OgrePrerequisites.h>

#include <cstddef>

namespace Ogre::RTShader {
class ShaderGenerator;
} // namespace Ogre::RTShader

/** @defgroup LixelShaderSystem Shader system
    Lixel's shadows for the programs that OGRE's Run Time Shader System makes. */

/// Symbols that libLixelRTSS exports.
#define LIXEL_RTSS_API __attribute__((visibility("default")))

/** Materials without programs, shadowed by Lixel's maps.

    OGRE's shader system makes programs for such materials. With this, each light in per-pixel
    lighting is shadowed by that light's own maps: of suns, spots and point lights, one to six each.
    Normal maps, specular light, fog, textures, hardware skinning and instances are the shader
    system's. One line shadows all that is drawn in a scheme:

        if (!Ogre::RTShader::ShaderGenerator::initialize()) ...
        Lixel::ShaderSystem::enable(Ogre::RTShader::ShaderGenerator::getSingleton());

    and a script shadows one pass, in whatever scheme it is for. (OGRE drops words without a value,
    and so a lone `lixel_shadows`.)

        rtshader_system
        {
            lixel_shadows maps auto // or a number, as Options::maps
        }

    What it takes: an integrated shadow technique (SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED or
    SHADOWTYPE_TEXTURE_MODULATIVE_INTEGRATED), Lixel/Caster, shadow textures of PF_FLOAT32_R, a
    light with one of Lixel's setups, Plugin_Lixel, its folder materials/programs/glsl in a resource
    group, and GL3Plus. How many maps each kind of light has is read from the scene manager, and
    programs are made anew when that changes.

    Left as they are: passes with `lighting off`, materials with `receive_shadows off`, lights
    without maps, and passes that are lit per vertex, by `metal_roughness` before OGRE 14.1, that
    OGRE draws once for each light, or that have units of content_type shadow already. The log has
    one line for each material that cannot be shadowed, with the reason.

    Skinned and instanced objects get a matching caster, unless their technique sets one that has
    programs. The caster culls as the material does, and cuts the holes of the material's first
    texture where the material is alpha-tested or blended.

    Order: ShaderGenerator::initialize, then install or enable, then scripts are parsed. At the end
    ShaderGenerator::destroy before Root goes, as OGRE itself wants it, with shutdown before or
    after it, or without. The plugin may be unloaded at any time; as in all of Lixel's materials,
    shadows then stay where they are.
*/
namespace Lixel::ShaderSystem {
/// @addtogroup LixelShaderSystem
/// @{

/// Greatest number of maps that a program reads of one light.
inline constexpr std::size_t MaxMaps = 6;

/// What enable may be told.
struct Options {
    /// How many maps of each light a program reads at most, 1 to MaxMaps. What lies in a light's
    /// others is lit there. 0: as many as the scene manager has for its kind
    /// (SceneManager::setShadowTextureCountPerLightType).
    std::size_t maps = 0;
};

/** Makes `lixel_shadows` known to material scripts.

    Call it after ShaderGenerator::initialize and before the scripts that use it are parsed; else
    OGRE logs an error for each. Where the generator is destroyed and initialised again, call it
    again.
    Calling it twice has no effect.
    @throws Ogre::ItemIdentityException where another copy of this library has done so
*/
LIXEL_RTSS_API void install(Ogre::RTShader::ShaderGenerator& generator);

/** Shadows all materials of a scheme, and does what install does.

    Calling it again for a scheme sets its options. A material's own `lixel_shadows` counts more.
    Programs that there are already are made anew before the next frame.
    @param scheme name of a scheme that the generator has; empty: the shader system's default one
    @throws Ogre::ItemIdentityException, which names those that there are, for any other scheme
    @throws Ogre::InvalidParametersException where options.maps is more than MaxMaps
*/
LIXEL_RTSS_API void enable(Ogre::RTShader::ShaderGenerator& generator,
                           const Ogre::String& scheme = "", const Options& options = {});

/** Takes back what enable did. Materials whose scripts say `lixel_shadows` keep their shadows.

    Without effect where the scheme is not enabled.
    @param scheme as for enable, which throws for the same names
*/
LIXEL_RTSS_API void disable(Ogre::RTShader::ShaderGenerator& generator,
                            const Ogre::String& scheme = "");

/** Takes off all that this library has hung into OGRE, in schemes, materials and scene managers.

    Needed only before the library is unloaded. It may come before ShaderGenerator::destroy, whose
    programs are then made anew without shadows, after it, or after Root. Calling it twice has no
    effect. Scripts that are parsed later do not know `lixel_shadows` until install.
*/
LIXEL_RTSS_API void shutdown();

/// @}
} // namespace Lixel::ShaderSystem
