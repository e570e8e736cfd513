// What a caster stores in a Lixel shadow map. Included by every caster's vertex program:
//
//     gl_Position = worldViewProj * vertex; // bent, skinned, ...
//     depth = lixelCasterDepthOf(gl_Position);
uniform vec4 lixelCasterDepth; // stored depth = x * clip z + y

// Casters drawn one by one and as instances agree on each bit.
invariant gl_Position;

// Where the surface's texture is read, if its alpha cuts holes. For other surfaces it need not be set.
out vec2 lixelCasterUv;

// Depth of a clip position, affine in world space: taken before any division, so that the warp's
// denominator costs it no bits.
float lixelCasterDepthOf(vec4 clip)
{
#ifdef OGRE_REVERSED_Z
    // OGRE's option for reversed depth buffers turns clip z into (w - z) / 2.
    return (clip.w - 2.0 * clip.z) * lixelCasterDepth.x + lixelCasterDepth.y;
#else
    return clip.z * lixelCasterDepth.x + lixelCasterDepth.y;
#endif
}
