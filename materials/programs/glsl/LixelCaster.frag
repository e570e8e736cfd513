#version 330 core
// Shadow caster. OGRE lends it the textures of surfaces that are alpha-tested or blended, and no
// others: their holes are cut here too.
in vec2 lixelCasterUv;
in float depth;

uniform sampler2D diffuseMap;
uniform vec4 diffuseMapSize; // (1, 1, 1, 1) where it has no texture
uniform float alphaRejection;

// The least alpha of a blended surface that casts a shadow.
const float Half = 0.5;

out vec4 fragColour;

void main()
{
    if (diffuseMapSize.x * diffuseMapSize.y > 1.0)
    {
        float least = alphaRejection > 0.0 ? alphaRejection : Half;
        if (texture(diffuseMap, lixelCasterUv).a < least) discard;
    }
    // Alpha is 1, because passes of blended surfaces keep their blending.
    fragColour = vec4(depth, 0.0, 0.0, 1.0);
}
