#version 330 core
// Shadow receiver, shared by the additive, integrated and modulative fragment programs.
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

out vec3 wsPosition;
out vec3 wsNormal;
out vec2 uv;
out vec4 mapCoordinate;

void main()
{
    gl_Position = worldViewProj * vertex;
    vec4 ws = world * vertex;
    wsPosition = ws.xyz;
    wsNormal = mat3(worldInverseTranspose) * normal;
    uv = uv0;
    mapCoordinate = vec4(dot(lixelRowU, ws), dot(lixelRowV, ws), dot(lixelRowW, ws),
                         dot(lixelRowDepth, ws));
}
