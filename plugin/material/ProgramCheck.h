#pragma once

#include <OgreGpuProgramParams.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace Ogre {
class Pass;
} // namespace Ogre

namespace Lixel {

/** What is wrong with how a program's parameters are bound to Lixel's, as lines for the log.

    Told apart by their names are uniforms that begin with `lixel`, as LixelShadow.glsl,
    LixelCaster.glsl and LixelFog.glsl declare them: each has to be bound to its own `light_custom`
    number, or be in a shared set that the parameters refer to. Of uniforms with other names,
    numbers that mean none of Lixel's parameters, but look like one, are found.
*/
std::vector<std::string> findWrongBindings(const Ogre::GpuProgramParameters& parameters);

/** Which samplers of a pass read another texture unit than they mean, as lines for the log.

    Samplers are recognised by name: `diffuseMap` means the unit DiffuseMap, `shadowMap` the unit
    ShadowMap. Under an integrated technique `shadowMap`, `shadowMap0` and so on mean the units of
    content_type shadow, in their order: there have to be as many of these as maps are read. Two
    more mistakes with DiffuseMap are found: its texture is in a unit without a name, or has one
    texel.
*/
std::vector<std::string> findWrongUnits(const Ogre::Pass& pass, bool integrated);

/// Whether a pass writes the depth that Lixel's receivers compare with, as far as can be told: its
/// vertex program has the uniform lixelCasterDepth, or a parameter of Lixel's.
bool writesCasterDepth(const Ogre::Pass& pass);

/// How many shadow maps of a light a pass reads, by any names: the greatest map's index that a
/// uniform of its programs is bound to, plus one. 0 where none is.
/// @param light its place among the pass's lights
std::size_t mapsRead(const Ogre::Pass& pass, std::size_t light);

/// Whether a pass has texture units for maps under integrated techniques: one without may compute
/// where a map is, for varyings that it shares with others, and reads none.
bool hasMapUnits(const Ogre::Pass& pass);

/// How many maps the least of Lixel/ShadowMaps2, Lixel/Surface/Integrated/Maps2 and so on has that
/// has so many; none where no such program and material has.
std::optional<std::size_t> mapsOfProgramFor(std::size_t maps);

/// Whether a pass reads Lixel's maps, as additive, integrated or modulative receivers do.
bool readsMaps(const Ogre::Pass& pass);

/// Whether a pass reads the map of the light whose modulative pass is drawn: its programs refer to
/// the shared set Lixel/ModulativeReceiver.
bool readsModulativeMap(const Ogre::Pass& pass);

} // namespace Lixel
