#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace Lixel {

/// A token of OGRE's script language.
struct ScriptToken {
    enum class Type { Word, Quote, Variable, LeftBrace, RightBrace, Colon, Newline };
    Type type;
    /// Without the quotes; a variable with its $.
    std::string text;
    unsigned line; ///< from 1
};

/// A script, divided as OGRE's own lexer does.
struct ScriptTokens {
    std::vector<ScriptToken> tokens;
    /// The line of a quotation mark that has no other; 0 if there is none.
    unsigned openQuote = 0;
    /// The line of a comment that does not end; 0 where all do.
    unsigned openComment = 0;
};

ScriptTokens tokensOf(std::string_view script);

} // namespace Lixel
