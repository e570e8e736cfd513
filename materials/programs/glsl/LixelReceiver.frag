#version 330 core
// One light's contribution to a surface, shadowed: for additive passes, integrated or not.
#include "LixelShadow.glsl"
#include "LixelLight.glsl"

in vec3 wsPosition;
in vec3 wsNormal;
in vec2 uv;
in vec4 mapCoordinate;

out vec4 fragColour;

void main()
{
#ifdef LIXEL_MAPS
    float visibility = lixelVisibilityAt(wsPosition);
#else
    float visibility = lixelVisibility(mapCoordinate);
#endif
#ifdef LIXEL_VISIBILITY_ONLY
    fragColour = vec4(vec3(visibility), 1.0);
#else
    vec4 texel = lixelDiffuseMap(uv);
    fragColour = vec4(visibility * lixelLight(wsPosition, wsNormal, texel.rgb), texel.a);
#endif
}
