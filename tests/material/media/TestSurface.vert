#version 330 core
in vec4 vertex;
in vec3 normal;
uniform mat4 worldViewProj;
uniform mat4 world;
out vec3 wsNormal;
out vec3 wsPosition;
void main()
{
    gl_Position = worldViewProj * vertex;
    wsPosition = (world * vertex).xyz;
    wsNormal = mat3(world) * normal;
}
