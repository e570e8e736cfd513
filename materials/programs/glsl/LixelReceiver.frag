#version 330 core
// One light's contribution to a surface, shadowed: for additive passes, integrated or not.
#include "LixelVaryings.glsl"
#include "LixelShadow.glsl"
#include "LixelLight.glsl"
#include "LixelFog.glsl"

out vec4 fragColour;

void main()
{
#ifdef LIXEL_MAPS
    float visibility = lixelVisibilityAt(wsPosition);
#else
    float visibility = lixelVisibility(mapCoordinate);
#endif
    vec4 texel = lixelDiffuseMap(uv); // which also cuts the surface's holes
#ifdef LIXEL_VISIBILITY_ONLY
    fragColour = vec4(vec3(visibility), 1.0);
#else
    vec3 light = visibility * lixelLight(wsPosition, wsNormal, texel.rgb);
    fragColour = vec4(lixelThroughFog() * light, texel.a);
#endif
}
