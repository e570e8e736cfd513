#version 330 core
// As OGRE's own PSSM receivers do it: the maps' coordinates by texture_viewproj_matrix.
in vec4 vertex;
in vec3 normal;
uniform mat4 worldViewProj;
uniform mat4 world;
uniform mat4 mapFromWorld0;
uniform mat4 mapFromWorld1;
uniform mat4 mapFromWorld2;
out vec3 wsNormal;
out vec3 wsPosition;
out float viewDepth;
out vec4 inMap0;
out vec4 inMap1;
out vec4 inMap2;
void main()
{
    gl_Position = worldViewProj * vertex;
    vec4 ws = world * vertex;
    wsPosition = ws.xyz;
    wsNormal = mat3(world) * normal;
    viewDepth = gl_Position.w;
    inMap0 = mapFromWorld0 * ws;
    inMap1 = mapFromWorld1 * ws;
    inMap2 = mapFromWorld2 * ws;
}
