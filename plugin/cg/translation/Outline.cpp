#include "cg/translation/Outline.h"

#include "cg/translation/Profile.h"

#include <algorithm>

namespace Lixel::Cg {
namespace {

const std::unordered_set<std::string_view> Modifiers = {
    "static",   "const",        "uniform",         "extern",        "varying",  "in",
    "out",      "inout",        "volatile",        "shared",        "precise",  "row_major",
    "linear",   "column_major", "nointerpolation", "noperspective", "centroid", "sample",
    "unsigned", "groupshared",  "inline",          "packed",        "snorm",    "unorm"};

/// The index after the type that begins there.
std::size_t afterType(const Tokens& tokens, std::size_t at, std::size_t last) {
    if (at >= last || !tokens[at].isWord()) return at;
    if (tokens[at].is("struct")) {
        while (at < last && !tokens[at].is("{"))
            ++at;
        return tokens.afterClosing(at, last);
    }
    ++at;
    if (!tokens.isAt(at, "<") || at >= last) return at;
    // Arguments of a template, such as Texture2D<float4>.
    while (at < last && !tokens[at].is(">"))
        ++at;
    return std::min(at + 1, last);
}

/// The index of the first of these marks that is in no brackets, or last.
template <typename Predicate>
std::size_t findOutside(const Tokens& tokens, TokenRange range, Predicate isWanted) {
    std::size_t at = range.first;
    while (at < range.last && !isWanted(tokens[at])) {
        const Token& token = tokens[at];
        const bool opens = token.is("(") || token.is("[") || token.is("{");
        at = opens ? tokens.afterClosing(at, range.last) : at + 1;
    }
    return at;
}

std::optional<Declarator> declaratorOf(const Tokens& tokens, TokenRange range) {
    if (range.empty() || !tokens[range.first].isWord()) return {};
    Declarator result;
    result.name = range.first;
    std::size_t at = range.first + 1;
    result.arrays.first = at;
    while (at < range.last && tokens[at].is("["))
        at = tokens.afterClosing(at, range.last);
    result.arrays.last = at;
    result.tail = {at, range.last};
    if (at < range.last && tokens[at].is(":")) {
        result.semantic.first = at;
        at = findOutside(tokens, {at, range.last}, [](const Token& token) {
            return token.is("=") || token.is("<") || token.is("{");
        });
        result.semantic.last = at;
    }
    if (at < range.last && tokens[at].is("<")) {
        result.annotation.first = at;
        while (at < range.last && !tokens[at].is(">"))
            ++at;
        at = std::min(at + 1, range.last);
        result.annotation.last = at;
    }
    if (at < range.last && tokens[at].is("=")) result.initial = {at + 1, range.last};
    return result;
}

/// Splits a source into what it declares.
class OutlineReader {
public:
    explicit OutlineReader(const Tokens& tokens) : mTokens(tokens) {}

    Outline read() {
        while (mAt < mTokens.size())
            readOne();
        return std::move(mOutline);
    }

private:
    void readOne() {
        const Token& token = mTokens[mAt];
        if (token.is(";")) {
            ++mAt;
        } else if (beginsBuffer(mAt) || (token.is("shared") && beginsBuffer(mAt + 1))) {
            readBuffer();
        } else if (token.is("technique") || token.is("technique10") || token.is("technique11")) {
            readEffect();
        } else if (mBuffer && token.is("}")) {
            mOutline.bufferMarks.push_back({mAt, mAt + (mTokens.isAt(mAt + 1, ";") ? 2 : 1)});
            mBuffer = false;
            ++mAt;
        } else {
            readStatement();
        }
    }

    bool beginsBuffer(std::size_t at) const {
        return mTokens.isAt(at, "cbuffer") || mTokens.isAt(at, "tbuffer");
    }

    void readBuffer() {
        const std::size_t begin = mAt;
        while (mAt < mTokens.size() && !mTokens[mAt].is("{"))
            ++mAt;
        mAt = std::min(mAt + 1, mTokens.size());
        mOutline.bufferMarks.push_back({begin, mAt});
        mBuffer = true;
    }

    void readEffect() {
        const std::size_t begin = mAt;
        while (mAt < mTokens.size() && !mTokens[mAt].is("{"))
            ++mAt;
        mAt = mTokens.afterClosing(mAt);
        mOutline.effects.push_back({begin, mAt});
    }

