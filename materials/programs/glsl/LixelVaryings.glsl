// What Lixel's vertex programs hand to its fragment programs. Both sides include this one list: with
// separate shader objects, OGRE's default since version 14, a fragment program that declares fewer
// varyings than its vertex program reads rubbish from the others.
#ifdef OGRE_VERTEX_SHADER
#define LIXEL_VARYING out
#else
#define LIXEL_VARYING in
#endif

LIXEL_VARYING vec3 wsPosition;
LIXEL_VARYING vec3 wsNormal; // of any length; zero where the mesh has no normals
LIXEL_VARYING vec2 uv;
LIXEL_VARYING vec4 mapCoordinate; // see LixelShadow.glsl
