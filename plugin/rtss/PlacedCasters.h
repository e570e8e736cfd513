#pragma once

#include <OgrePrerequisites.h>

#include <cstddef>

namespace Ogre::RTShader {
class Program;
} // namespace Ogre::RTShader

namespace Lixel {

/// How a vertex program of the shader system places vertices, where a world matrix does not do it
/// alone. Lixel/Caster would draw the shadow of what is at rest.
struct Placing {
    /// Bones that bend it, and how many of them each vertex; 0 for none.
    std::size_t bones = 0;
    std::size_t weights = 0;
    /// Whether it draws instances, each with its matrix in the texture coordinates from 1 on.
    bool isInstanced = false;
};

/// Whether the plugin has made the set of parameters that tells casters their depth.
bool tellsCastersTheirDepth();

Placing placingOf(Ogre::RTShader::Program& vertexProgram);

/// A caster that places vertices alike, made of Lixel/Caster the first time. Null where that does,
/// where it is not loaded, and for dual quaternions.
Ogre::MaterialPtr casterFor(const Placing& placing);

} // namespace Lixel
