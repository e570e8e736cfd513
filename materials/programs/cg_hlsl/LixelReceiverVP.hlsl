// Shadow receiver, shared by the additive, integrated and modulative fragment programs, and by
// those that read no shadow map.
#include "LixelVaryings.hlsl"
#include "LixelCoordinate.hlsl"

uniform float4x4 worldViewProj;
uniform float4x4 world;
uniform float4x4 worldInverseTranspose;
uniform float4x4 diffuseMapMatrix; // scale, scroll, rotate of its texture unit
#ifndef LIXEL_NO_MAP
uniform float4 lixelRowU;
uniform float4 lixelRowV;
uniform float4 lixelRowW;
uniform float4 lixelRowDepth;
#endif

void main(float4 vertex : POSITION, float3 normal : NORMAL, float2 uv0 : TEXCOORD0,
          out float4 clip : POSITION, out LixelVaryings seen)
{
    clip = mul(worldViewProj, vertex);
    float4 ws = mul(world, vertex);
    seen.wsPosition = ws.xyz;
    seen.wsNormal = mul((float3x3)worldInverseTranspose, normal);
    seen.uv = mul(diffuseMapMatrix, float4(uv0, 0.0, 1.0)).xy;
    seen.viewDepth = clip.w;
#ifdef LIXEL_NO_MAP
    seen.mapCoordinate = float4(0.0, 0.0, -1.0, 0.0);
#else
    seen.mapCoordinate = lixelCoordinate(lixelRowU, lixelRowV, lixelRowW, lixelRowDepth, ws);
#endif
}
