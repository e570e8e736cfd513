#pragma once

#include "cg/translation/Tokens.h"

#include <string>
#include <string_view>
#include <vector>

namespace Lixel::Cg {

/// Changes of a text, collected while its tokens are read and then made at once. What is not
/// changed keeps its place, so lines keep their numbers.
class Edits {
public:
    /// The text and its tokens must outlive this.
    Edits(std::string_view text, const Tokens& tokens) : mText(text), mTokens(tokens) {}

    /// Newlines and directives within the range stay.
    void replace(TokenRange range, std::string by);
    void replace(std::size_t token, std::string by) { replace({token, token + 1}, std::move(by)); }
    void erase(TokenRange range) { replace(range, {}); }
    /// Text before a token, or at the end where the index is the number of tokens. Of several
    /// insertions at one place the first comes first.
    void insertBefore(std::size_t token, std::string text);
    /// Text right after a token.
    void insertAfter(std::size_t token, std::string text);

    /// The changed text. Of changes that overlap the one that begins first counts, or the
    /// longest of those.
    std::string apply() const;

private:
    struct Edit {
        std::size_t begin;
        std::size_t end;
        std::string by;
    };
    std::string_view mText;
    const Tokens& mTokens;
    std::vector<Edit> mEdits;
};

/// A directive on a line of its own that says where the text after it comes from.
std::string lineDirective(const Tokens& tokens, Place place);

} // namespace Lixel::Cg
