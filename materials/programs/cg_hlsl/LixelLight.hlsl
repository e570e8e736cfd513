// One light on one surface: Lambert and Blinn-Phong, OGRE's attenuation and spot cone.
uniform float4 lightPosition; // w = 0: the direction towards a directional light
uniform float3 lightDirection;
uniform float4 lightAttenuation; // range, constant, linear, quadratic
uniform float4 spotParams;       // cos(inner / 2), cos(outer / 2), falloff, 1 for a spot
uniform float4 lightDiffuse;     // times the surface's
uniform float4 lightSpecular;    // times the surface's
uniform float shininess;
uniform float3 cameraPosition;
uniform sampler2D diffuseMap;
uniform float4 diffuseMapSize; // (1, 1, 1, 1) where the material has no such texture
uniform float alphaRejection;  // the least alpha that is drawn, by the pass's alpha_rejection

float4 lixelDiffuseMap(float2 uv)
{
    float4 texel = float4(1.0, 1.0, 1.0, 1.0);
    if (diffuseMapSize.x * diffuseMapSize.y > 1.0) texel = tex2D(diffuseMap, uv);
    if (texel.a < alphaRejection) discard;
    return texel;
}

float3 lixelLight(float3 wsPosition, float3 wsNormal, float3 albedo)
{
    // A mesh without normals faces no light.
    float3 n = wsNormal / max(length(wsNormal), 1e-20);
    float3 toLight = lightPosition.xyz - wsPosition * lightPosition.w;
    float range = length(toLight);
    float3 l = toLight / range;
    float lambert = max(dot(n, l), 0.0);

    float strength = 1.0;
    if (lightPosition.w != 0.0)
    {
        strength = range > lightAttenuation.x
            ? 0.0
            : 1.0 / (lightAttenuation.y + range * (lightAttenuation.z + range * lightAttenuation.w));
        if (spotParams.w != 0.0)
        {
            float cone = (dot(-l, normalize(lightDirection)) - spotParams.y) /
                         max(spotParams.x - spotParams.y, 1e-6);
            strength *= pow(saturate(cone), max(spotParams.z, 1e-6));
        }
    }
    float3 h = normalize(l + normalize(cameraPosition - wsPosition));
    float highlight = lambert > 0.0 ? pow(max(dot(n, h), 0.0), max(shininess, 1.0)) : 0.0;
    return strength * (lightDiffuse.rgb * albedo * lambert + lightSpecular.rgb * highlight);
}
