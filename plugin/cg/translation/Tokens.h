#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace Lixel::Cg {

/// A place in the user's files.
struct Place {
    std::size_t file = 0; ///< an index into Tokens::files
    unsigned line = 1;
};

/// A token of a preprocessed source, or of GLSL. Comments and directives are none.
struct Token {
    enum class Kind { Word, Number, Mark, Text };
    Kind kind = Kind::Mark;
    std::string_view text; ///< into the source
    std::size_t begin = 0; ///< offset in the source
    Place place;

    std::size_t end() const { return begin + text.size(); }
    bool is(std::string_view other) const { return text == other; }
    bool isWord() const { return kind == Kind::Word; }
};

/// Half open, of indices of tokens.
struct TokenRange {
    std::size_t first = 0;
    std::size_t last = 0;

    bool empty() const { return first >= last; }
};

struct Tokens {
    std::vector<Token> list;
    /// The first is the one that the text began with; then those that #line names.
    std::vector<std::string> files;

    const Token& operator[](std::size_t index) const { return list[index]; }
    std::size_t size() const { return list.size(); }
    /// Whether the token at that index, if there is one, has that text.
    bool isAt(std::size_t index, std::string_view text) const {
        return index < list.size() && list[index].is(text);
    }
    /// The index after the bracket that closes the one at `open`, or `last` if none does.
    std::size_t afterClosing(std::size_t open, std::size_t last) const;
    std::size_t afterClosing(std::size_t open) const { return afterClosing(open, size()); }
};

/// The tokens of a text, which must outlive them.
Tokens tokensOf(std::string_view text, std::string file);

} // namespace Lixel::Cg
