#pragma once

#include <cstddef>
#include <vector>

namespace Ogre {
class Pass;
} // namespace Ogre

/// What a pass does with shadow maps, as its programs and texture units tell.
namespace Lixel {

/// Whether a pass writes the depth that Lixel's receivers compare with, as far as can be told: its
/// vertex program has the uniform lixelCasterDepth, or another that is bound to LP_CASTER_DEPTH.
bool writesCasterDepth(const Ogre::Pass& pass);

/// How many shadow maps of a light a pass reads, by any names: the greatest map's index that a
/// uniform of its programs is bound to, plus one. 0 where none is.
/// @param light its place among the pass's lights
std::size_t mapsRead(const Ogre::Pass& pass, std::size_t light);

/// Whether a pass finds a light's map by the depths at which slices end. @param light as mapsRead
bool readsSplitDepths(const Ogre::Pass& pass, std::size_t light);

/// Indices of a pass's texture units of content_type shadow, in their order. A pass without them
/// reads no map under integrated techniques, but may bind map rows to fill varyings that it shares.
std::vector<std::size_t> shadowUnitsOf(const Ogre::Pass& pass);

/// Whether a pass reads Lixel's maps, as additive, integrated or modulative receivers do.
bool readsMaps(const Ogre::Pass& pass);

/// Whether a pass reads the map of the light whose modulative pass is drawn: its programs refer to
/// the shared set Lixel/ModulativeReceiver.
bool readsModulativeMap(const Ogre::Pass& pass);

} // namespace Lixel
