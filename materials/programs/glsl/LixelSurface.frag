#version 330 core
// A surface lit without shadows: the ambient pass, and lights that cast none.
#include "LixelVaryings.glsl"
#include "LixelLight.glsl"
#include "LixelFog.glsl"

uniform vec4 ambient; // light times surface, plus the surface's own emission

out vec4 fragColour;

void main()
{
    vec4 texel = lixelDiffuseMap(uv);
#ifdef LIXEL_AMBIENT
    // Drawn first, so the fog's own colour is added here.
    fragColour = vec4(lixelFogged(ambient.rgb * texel.rgb), texel.a);
#else
    vec3 light = lixelLight(wsPosition, wsNormal, texel.rgb);
    fragColour = vec4(lixelThroughFog() * light, texel.a);
#endif
}
