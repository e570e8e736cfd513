#version 330 core
#include "LixelVaryings.glsl"

in vec4 vertex;
in vec3 normal;
in vec2 uv0;
uniform mat4 worldViewProj;
uniform mat4 world;
uniform mat4 worldInverseTranspose;
uniform vec4 lixelRowU;
uniform vec4 lixelRowV;
uniform vec4 lixelRowW;
uniform vec4 lixelRowDepth;

void main()
{
    vec4 bent = vertex + vec4(0.5 * vertex.y, 0.0, 0.0, 0.0);
    gl_Position = worldViewProj * bent;
    vec4 ws = world * bent;
    wsPosition = ws.xyz;
    wsNormal = mat3(worldInverseTranspose) * (normal - vec3(0.0, 0.5 * normal.x, 0.0));
    uv = uv0;
    mapCoordinate = vec4(dot(lixelRowU, ws), dot(lixelRowV, ws), dot(lixelRowW, ws),
                         dot(lixelRowDepth, ws));
}
