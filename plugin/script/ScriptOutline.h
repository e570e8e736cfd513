#pragma once

#include "script/ScriptCheck.h"
#include "script/ScriptTokens.h"
#include "script/ScriptVariables.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace Lixel {

/// What a check needs to know of one file.
struct ScriptOutline {
    struct Import {
        std::string target; ///< an object's name, or "*"
        std::string file;
        unsigned line;
    };
    /// One at the top of the file.
    struct Object {
        std::string name;
        unsigned line;
        /// Of shadow_camera_setups alone, as are the lines of properties.
        std::vector<std::string> parents;
        std::size_t lines = 0;
    };
    std::vector<Import> imports;
    std::vector<Object> objects;
};

/// Reads one file's statements.
/// @return the first fault
std::optional<ScriptFault> readOutline(const std::vector<ScriptToken>& tokens,
                                       const std::string& file, ScriptOutline& outline,
                                       ScriptVariables& variables);

} // namespace Lixel
