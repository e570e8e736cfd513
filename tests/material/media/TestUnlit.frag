#version 330 core
in vec3 wsNormal;
in vec3 wsPosition;
out vec4 fragColour;
void main()
{
#ifdef BLACK
    fragColour = vec4(0.0, 0.0, 0.0, 1.0);
#else
    fragColour = vec4(0.8, 0.8, 0.8, 1.0);
#endif
}