    /// Up to a semicolon, or to the end of a function's body.
    void readStatement() {
        const std::size_t begin = mAt;
        std::size_t parameters = 0; // the index of the opening parenthesis
        bool initial = false;
        while (mAt < mTokens.size() && !mTokens[mAt].is(";")) {
            const Token& token = mTokens[mAt];
            if (mBuffer && token.is("}")) return;
            if (token.is("=")) initial = true;
            const bool afterName = mAt > begin && mTokens[mAt - 1].isWord();
            if (token.is("(") && parameters == 0 && !initial && afterName && !inSemantic(begin))
                parameters = mAt;
            if (token.is("{") && parameters != 0 && !initial) {
                const std::size_t end = mTokens.afterClosing(mAt);
                addFunction(begin, parameters, {mAt, end});
                mAt = end;
                return;
            }
            const bool opens = token.is("(") || token.is("[") || token.is("{");
            mAt = opens                ? mTokens.afterClosing(mAt)
                  : beginsAnnotation() ? afterAnnotation()
                                       : mAt + 1;
        }
        if (parameters != 0 && !initial) {
            addFunction(begin, parameters, {});
        } else {
            addVariables({begin, mAt});
        }
        ++mAt;
    }

    /// < string name = "value"; > of an effect file.
    bool beginsAnnotation() const {
        return mTokens[mAt].is("<") && mAt + 2 < mTokens.size() && mTokens[mAt + 1].isWord() &&
               mTokens[mAt + 2].isWord();
    }

    std::size_t afterAnnotation() const {
        std::size_t at = mAt;
        while (at < mTokens.size() && !mTokens[at].is(">"))
            ++at;
        return std::min(at + 1, mTokens.size());
    }

    /// Whether a colon stands before the current token: register(s0) is no function.
    bool inSemantic(std::size_t begin) const {
        for (std::size_t at = begin; at < mAt; ++at)
            if (mTokens[at].is(":")) return true;
        return false;
    }

    void addFunction(std::size_t begin, std::size_t open, TokenRange body) {
        const std::size_t close = mTokens.afterClosing(open);
        FunctionOutline function;
        function.begin = begin;
        if (profileOf(mTokens[begin].text)) function.profile = mTokens[begin].text;
        function.name = open - 1;
        const std::size_t end = body.empty() ? close : body.first;
        const bool isSemantic =
            end == close + 2 && mTokens[close].is(":") && mTokens[close + 1].isWord();
        function.hasGoodHead = hasType(begin + (function.profile.empty() ? 0 : 1), function.name) &&
                               (end == close || isSemantic);
        function.parameters = {open + 1, std::max(open + 1, close - 1)};
        function.body = body;
        mOutline.functions.push_back(function);
    }

    bool hasType(std::size_t at, std::size_t name) const {
        while (at < name && mTokens[at].is("["))
            at = mTokens.afterClosing(at, name);
        while (at < name && Modifiers.count(mTokens[at].text) != 0)
            ++at;
        return at < name && afterType(mTokens, at, name) == name;
    }

    void addVariables(TokenRange range) {
        if (range.empty()) return;
        if (mTokens[range.first].is("typedef")) {
            if (mTokens[range.last - 1].isWord())
                mOutline.typeNames.insert(mTokens[range.last - 1].text);
            return;
        }
        for (std::size_t at = range.first; at + 1 < range.last; ++at) {
            if (!mTokens[at].is("struct")) continue;
            if (mTokens[at + 1].isWord()) mOutline.structNames.insert(mTokens[at + 1].text);
            break;
        }
        if (auto declaration = declarationOf(mTokens, range))
            mOutline.variables.push_back(std::move(*declaration));
        else
            mOutline.unknown.push_back(range);
    }

    const Tokens& mTokens;
    Outline mOutline;
    std::size_t mAt = 0;
    bool mBuffer = false;
};

} // namespace

std::vector<TokenRange> splitAtCommas(const Tokens& tokens, TokenRange range) {
    std::vector<TokenRange> parts;
    while (!range.empty()) {
        const std::size_t comma =
            findOutside(tokens, range, [](const Token& token) { return token.is(","); });
        parts.push_back({range.first, comma});
        range.first = comma + 1;
    }
    return parts;
}

std::optional<Declaration> declarationOf(const Tokens& tokens, TokenRange range) {
    Declaration result;
    result.all = range;
    std::size_t at = range.first;
    while (at < range.last && Modifiers.count(tokens[at].text) != 0)
        ++at;
    result.modifiers = {range.first, at};
    result.type.first = at;
    at = afterType(tokens, at, range.last);
    result.type.last = at;
    if (result.type.empty()) return {};
    for (const TokenRange part : splitAtCommas(tokens, {at, range.last})) {
        const auto declarator = declaratorOf(tokens, part);
        if (!declarator) return {};
        result.declarators.push_back(*declarator);
    }
    return result;
}

bool hasModifier(const Tokens& tokens, const Declaration& declaration, std::string_view modifier) {
    for (std::size_t at = declaration.modifiers.first; at < declaration.modifiers.last; ++at)
        if (tokens[at].is(modifier)) return true;
    return false;
}

Outline outlineOf(const Tokens& tokens) {
    return OutlineReader(tokens).read();
}

} // namespace Lixel::Cg
