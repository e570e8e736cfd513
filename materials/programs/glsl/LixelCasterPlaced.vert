#version 330 core
// Shadow caster whose vertices its program places: bent by LIXEL_BONES bones, of which
// LIXEL_WEIGHTS move each vertex; or, where these are not defined, one of many instances, each with
// the rows of its matrix in LIXEL_MATRIX, its texture coordinates from one set on.
#include "LixelCaster.glsl"

in vec4 vertex;
in vec2 uv0;
#ifdef LIXEL_BONES
in vec4 blendIndices;
in vec4 blendWeights;
uniform mat3x4 bones[LIXEL_BONES];
#else
in mat3x4 LIXEL_MATRIX;
#endif

// Of what bones and instances' matrices give: a place in the world, or in the object.
uniform mat4 clipFromPlaced;
uniform mat4 diffuseMapMatrix; // scale, scroll, rotate of its texture unit

out float depth;

void main()
{
#ifdef LIXEL_BONES
    vec3 placed = blendWeights[0] * (vertex * bones[int(blendIndices[0])]);
    for (int i = 1; i < LIXEL_WEIGHTS; ++i)
        placed += blendWeights[i] * (vertex * bones[int(blendIndices[i])]);
#else
    vec3 placed = vertex * LIXEL_MATRIX;
#endif
    gl_Position = clipFromPlaced * vec4(placed, 1.0);
    depth = lixelCasterDepthOf(gl_Position);
    lixelCasterUv = (diffuseMapMatrix * vec4(uv0, 0.0, 1.0)).xy;
}
