#version 330 core
// Shadow caster whose vertices its program places in the world: bent by LIXEL_BONES bones, of which
// LIXEL_WEIGHTS move each vertex; or, where these are not defined, one of many instances, each with
// the rows of its matrix in the texture coordinates from uv1 on.
#include "LixelCaster.glsl"

in vec4 vertex;
#ifdef LIXEL_BONES
in vec4 blendIndices;
in vec4 blendWeights;
uniform mat3x4 bones[LIXEL_BONES];
#else
in mat3x4 uv1;
#endif

uniform mat4 viewProj;

out float depth;

void main()
{
#ifdef LIXEL_BONES
    vec3 ws = blendWeights[0] * (vertex * bones[int(blendIndices[0])]);
    for (int i = 1; i < LIXEL_WEIGHTS; ++i)
        ws += blendWeights[i] * (vertex * bones[int(blendIndices[i])]);
#else
    vec3 ws = vertex * uv1;
#endif
    gl_Position = viewProj * vec4(ws, 1.0);
    depth = lixelCasterDepthOf(gl_Position);
}
