// Of "Shadow Mapping in Ogre" (Hamilton Y. Chong, 2006, §4), as the article prints it.
uniform mat4 uModelViewProjection;    // modelview projection matrix

varying vec4 pPosition;              // post projection position coordinates
varying vec4 pNormal;                // normal in object space (to be interpolated)
varying vec4 pModelPos;              // position in object space (to be interpolated)

void main()
{
    // Transform vertex position into post projective (homogenous screen) space.
    gl_Position = uModelViewProjection * gl_Vertex;
    pPosition   = uModelViewProjection * gl_Vertex;

    // copy over data to interpolate using perspective correct interpolation
    pNormal     = vec4(gl_Normal.x, gl_Normal.y, gl_Normal.z, 0.0);
    pModelPos   = gl_Vertex;
}
