#version 330 core
// What a modulative receiver pass multiplies the picture with: the shadow colour in shadow.
#include "LixelShadow.glsl"

uniform vec4 shadowColour;
uniform vec4 lixelLight; // position, or with w = 0 the direction towards the light

in vec3 wsPosition;
in vec3 wsNormal;
in vec2 uv;
in vec4 mapCoordinate;

out vec4 fragColour;

void main()
{
    float visibility = lixelVisibility(mapCoordinate);
    // A surface that faces away is dark by its shading: it has no light to lose.
    vec3 toLight = lixelLight.xyz - wsPosition * lixelLight.w;
    if (dot(wsNormal, toLight) <= 0.0) visibility = 1.0;
    fragColour = vec4(mix(shadowColour.rgb, vec3(1.0), visibility), 1.0);
}
