#pragma once

#include "cg/translation/Profile.h"
#include "cg/translation/Request.h"

#include <optional>
#include <string>
#include <vector>

namespace Lixel::Cg {

/// What a script says of a program besides its source.
struct ProgramOptions {
    std::string entry = "main";
    /// Profiles of a Cg program, the target of an HLSL one. Separated by spaces.
    std::string profiles;
    /// Of a Cg program: its compiler's command line.
    std::string compileArguments;
    /// Of an HLSL program, as in Direct3D.
    bool columnMajor = true;
};

/// The first of the profiles that can be translated for a stage. An HLSL program without a target
/// has vs_2_0 or ps_2_0, as in OGRE. Nothing if there is none.
std::optional<Profile> chosenProfile(const ProgramOptions& options, Language language, Stage stage);

/// The lowest shader model among the profiles that are known: 3 up to vs_3_0, 4 for vs_4_0… Sources
/// that are for several take from OGRE_HLSL which form to have; the older is the plainer.
int shaderModelOf(const ProgramOptions& options);

/// Macros of a text such as "A,B=2;C" (preprocessor_defines) or "-DA -DB=2 -D C" (Cg's command
/// line). Adds other arguments of a command line to `ignored`.
std::vector<Define> definesOf(const std::string& text, std::vector<std::string>& ignored);

} // namespace Lixel::Cg
