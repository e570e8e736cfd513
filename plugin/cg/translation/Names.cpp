#include "cg/translation/Names.h"

#include "cg/translation/Types.h"

#include <string_view>

namespace Lixel::Cg {
namespace {

using NameSet = std::unordered_set<std::string_view>;

/// Words of the language that stand alone, and attributes of statements.
const NameSet LanguageWords = {
    "if",           "else",     "for",           "while",     "do",      "switch",
    "case",         "default",  "return",        "break",     "discard", "static",
    "continue",     "const",    "struct",        "void",      "true",    "false",
    "in",           "out",      "inout",         "uniform",   "varying", "unroll",
    "loop",         "branch",   "flatten",       "call",      "fastopt", "typedef",
    "row_major",    "NULL",     "double",        "string",    "precise", "packed",
    "column_major", "unsigned", "register",      "forcecase", "glstate", "technique",
    "pass",         "compile",  "sampler_state", "volatile",  "extern",  "allow_uav_condition"};

bool isLanguage(const Tokens& tokens, std::size_t at) {
    const std::string_view word = tokens[at].text;
    if (LanguageWords.count(word) != 0 || isSamplerType(word)) return true;
    if (numberTypeOf(tokens, {at, at + 1})) return true;
    for (const char* type : {"double", "min1", "int64", "uint64", "snorm", "unorm", "Texture",
                             "sampler", "Sampler", "Buffer", "RW"})
        if (word.starts_with(type)) return true;
    return false;
}

/// Whether the token can be the name that a declaration declares: after a type, or after a comma
/// and before what follows a name that is declared.
bool mayBeDeclared(const Tokens& tokens, std::size_t at) {
    const Token& before = tokens[at - 1];
    if (before.isWord()) return before.text != "return" && before.text != "case";
    if (before.is(">") || before.is("]")) return true;
    if (!before.is(",") && !before.is("}")) return false;
    return tokens.isAt(at + 1, "=") || tokens.isAt(at + 1, ",") || tokens.isAt(at + 1, ";") ||
           tokens.isAt(at + 1, "[");
}

} // namespace

std::optional<std::size_t> unknownName(const Tokens& tokens, const Outline& outline,
                                       const std::vector<const FunctionOutline*>& functions) {
    NameSet known = outline.structNames;
    known.insert(outline.typeNames.begin(), outline.typeNames.end());
    for (const Declaration& variable : outline.variables)
        for (const Declarator& declarator : variable.declarators)
            known.insert(tokens[declarator.name].text);
    for (const FunctionOutline* function : functions) {
        known.insert(tokens[function->name].text);
        for (std::size_t at = function->parameters.first; at < function->body.last; ++at)
            if (tokens[at].isWord() && mayBeDeclared(tokens, at)) known.insert(tokens[at].text);
    }
    for (const FunctionOutline* function : functions) {
        for (std::size_t at = function->body.first; at < function->body.last; ++at) {
            if (!tokens[at].isWord() || tokens[at - 1].is(".") || tokens.isAt(at + 1, "("))
                continue;
            if (known.count(tokens[at].text) == 0 && !isLanguage(tokens, at)) return at;
        }
    }
    return {};
}

} // namespace Lixel::Cg
