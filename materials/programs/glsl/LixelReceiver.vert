#version 330 core
// Shadow receiver, shared by the additive, integrated and modulative fragment programs, and by
// those that read no shadow map.
#include "LixelVaryings.glsl"
#include "LixelCoordinate.glsl"

in vec4 vertex;
in vec3 normal;
in vec2 uv0;

uniform mat4 worldViewProj;
uniform mat4 world;
uniform mat4 worldInverseTranspose;
uniform mat4 diffuseMapMatrix; // scale, scroll, rotate of its texture unit
#ifndef LIXEL_NO_MAP
uniform vec4 lixelRowU;
uniform vec4 lixelRowV;
uniform vec4 lixelRowW;
uniform vec4 lixelRowDepth;
#endif

void main()
{
    gl_Position = worldViewProj * vertex;
    vec4 ws = world * vertex;
    wsPosition = ws.xyz;
    wsNormal = mat3(worldInverseTranspose) * normal;
    uv = (diffuseMapMatrix * vec4(uv0, 0.0, 1.0)).xy;
#ifdef LIXEL_NO_MAP
    mapCoordinate = vec4(0.0, 0.0, -1.0, 0.0);
#else
    mapCoordinate = lixelCoordinate(lixelRowU, lixelRowV, lixelRowW, lixelRowDepth, ws);
#endif
}
