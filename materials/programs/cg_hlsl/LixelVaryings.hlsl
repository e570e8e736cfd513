// What Lixel's vertex programs hand to its fragment programs, which all take the whole of it.
struct LixelVaryings
{
    float3 wsPosition : TEXCOORD0;
    float3 wsNormal : TEXCOORD1; // of any length; zero where the mesh has no normals
    float2 uv : TEXCOORD2;
    float4 mapCoordinate : TEXCOORD3; // see LixelShadow.hlsl
    float viewDepth : TEXCOORD4;      // in front of the viewer
};
