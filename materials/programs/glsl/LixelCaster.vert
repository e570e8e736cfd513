#version 330 core
// Shadow caster.
#include "LixelCaster.glsl"

in vec4 vertex;
in vec2 uv0;

uniform mat4 worldViewProj;
uniform mat4 diffuseMapMatrix; // scale, scroll, rotate of its texture unit

out float depth;

void main()
{
    gl_Position = worldViewProj * vertex;
    depth = lixelCasterDepthOf(gl_Position);
    lixelCasterUv = (diffuseMapMatrix * vec4(uv0, 0.0, 1.0)).xy;
}
