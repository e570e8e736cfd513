#pragma once

#include "script/ScriptCheck.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Lixel {

/// A value that a script gives to a variable.
struct VariableValue {
    std::string file;
    unsigned line;
    std::size_t words = 0;
    /// How often it names each other variable.
    std::map<std::string, std::size_t> uses;
};

/// All values of each variable, wherever it is set.
using ScriptVariables = std::map<std::string, std::vector<VariableValue>>;

/// The first value that OGRE's compiler would not survive: it expands variables without a bound.
std::optional<ScriptFault> findVariableFault(const ScriptVariables& variables);

} // namespace Lixel
