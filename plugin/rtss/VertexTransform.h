#pragma once

#include <OgreGpuProgramParams.h>

#include <cstddef>
#include <optional>
#include <string>

namespace Ogre::RTShader {
class Program;
} // namespace Ogre::RTShader

namespace Lixel {

/// How a vertex program of the shader system transforms vertices, where a world matrix does not do
/// it alone.
struct VertexTransform {
    /// Number of bones, and of weights that each vertex has; 0 where there is no skinning.
    std::size_t bones = 0;
    std::size_t weights = 0;
    /// Whether bones are given in the object's space; otherwise in the world's.
    bool bonesAreInObject = false;
    /// Whether bones are dual quaternions; otherwise matrices.
    bool hasQuaternions = false;
    /// Of dual quaternions: whether matrices scale and shear before them, and whether all are
    /// turned to the hemisphere of the first.
    bool hasScales = false;
    bool isAntipodal = false;
    /// The first of the three texture coordinates with each instance's matrix; none: no instances.
    std::optional<int> matrixSet;

    bool isSkinned() const { return bones > 0 && weights > 0; }
};

/// Reads it from a program's parameters and defines. Call it after skinning and instancing have added
/// theirs.
VertexTransform transformOf(Ogre::RTShader::Program& vertexProgram);

// Of a transform that is skinned or instanced:

/// A suffix for names, one for each transform.
std::string nameOf(const VertexTransform& transform);

/// Preprocessor defines with which LixelCasterPlaced.vert transforms the same way.
std::string definesOf(const VertexTransform& transform);

/// Binds what it transforms with.
void bind(const VertexTransform& transform, Ogre::GpuProgramParameters& parameters);

} // namespace Lixel
