#include "cg/translation/FunctionBody.h"

#include "cg/translation/Prelude.h"

#include <string>

namespace Lixel::Cg {
namespace {

/// The first token of a[i].x, f(x) and the like, which ends before an index; the index itself
/// if there is none.
std::size_t beginOfOperand(const Tokens& tokens, const FunctionOutline& function, std::size_t end) {
    static const std::unordered_set<std::string_view> keywords = {"return", "else", "do", "case"};
    std::size_t begin = end;
    while (begin > function.body.first + 1) {
        const Token& last = tokens[begin - 1];
        if (last.is("]") || last.is(")")) {
            std::size_t depth = 0;
            do {
                --begin;
                if (tokens[begin].is("]") || tokens[begin].is(")")) ++depth;
                if (tokens[begin].is("[") || tokens[begin].is("(")) --depth;
            } while (depth > 0 && begin > function.body.first + 1);
            // What is before it belongs to it, as in a[i] and f(x); or nothing, as in (x).
            const Token& previous = tokens[begin - 1];
            if (!previous.isWord() && !previous.is("]") && !previous.is(")")) break;
        } else if (last.isWord() && keywords.count(last.text) == 0) {
            --begin;
            if (!tokens[begin - 1].is(".")) break;
            --begin;
        } else {
            break;
        }
    }
    return begin;
}

} // namespace

std::vector<std::size_t> functionsWithin(const Tokens& tokens, const FunctionOutline& function) {
    static const std::unordered_set<std::string_view> statements = {"if", "for", "while", "switch"};
    std::vector<std::size_t> names;
    for (std::size_t at = function.body.first; at + 2 < function.body.last; ++at) {
        if (!tokens[at].isWord() || !tokens[at + 1].isWord() || !tokens[at + 2].is("(") ||
            statements.count(tokens[at + 1].text) != 0)
            continue;
        const std::size_t after = tokens.afterClosing(at + 2, function.body.last);
        if (tokens.isAt(after, "{") || tokens.isAt(after, ":")) names.push_back(at + 1);
    }
    return names;
}

void rewriteCounting(const Tokens& tokens, const FunctionOutline& function, Edits& edits,
                     std::unordered_set<std::string_view>& fromPrelude) {
    for (std::size_t sign = function.body.first + 1; sign + 1 < function.body.last; ++sign) {
        if (!tokens[sign].is("++") && !tokens[sign].is("--")) continue;
        const std::size_t begin = beginOfOperand(tokens, function, sign);
        if (begin == sign) continue; // it stands before its variable
        const Token& before = tokens[begin - 1];
        const Token& after = tokens[sign + 1];
        const std::string text(tokens[sign].text);
        const bool isStatement = (before.is(";") || before.is("{") || before.is("}")) &&
                                 (after.is(";") || after.is(")"));
        if (isStatement) {
            edits.insertBefore(begin, text + ' ');
            edits.erase({sign, sign + 1});
        } else {
            fromPrelude.insert(text == "++" ? PostIncrement : PostDecrement);
            edits.insertBefore(begin, preludeNameOf(text) + '(');
            edits.replace(sign, ")");
        }
    }
}

} // namespace Lixel::Cg
