#pragma once

#include "cg/translation/Message.h"

#include <string>
#include <vector>

namespace Lixel::Cg {

/// A uniform parameter of the source that is a number, a vector, a matrix, or an array of these.
struct Parameter {
    enum class Base { Float, Int };
    std::string name;     ///< as the source and scripts call it
    std::string glslName; ///< of the uniform in the translation
    Base base = Base::Float;
    unsigned rows = 1;     ///< of a matrix; 1 for numbers and vectors
    unsigned columns = 1;  ///< of a matrix, or the components of a vector
    unsigned elements = 0; ///< of an array; 0 where it is none
    /// In the order of the source, rows × columns × max(elements, 1), or empty: no default value.
    std::vector<float> defaults;
    /// Whether the translation declares it. What the source does not use it has not.
    bool used = false;
};

/// A texture of the source.
struct Sampler {
    std::string name;
    std::string glslName;
    std::string glslType; ///< such as sampler2D
    unsigned unit = 0;    ///< the index of the texture unit
};

/// A GLSL program, and how what scripts know of its source is found in it.
struct Translation {
    /// Empty if there was an error.
    std::string glsl;
    std::vector<Parameter> parameters;
    /// Only those that are used.
    std::vector<Sampler> samplers;
    /// The vertex attributes that it reads, by the names that OGRE binds.
    std::vector<std::string> attributes;
    Messages messages;

    bool succeeded() const { return !glsl.empty(); }
};

} // namespace Lixel::Cg
