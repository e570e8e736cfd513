#pragma once

#include <OgrePrerequisites.h>

#include <string>

namespace Ogre::RTShader {
class Program;
} // namespace Ogre::RTShader

namespace Lixel {

/// Whether Plugin_Lixel is loaded: it makes the set of parameters that Lixel/Caster reads.
bool pluginIsLoaded();

/** Sets a caster with the same skinning or instancing. Lixel/Caster would draw the bind pose.

    The caster is a clone of Lixel/Caster, shared by all that is transformed alike. It culls as the
    pass does. A pass that is alpha-tested or blended has one of its own, with its first texture:
    for a technique's own caster OGRE copies none of these.
    A caster with programs is kept. One without programs would be drawn by the shader system and write
    no depth of Lixel's, so it is removed, unless the pass reads OGRE's own shadow maps. A technique
    needs none where Lixel/Caster itself suffices, and gets none where Lixel/Caster is not loaded.
    @param pass one of the shader system's, before it has units for shadow maps
    @return what the log should say once the material is drawn; empty where all is well
*/
std::string setCaster(Ogre::Pass& pass, Ogre::RTShader::Program& vertexProgram);

} // namespace Lixel
