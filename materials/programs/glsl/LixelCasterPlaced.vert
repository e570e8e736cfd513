#version 330 core
// Shadow caster whose vertices its program places. Either LIXEL_BONES bones bend them, and
// LIXEL_WEIGHTS bones move each vertex. Or, where these are not defined, it is one of many instances:
// LIXEL_MATRIX has the rows of its matrix, its texture coordinates from one set on.
//
// With LIXEL_QUATERNIONS bones are dual quaternions: (w, x, y, z) of the turn, then of the shift. With
// LIXEL_SCALES a matrix scales and shears before them. With LIXEL_ANTIPODAL all are turned to the
// hemisphere of the first, as turns of more than 180 degrees need.
#include "LixelCaster.glsl"

in vec4 vertex;
in vec2 uv0;
#ifdef LIXEL_BONES
in vec4 blendIndices;
in vec4 blendWeights;
#ifdef LIXEL_QUATERNIONS
uniform mat2x4 bones[LIXEL_BONES];
#else
uniform mat3x4 bones[LIXEL_BONES];
#endif
#ifdef LIXEL_SCALES
uniform mat3x4 scales[LIXEL_BONES];
#endif
#else
in mat3x4 LIXEL_MATRIX;
#endif

// To clip space from where bones and instances' matrices place vertices: the world, or the object.
uniform mat4 clipFromPlaced;
uniform mat4 diffuseMapMatrix; // scale, scroll, rotate of its texture unit

out float depth;

#ifdef LIXEL_QUATERNIONS

// The turn and shift by a dual quaternion (Kavan et al. 2008, algorithm 1).
vec3 moved(vec3 position, mat2x4 bone)
{
    vec4 turn = bone[0], shift = bone[1];
    return position + 2.0 * cross(turn.yzw, cross(turn.yzw, position) + turn.x * position) +
           2.0 * (turn.x * shift.yzw - shift.x * turn.yzw + cross(turn.yzw, shift.yzw));
}

vec3 placedVertex()
{
    vec3 position = vertex.xyz;
#ifdef LIXEL_SCALES
    position = vec3(0.0);
    for (int i = 0; i < LIXEL_WEIGHTS; ++i)
        position += blendWeights[i] * (vertex * scales[int(blendIndices[i])]);
#endif
    mat2x4 first = bones[int(blendIndices[0])];
    mat2x4 blended = blendWeights[0] * first;
    for (int i = 1; i < LIXEL_WEIGHTS; ++i)
    {
        mat2x4 bone = bones[int(blendIndices[i])];
#ifdef LIXEL_ANTIPODAL
        if (dot(first[0], bone[0]) < 0.0) bone = -bone;
#endif
        blended += blendWeights[i] * bone;
    }
    return moved(position, blended / length(blended[0]));
}

#elif defined(LIXEL_BONES)

vec3 placedVertex()
{
    vec3 placed = vec3(0.0);
    for (int i = 0; i < LIXEL_WEIGHTS; ++i)
        placed += blendWeights[i] * (vertex * bones[int(blendIndices[i])]);
    return placed;
}

#else

vec3 placedVertex()
{
    return vertex * LIXEL_MATRIX;
}

#endif

void main()
{
    gl_Position = clipFromPlaced * vec4(placedVertex(), 1.0);
    depth = lixelCasterDepthOf(gl_Position);
    lixelCasterUv = (diffuseMapMatrix * vec4(uv0, 0.0, 1.0)).xy;
}
