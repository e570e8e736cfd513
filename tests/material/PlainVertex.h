#pragma once

namespace Lixel::Tests {

/// A vertex program's text that only places the vertex, by `worldViewProj`.
inline const char* const PlainVertex = R"(#version 330 core
in vec4 vertex;
uniform mat4 worldViewProj;
void main()
{
    gl_Position = worldViewProj * vertex;
}
)";

} // namespace Lixel::Tests
