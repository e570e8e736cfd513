#pragma once

#include "cg/translation/Outline.h"
#include "cg/translation/Request.h"
#include "cg/translation/Translation.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace Lixel::Cg {

/// A parameter of the source, and what the front end knows it as.
struct SourceParameter {
    Parameter parameter; ///< without a GLSL name
    std::string hlslName;
};

/// A sampler, or a texture or sampler state of HLSL's later form, in the order of the source.
struct SourceSampler {
    std::string name;
    std::string hlslName;
    int unit = -1; ///< of the register that it names, or -1
};

/// A source as the front end reads it.
struct Rewritten {
    std::string text;
    std::string prelude; ///< goes before it
    std::vector<SourceParameter> parameters;
    std::vector<SourceSampler> samplers;
    /// Whether textures and the ways of reading them are parameters of their own.
    bool hasSeparateSamplers = false;
    /// Where the entry point is.
    std::string entryFile;
    unsigned entryLine = 0;
};

/// Turns a preprocessed source into HLSL that the front end takes for what it means: uniform
/// parameters of the entry point become global, default values and registers are taken out and
/// noted, functions that the entry point does not reach are left out, words that Cg does not
/// reserve get other names. Nothing if there was an error, which is added to messages.
std::optional<Rewritten> rewrite(const Request& request, std::string_view preprocessed,
                                 Messages& messages);

} // namespace Lixel::Cg
