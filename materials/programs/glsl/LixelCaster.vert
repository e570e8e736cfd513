#version 330 core
// Shadow caster.
#include "LixelCaster.glsl"

in vec4 vertex;

uniform mat4 worldViewProj;

out float depth;

void main()
{
    gl_Position = worldViewProj * vertex;
    depth = lixelCasterDepthOf(gl_Position);
}
