// Of "Shadow Mapping in Ogre" (Hamilton Y. Chong, 2006, §4), as the article prints it.
uniform mat4 uModelViewProjection; // modelview projection matrix
uniform mat4 uModel;                // model matrix
uniform mat4 uTextureViewProjection; // shadow map's view projection matrix

uniform vec4 uLightPosition;          // light position in object space

varying vec4  pShadowCoord;   // vertex position in shadow map coordinates
varying float pDiffuse;      // diffuse shading value

void main()
{
    // compute diffuse shading
    vec3 lightDirection = normalize(uLightPosition.xyz - gl_Vertex.xyz);
    pDiffuse = dot(gl_Normal.xyz, lightDirection);

    // compute shadow map lookup coordinates
    pShadowCoord = uTextureViewProjection * (uModel * gl_Vertex);

    // compute vertex's homogenous screen-space coordinates
    // Use following line if other passes use shaders
    //gl_Position = uModelViewProjection * gl_Vertex;
    gl_Position = ftransform(); // uncomment if other passes use fixed function pipeline
}
