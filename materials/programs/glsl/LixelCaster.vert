#version 330 core
// Shadow caster: stores depth affine in world space, before any division, so that the warp's
// denominator costs it no bits.
in vec4 vertex;

uniform mat4 worldViewProj;
uniform vec4 lixelCasterDepth; // stored depth = x * clip z + y

out float depth;

void main()
{
    gl_Position = worldViewProj * vertex;
    depth = gl_Position.z * lixelCasterDepth.x + lixelCasterDepth.y;
}
