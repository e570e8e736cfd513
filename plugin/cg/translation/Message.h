#pragma once

#include <string>
#include <vector>

namespace Lixel::Cg {

/// What is wrong with a source, and where.
struct Message {
    enum class Kind { Error, Warning };
    Kind kind = Kind::Error;
    /// The user's file, an included one too; empty where no place is to blame.
    std::string file;
    unsigned line = 0; ///< from 1; 0 where no line is to blame
    std::string text;
};

using Messages = std::vector<Message>;

/// The first error; the others mostly follow from it. Null if there is none.
const Message* firstError(const Messages& messages);

/// "ERROR: file:line: text", or without what is not known.
std::string toString(const Message& message);

} // namespace Lixel::Cg
