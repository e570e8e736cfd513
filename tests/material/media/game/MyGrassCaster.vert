#version 330 core
#include "LixelCaster.glsl"

in vec4 vertex;
uniform mat4 worldViewProj;
out float depth;

void main()
{
    gl_Position = worldViewProj * (vertex + vec4(0.5 * vertex.y, 0.0, 0.0, 0.0));
    depth = lixelCasterDepthOf(gl_Position);
}
