#version 330 core
#include "LixelVaryings.glsl"
#include "LixelShadow.glsl"

out vec4 fragColour;

void main()
{
    fragColour = vec4(lixelVisibilityAt(wsPosition));
}
