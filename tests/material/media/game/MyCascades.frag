#version 330 core
#define LIXEL_BILINEAR 1
#define LIXEL_MAPS 3
#include "LixelVaryings.glsl"
#include "LixelShadow.glsl"

uniform vec4 lightPosition; // w = 0: the direction towards a directional light
uniform vec4 lightDiffuse;
out vec4 fragColour;

void main()
{
    float visibility = lixelVisibilityAt(wsPosition); // call it unconditionally
    vec3 toLight = normalize(lightPosition.xyz - wsPosition * lightPosition.w);
    float steps = floor(3.0 * max(dot(normalize(wsNormal), toLight), 0.0) + 0.5) / 3.0;
    fragColour = vec4(visibility * steps * lightDiffuse.rgb, 1.0);
}
