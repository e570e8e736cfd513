#pragma once

#include <functional>
#include <optional>
#include <string>

namespace Lixel {

/// What is wrong with a script, and where.
struct ScriptFault {
    std::string file;
    unsigned line;
    std::string what;
};

/// The text of a script that another imports; none where there is no such file.
using ScriptReader = std::function<std::optional<std::string>(const std::string& file)>;

/** The first fault in the structure of a `.shadow` script and of all that it imports.

    OGRE's compiler (1.12 to 14) does not survive some scripts: it recurses without end on files
    that import one another and on variables that name one another, expands variables and copies
    parents to any length, reads past the end of a file that ends in `import`, and throws out of the
    initialisation of a whole resource group on others. A script without a fault here is safe to
    hand to it. What a setup's lines say is not looked at.

    Variables of one name are taken for one, wherever they are set.
*/
std::optional<ScriptFault> findScriptFault(const std::string& script, const std::string& file,
                                           const ScriptReader& read);

} // namespace Lixel
