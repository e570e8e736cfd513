// Shadow caster. OGRE lends it the textures of surfaces that are alpha-tested or blended, and no
// others: their holes are cut here too.
uniform sampler2D diffuseMap : register(s0);
uniform float4 diffuseMapSize; // (1, 1, 1, 1) where it has no texture
uniform float alphaRejection;

// The least alpha of a blended surface that casts a shadow.
static const float Half = 0.5;

float4 main(float2 casterUv : TEXCOORD0, float depth : TEXCOORD1) : COLOR
{
    if (diffuseMapSize.x * diffuseMapSize.y > 1.0)
    {
        float least = alphaRejection > 0.0 ? alphaRejection : Half;
        if (tex2D(diffuseMap, casterUv).a < least) discard;
    }
    // Alpha is 1, because passes of blended surfaces keep their blending.
    return float4(depth, 0.0, 0.0, 1.0);
}
