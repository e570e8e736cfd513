#version 330 core
uniform vec4 lightPosition;
uniform vec4 lightDiffuse;
in vec3 wsNormal;
in vec3 wsPosition;
out vec4 fragColour;
void main()
{
    vec3 toLight = normalize(lightPosition.xyz - wsPosition * lightPosition.w);
    fragColour = vec4(lightDiffuse.rgb * max(dot(normalize(wsNormal), toLight), 0.0), 1.0);
}
