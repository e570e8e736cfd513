// A surface lit without shadows: the ambient pass, and lights that cast none.
#include "LixelVaryings.hlsl"
#include "LixelLight.hlsl"
#include "LixelFog.hlsl"

uniform float4 ambient; // light times surface, plus the surface's own emission

float4 main(LixelVaryings seen) : COLOR
{
    float4 texel = lixelDiffuseMap(seen.uv);
#ifdef LIXEL_AMBIENT
    // Drawn first, so the fog's own colour is added here.
    return float4(lixelFogged(ambient.rgb * texel.rgb, seen.viewDepth), texel.a);
#else
    float3 light = lixelLight(seen.wsPosition, seen.wsNormal, texel.rgb);
    return float4(lixelThroughFog(seen.viewDepth) * light, texel.a);
#endif
}
