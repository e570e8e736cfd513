#pragma once

#include <string>

namespace Ogre {
class Pass;
class Renderable;
} // namespace Ogre

/// Questions about what a scene manager draws, and by which pass.
namespace Lixel {

/// A pass's user binding of this name says that libLixelRTSS made it, and says itself what keeps
/// shadows from it.
inline constexpr const char* ShaderSystemMark = "Lixel/ShaderSystem";

std::string quoted(const std::string& name);

/// The name of the material that a pass is of.
std::string materialOf(const Ogre::Pass& pass);

/// The name of the material that an object wears; OGRE's own where it has none.
std::string wornBy(const Ogre::Renderable& renderable);

/// Whether a pass is of OGRE's own material, which stands in for one that is not there or cannot
/// be drawn.
bool isStandIn(const Ogre::Pass& pass);

/// Whether a pass's vertex program bends what it draws, by bones, morphing or poses.
bool bends(const Ogre::Pass& pass);

/// Whether what is drawn is left to its vertex program to bend.
bool isBentByProgram(Ogre::Renderable& renderable);

/// Whether a pass is of OGRE's terrain component, which makes programs of its own.
bool isOfTerrain(const Ogre::Pass& pass);

/// Whether one call draws many bodies, and the pass's vertex program is one of Lixel's, which do
/// not place them.
bool isLeftUnplaced(const Ogre::Pass& pass, Ogre::Renderable& renderable);

/// Whether a pass lacks programs and the render system draws nothing without.
bool lacksPrograms(const Ogre::Pass& pass);

/// What to do about a pass that lacksPrograms, as a line for the log.
std::string whatLacksPrograms(const Ogre::Pass& pass);

} // namespace Lixel
