// Shadow caster. With LIXEL_INSTANCES it is one of many instances without holes: each has its matrix
// in texture coordinates from 1 on, by columns.
#include "LixelCaster.hlsl"

#ifndef LIXEL_INSTANCES
uniform float4x4 worldViewProj;
uniform float4x4 diffuseMapMatrix; // scale, scroll, rotate of its texture unit
#endif

void main(float4 vertex : POSITION,
#ifdef LIXEL_INSTANCES
          float4 x : TEXCOORD1, float4 y : TEXCOORD2, float4 z : TEXCOORD3, float4 w : TEXCOORD4,
#else
          float2 uv0 : TEXCOORD0,
#endif
          out float4 clip : POSITION, out float2 casterUv : TEXCOORD0, out float depth : TEXCOORD1)
{
#ifdef LIXEL_INSTANCES
    clip = lixelTransform(x, y, z, w, vertex);
    casterUv = float2(0.0, 0.0);
#else
    clip = lixelTransform(worldViewProj, vertex);
    casterUv = mul(diffuseMapMatrix, float4(uv0, 0.0, 1.0)).xy;
#endif
    depth = lixelCasterDepthOf(clip);
}
