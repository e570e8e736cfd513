// One light on one surface: Lambert and Blinn-Phong, OGRE's attenuation and spot cone.
uniform vec4 lightPosition; // w = 0: the direction towards a directional light
uniform vec3 lightDirection;
uniform vec4 lightAttenuation; // range, constant, linear, quadratic
uniform vec4 spotParams;       // cos(inner / 2), cos(outer / 2), falloff, 1 for a spot
uniform vec4 lightDiffuse;     // times the surface's
uniform vec4 lightSpecular;    // times the surface's
uniform float shininess;
uniform vec3 cameraPosition;
uniform sampler2D diffuseMap;
uniform vec4 diffuseMapSize; // (1, 1, 1, 1) where the material has no such texture
uniform float alphaRejection; // the least alpha that is drawn, by the pass's alpha_rejection

vec4 lixelDiffuseMap(vec2 uv)
{
    vec4 texel = diffuseMapSize.x * diffuseMapSize.y > 1.0 ? texture(diffuseMap, uv) : vec4(1.0);
    if (texel.a < alphaRejection) discard;
    return texel;
}

vec3 lixelLight(vec3 wsPosition, vec3 wsNormal, vec3 albedo)
{
    // A mesh without normals faces no light.
    vec3 n = wsNormal / max(length(wsNormal), 1e-20);
    vec3 toLight = lightPosition.xyz - wsPosition * lightPosition.w;
    float range = length(toLight);
    vec3 l = toLight / range;
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
            strength *= pow(clamp(cone, 0.0, 1.0), max(spotParams.z, 1e-6));
        }
    }
    vec3 h = normalize(l + normalize(cameraPosition - wsPosition));
    float highlight = lambert > 0.0 ? pow(max(dot(n, h), 0.0), max(shininess, 1.0)) : 0.0;
    return strength * (lightDiffuse.rgb * albedo * lambert + lightSpecular.rgb * highlight);
}
