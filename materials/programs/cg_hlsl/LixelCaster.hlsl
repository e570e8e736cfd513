// What a caster stores in a Lixel shadow map, in Cg and HLSL. Included by every caster's vertex
// program:
//
//     clip = lixelTransform(worldViewProj, vertex); // bent, skinned, ...
//     depth = lixelCasterDepthOf(clip);
uniform float4 lixelCasterDepth; // stored depth = x * clip z + y

// A matrix, by its columns, times a point. Casters drawn one by one and as instances agree on each
// bit, because both are added up in this order.
float4 lixelTransform(float4 x, float4 y, float4 z, float4 w, float4 p)
{
    return ((x * p.x + y * p.y) + z * p.z) + w * p.w;
}

float4 lixelTransform(float4x4 m, float4 p)
{
    float4x4 columns = transpose(m);
    return lixelTransform(columns[0], columns[1], columns[2], columns[3], p);
}

// Depth of a clip position, affine in world space: taken before any division, so that the warp's
// denominator costs it no bits.
float lixelCasterDepthOf(float4 clip)
{
#ifdef OGRE_REVERSED_Z
    // OGRE's option for reversed depth buffers turns clip z into (w - z) / 2.
    return (clip.w - 2.0 * clip.z) * lixelCasterDepth.x + lixelCasterDepth.y;
#else
    return clip.z * lixelCasterDepth.x + lixelCasterDepth.y;
#endif
}
