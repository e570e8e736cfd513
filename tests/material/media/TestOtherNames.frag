#version 330 core
#include "LixelVaryings.glsl"
uniform vec4 first;
uniform vec4 second;
uniform vec4 third;
uniform vec4 fourth;
out vec4 fragColour;
void main()
{
    fragColour = first + second + third + fourth;
}
