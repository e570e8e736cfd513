// What a modulative receiver pass multiplies the picture with: the shadow colour in shadow.
#include "LixelVaryings.hlsl"
#include "LixelShadow.hlsl"
#include "LixelFog.hlsl"

uniform float4 shadowColour;
uniform float4 lixelLight; // position, or with w = 0 the direction towards the light

// Cosine of the angle to the light from which on a shadow fades: 76 degrees. Facets of a ball with 16
// sides lean up to 11 degrees away from its normals, and so are in shadow where these are still lit.
static const float Grazing = 0.25;

float4 main(LixelVaryings seen) : COLOR
{
    float visibility = lixelVisibility(seen.mapCoordinate);
    // A surface that faces away is dark by its shading: it has no light to lose, and one that the
    // light grazes has little. A mesh without normals faces nowhere, and is not shaded.
    float3 toLight = normalize(lixelLight.xyz - seen.wsPosition * lixelLight.w);
    if (any(seen.wsNormal != 0.0))
        visibility =
            lerp(1.0, visibility, saturate(dot(normalize(seen.wsNormal), toLight) / Grazing));
    // The picture holds the fog already, which no shadow darkens.
    visibility = lerp(1.0, visibility, lixelThroughFog(seen.viewDepth));
    return float4(lerp(shadowColour.rgb, float3(1.0, 1.0, 1.0), visibility), 1.0);
}
