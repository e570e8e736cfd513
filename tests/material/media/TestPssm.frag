#version 330 core
uniform sampler2DShadow shadowMap0;
uniform sampler2DShadow shadowMap1;
uniform sampler2DShadow shadowMap2;
uniform vec4 splitDepths;
uniform vec4 lightPosition;
uniform vec4 lightDiffuse;
in vec3 wsNormal;
in vec3 wsPosition;
in float viewDepth;
in vec4 inMap0;
in vec4 inMap1;
in vec4 inMap2;
out vec4 fragColour;

float lit(sampler2DShadow map, vec4 inMap)
{
    if (inMap.w <= 0.0) return 1.0;
    vec3 uvz = inMap.xyz / inMap.w;
    // A float format's reference is not clamped by GL: what lies beyond the map would be dark.
    uvz.z = min(uvz.z * 0.5 + 0.5, 1.0);
    return texture(map, uvz);
}

void main()
{
    float visibility = viewDepth <= splitDepths.x ? lit(shadowMap0, inMap0)
                     : viewDepth <= splitDepths.y ? lit(shadowMap1, inMap1)
                                                  : lit(shadowMap2, inMap2);
    vec3 toLight = normalize(lightPosition.xyz - wsPosition * lightPosition.w);
    float lambert = max(dot(normalize(wsNormal), toLight), 0.0);
    fragColour = vec4(visibility * lambert * lightDiffuse.rgb, 1.0);
}
