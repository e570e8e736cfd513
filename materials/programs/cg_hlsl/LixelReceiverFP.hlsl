// One light's contribution to a surface, shadowed: for additive passes, integrated or not.
#include "LixelVaryings.hlsl"
#include "LixelShadow.hlsl"
#include "LixelLight.hlsl"
#include "LixelFog.hlsl"

float4 main(LixelVaryings seen) : COLOR
{
#ifdef LIXEL_MAPS
    float visibility = lixelVisibilityAt(seen.wsPosition);
#else
    float visibility = lixelVisibility(seen.mapCoordinate);
#endif
    float4 texel = lixelDiffuseMap(seen.uv); // which also cuts the surface's holes
#ifdef LIXEL_VISIBILITY_ONLY
    return float4(visibility, visibility, visibility, 1.0);
#else
    float3 light = visibility * lixelLight(seen.wsPosition, seen.wsNormal, texel.rgb);
    return float4(lixelThroughFog(seen.viewDepth) * light, texel.a);
#endif
}
