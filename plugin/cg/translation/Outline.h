#pragma once

#include "cg/translation/Tokens.h"

#include <optional>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace Lixel::Cg {

/// One name that a declaration declares.
struct Declarator {
    std::size_t name = 0;  ///< the token's index
    TokenRange arrays;     ///< [2][3]
    TokenRange semantic;   ///< with its colon; a register too; all of them where there are several
    TokenRange annotation; ///< <string UIName = "x";>
    TokenRange initial;    ///< without the equals sign
    TokenRange tail;       ///< all that follows the arrays
};

/// [modifiers] type declarator, declarator…
struct Declaration {
    TokenRange all; ///< without the semicolon
    TokenRange modifiers;
    TokenRange type;
    std::vector<Declarator> declarators;
};

struct FunctionOutline {
    std::size_t begin = 0; ///< its first token
    /// The profile that Cg has it for, which stands before all else; empty if it is for all.
    std::string_view profile;
    std::size_t name = 0;
    bool hasGoodHead = false; ///< a type before the name, and one semantic or none at the end
    TokenRange parameters;    ///< within the parentheses
    TokenRange body;          ///< with its braces; empty if it is only declared
};

/// What a source declares outside of functions.
struct Outline {
    std::vector<Declaration> variables;
    std::vector<FunctionOutline> functions;
    /// Of types and all else that has a name of its own.
    std::unordered_set<std::string_view> typeNames;
    std::unordered_set<std::string_view> structNames;
    /// Heads and ends of constant buffers, whose members are among the variables.
    std::vector<TokenRange> bufferMarks;
    /// Statements that are no declarations.
    std::vector<TokenRange> unknown;
    /// Techniques and other parts of effect files, which programs do not need.
    std::vector<TokenRange> effects;
};

Outline outlineOf(const Tokens& tokens);

/// Reads one declaration, of a variable or of a parameter. Nothing if the tokens are none.
std::optional<Declaration> declarationOf(const Tokens& tokens, TokenRange range);

/// The parts of a range between commas that are in no brackets.
std::vector<TokenRange> splitAtCommas(const Tokens& tokens, TokenRange range);

bool hasModifier(const Tokens& tokens, const Declaration& declaration, std::string_view modifier);

} // namespace Lixel::Cg
