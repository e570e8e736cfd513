#pragma once

// Vertex programs that place vertices by themselves, for tests of what is read back of them.

#include <Lixel/scene/OgreVersions.h>

#include <Ogre.h>

#include <string>

namespace Lixel::Samples {

/// Two bones, two weights a vertex.
inline const std::string SkinProgram = R"(#version 330 core
in vec4 vertex;
in vec4 blendIndices;
in vec4 blendWeights;
uniform mat3x4 bones[2];
uniform mat4 clipFromPlaced;
void main()
{
    vec3 placed = blendWeights[0] * (vertex * bones[int(blendIndices[0])]) +
                  blendWeights[1] * (vertex * bones[int(blendIndices[1])]);
    gl_Position = clipFromPlaced * vec4(placed, 1.0);
})";

/// Instances whose matrices are in sets of texture coordinates, from the second on.
inline const std::string InstanceProgram = R"(#version 330 core
in vec4 vertex;
in mat3x4 uv1;
uniform mat4 clipFromPlaced;
void main()
{
    gl_Position = clipFromPlaced * vec4(vertex * uv1, 1.0);
})";

/// Instances whose matrices are an array of uniforms.
inline const std::string InstanceArrayProgram = R"(#version 330 core
in vec4 vertex;
in vec4 blendIndices;
uniform mat3x4 bones[4];
uniform mat4 clipFromPlaced;
void main()
{
    gl_Position = clipFromPlaced * vec4(vertex * bones[int(blendIndices[0])], 1.0);
})";

inline const std::string WhiteProgram = R"(#version 330 core
out vec4 fragColour;
void main()
{
    fragColour = vec4(1.0);
})";

/// @param prepare what has to be said before the program is loaded
template <typename Prepare>
Ogre::GpuProgramPtr addVertexProgram(const std::string& name, const std::string& source,
                                     const Prepare& prepare) {
    const Ogre::GpuProgramPtr program =
        createProgram(name, Ogre::RGN_DEFAULT, "glsl", Ogre::GPT_VERTEX_PROGRAM);
    program->setSource(source);
    prepare(*program);
    program->load();
    Ogre::GpuProgramParameters& parameters = *program->getDefaultParameters();
    const bool placesInObject = program->isSkeletalAnimationIncluded() && bonesAreInObject();
    parameters.setNamedAutoConstant(
        "clipFromPlaced", placesInObject ? Ogre::GpuProgramParameters::ACT_WORLDVIEWPROJ_MATRIX
                                         : Ogre::GpuProgramParameters::ACT_VIEWPROJ_MATRIX);
    if (parameters._findNamedConstantDefinition("bones") != nullptr)
        parameters.setNamedAutoConstant("bones",
                                        Ogre::GpuProgramParameters::ACT_WORLD_MATRIX_ARRAY_3x4);
    return program;
}

/// A material that paints white what a vertex program places.
inline Ogre::MaterialPtr addMaterial(const std::string& name, const std::string& vertexProgram) {
    const std::string white = "white";
    if (!programManager().resourceExists(white, Ogre::RGN_DEFAULT))
        createProgram(white, Ogre::RGN_DEFAULT, "glsl", Ogre::GPT_FRAGMENT_PROGRAM)
            ->setSource(WhiteProgram);
    const auto material = Ogre::MaterialManager::getSingleton().create(name, Ogre::RGN_DEFAULT);
    Ogre::Pass& pass = *material->getTechnique(0)->getPass(0);
    pass.setVertexProgram(vertexProgram);
    pass.setFragmentProgram(white);
    return material;
}

} // namespace Lixel::Samples
