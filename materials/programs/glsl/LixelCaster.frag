#version 330 core
in float depth;

out vec4 fragColour;

void main()
{
    fragColour = vec4(depth);
}
