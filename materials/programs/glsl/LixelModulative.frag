#version 330 core
// What a modulative receiver pass multiplies the picture with: the shadow colour in shadow.
#include "LixelVaryings.glsl"
#include "LixelShadow.glsl"
#include "LixelFog.glsl"

uniform vec4 shadowColour;
uniform vec4 lixelLight; // position, or with w = 0 the direction towards the light

out vec4 fragColour;

// Cosine of the angle to the light from which on a shadow fades: 76 degrees. Facets of a ball with 16
// sides lean up to 11 degrees away from its normals, and so are in shadow where these are still lit.
const float Grazing = 0.25;

void main()
{
    float visibility = lixelVisibility(mapCoordinate);
    // A surface that faces away is dark by its shading: it has no light to lose, and one that the
    // light grazes has little. A mesh without normals faces nowhere, and is not shaded.
    vec3 toLight = normalize(lixelLight.xyz - wsPosition * lixelLight.w);
    if (wsNormal != vec3(0.0))
        visibility = mix(1.0, visibility, clamp(dot(normalize(wsNormal), toLight) / Grazing, 0.0, 1.0));
    // The picture holds the fog already, which no shadow darkens.
    visibility = mix(1.0, visibility, lixelThroughFog());
    fragColour = vec4(mix(shadowColour.rgb, vec3(1.0), visibility), 1.0);
}
