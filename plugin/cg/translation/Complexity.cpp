#include "cg/translation/Complexity.h"

#include <string>

namespace Lixel::Cg {
namespace {

// A stack of 8 MiB, or of 1 MiB in a thread of the application's, holds several times as much.
constexpr unsigned DeepestBrackets = 128;
constexpr unsigned LongestStatement = 4096; // tokens
constexpr unsigned LongestSigns = 32;       // of unary operators, one after another
constexpr unsigned LongestElse = 256;       // of else if, one in another

} // namespace

void checkComplexity(const Tokens& tokens, Messages& messages) {
    unsigned depth = 0;
    unsigned statement = 0;
    unsigned signs = 0;
    unsigned elses = 0;
    for (const Token& token : tokens.list) {
        const bool opens = token.is("(") || token.is("[") || token.is("{");
        const bool closes = token.is(")") || token.is("]") || token.is("}");
        if (opens) ++depth;
        if (closes && depth > 0) --depth;
        const bool ends = token.is(";") || token.is("{") || token.is("}") || token.is(",");
        statement = ends ? 0 : statement + 1;
        const bool sign = token.is("-") || token.is("+") || token.is("!") || token.is("~") ||
                          token.is("--") || token.is("++");
        signs = sign ? signs + 1 : 0;
        if (token.is("else")) ++elses;
        if (depth == 0) elses = 0;
        const char* what = depth > DeepestBrackets        ? "brackets in brackets"
                           : statement > LongestStatement ? "tokens in a statement"
                           : signs > LongestSigns         ? "operators in a row"
                           : elses > LongestElse          ? "else"
                                                          : nullptr;
        if (what == nullptr) continue;
        messages.push_back({Message::Kind::Error, tokens.files[token.place.file], token.place.line,
                            std::string("too many ") + what});
        return;
    }
}

} // namespace Lixel::Cg
