#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Lixel::Cg {

enum class Language { Cg, Hlsl };
enum class Stage { Vertex, Fragment };

/// A macro that is defined before the source is read.
struct Define {
    std::string name;
    std::string value;
};

/// Gives the text of an included file by the name in the directive, or nothing if there is none.
using ReadInclude = std::function<std::optional<std::string>(const std::string& name)>;

/// What is to be translated, and to what.
struct Request {
    Language language = Language::Cg;
    Stage stage = Stage::Vertex;
    std::string source;
    /// What messages call the source.
    std::string file;
    /// The profile that is translated for, such as ps_3_0. Of functions that a Cg source has for
    /// several profiles it chooses one.
    std::string profile;
    /// The function to start at.
    std::string entry = "main";
    /// 330 for OpenGL 3.3 and later, 120 for OpenGL 2.1.
    unsigned glslVersion = 330;
    std::vector<Define> defines;
    /// How the application lays matrices out where the source does not say it. A parameter that the
    /// source declares the other way is read transposed, as Direct3D would.
    bool columnMajor = false;
    /// Whether a vertex program's colours are clamped to 0 to 1 between the stages, as profiles
    /// before vs_3_0 have it. OpenGL 2.1 does it by itself.
    bool clampColours = false;
    /// May be empty: then every include is an error.
    ReadInclude readInclude;
};

} // namespace Lixel::Cg
