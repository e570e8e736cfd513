#version 330 core
// A surface lit without shadows: the ambient pass, and lights that cast none.
#include "LixelLight.glsl"

uniform vec4 ambient; // light times surface, plus the surface's own emission

in vec3 wsPosition;
in vec3 wsNormal;
in vec2 uv;

out vec4 fragColour;

void main()
{
    vec4 texel = lixelDiffuseMap(uv);
#ifdef LIXEL_AMBIENT
    fragColour = vec4(ambient.rgb * texel.rgb, texel.a);
#else
    fragColour = vec4(lixelLight(wsPosition, wsNormal, texel.rgb), texel.a);
#endif
}
