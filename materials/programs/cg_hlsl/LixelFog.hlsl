// The scene manager's fog, which OGRE leaves to the programs.
uniform float4 lixelFog; // mode (0 none, 1 exp, 2 exp2, 3 linear), density, start, end
uniform float4 lixelFogColour;

// How much of a fragment's own colour comes through the fog, 0 to 1.
//
// A pass that adds a light multiplies its colour by it. A pass that is drawn first also adds the
// fog's own colour, once: see lixelFogged.
float lixelThroughFog(float viewDepth)
{
    if (lixelFog.x > 2.5)
        return saturate((lixelFog.w - viewDepth) / max(lixelFog.w - lixelFog.z, 1e-6));
    float thickness = lixelFog.y * viewDepth;
    if (lixelFog.x > 1.5) return exp(-thickness * thickness);
    return lixelFog.x > 0.5 ? exp(-thickness) : 1.0;
}

float3 lixelFogged(float3 colour, float viewDepth)
{
    return lerp(lixelFogColour.rgb, colour, lixelThroughFog(viewDepth));
}
