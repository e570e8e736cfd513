#version 330 core
// Shadow caster. With LIXEL_INSTANCES it is one of many instances without holes: each has its matrix
// in texture coordinates from 1 on, by columns.
#include "LixelCaster.glsl"

in vec4 vertex;
#ifdef LIXEL_INSTANCES
in mat4 uv1;
#define worldViewProj uv1
#else
in vec2 uv0;
uniform mat4 worldViewProj;
uniform mat4 diffuseMapMatrix; // scale, scroll, rotate of its texture unit
#endif

out float depth;

void main()
{
    gl_Position = worldViewProj * vertex;
    depth = lixelCasterDepthOf(gl_Position);
#ifdef LIXEL_INSTANCES
    lixelCasterUv = vec2(0.0);
#else
    lixelCasterUv = (diffuseMapMatrix * vec4(uv0, 0.0, 1.0)).xy;
#endif
}
