#include "script/ScriptOutline.h"

#include <utility>

namespace Lixel {
namespace {

using Type = ScriptToken::Type;

/// Blocks within blocks. OGRE's compiler recurses into them; a material needs four.
constexpr std::size_t GreatestDepth = 32;

bool isName(const ScriptToken& token) {
    return token.type == Type::Word || token.type == Type::Quote;
}

class OutlineReader {
public:
    OutlineReader(const std::vector<ScriptToken>& tokens, const std::string& file,
                  ScriptOutline& outline, ScriptVariables& variables)
        : mTokens(tokens),
          mFile(file),
          mTakesSetupsAlone(file.ends_with(".shadow")),
          mOutline(outline),
          mVariables(variables) {}

    std::optional<ScriptFault> run() {
        while (skipNewlines(), mNext < mTokens.size())
            if (!readStatement()) return mFault;
        if (mDepth != 0) fail(mTokens.back(), "a block that begins with '{' has no '}'");
        return mFault;
    }

private:
    const ScriptToken* peek(std::size_t ahead = 0) const {
        return mNext + ahead < mTokens.size() ? &mTokens[mNext + ahead] : nullptr;
    }

    void skipNewlines() {
        while (mNext < mTokens.size() && mTokens[mNext].type == Type::Newline)
            ++mNext;
    }

    bool fail(const ScriptToken& token, const std::string& what) {
        mFault = {mFile, token.line, what};
        return false;
    }

    bool readStatement() {
        const ScriptToken& first = *peek();
        if (first.type == Type::RightBrace) {
            if (mDepth == 0) return fail(first, "'}' without a '{'");
            --mDepth;
            ++mNext;
            return true;
        }
        if (first.type != Type::Word) return fail(first, "a line has to begin with a word");
        if (first.text == "import") return readImport(first);
        if (first.text == "set") return readVariable(first);
        return readObjectOrProperty(first);
    }

    bool readImport(const ScriptToken& first) {
        const ScriptToken *target = peek(1), *from = peek(2), *file = peek(3), *end = peek(4);
        if (mDepth != 0) return fail(first, "import belongs outside of all blocks");
        if (target == nullptr || !isName(*target) || from == nullptr || from->text != "from" ||
            file == nullptr || !isName(*file) || (end != nullptr && end->type != Type::Newline))
            return fail(first, "expected: import NAME from \"FILE\", or import * from \"FILE\"");
        mOutline.imports.push_back({target->text, file->text, first.line});
        mNext += 4;
        return true;
    }

    bool readVariable(const ScriptToken& first) {
        const ScriptToken *variable = peek(1), *value = peek(2), *end = peek(3);
        if (variable == nullptr || variable->type != Type::Variable || value == nullptr ||
            !isName(*value) ||
            (end != nullptr && end->type != Type::Newline && end->type != Type::RightBrace))
            return fail(first,
                        "expected: set $NAME VALUE, where VALUE is one word, or several words or "
                        "variables in quotes");
        mNext += 3;
        return readValue(first, variable->text, value->text);
    }

    bool readValue(const ScriptToken& first, const std::string& variable, const std::string& text) {
        VariableValue value{.file = mFile, .line = first.line, .uses = {}};
        const ScriptTokens parts = tokensOf(text);
        for (const ScriptToken& part : parts.tokens) {
            if (!isName(part) && part.type != Type::Variable)
                return fail(first,
                            "the value of " + variable + " may contain only words and variables");
            if (part.type == Type::Variable)
                ++value.uses[part.text];
            else
                ++value.words;
        }
        if (parts.openQuote != 0)
            return fail(first,
                        "the value of " + variable + " has one quotation mark without another");
        mVariables[variable].push_back(std::move(value));
        return true;
    }

    /// Words up to the end of the line, or a header and its block.
    bool readObjectOrProperty(const ScriptToken& first) {
        std::size_t colon = 0, length = 0;
        for (const ScriptToken* token = peek(); token != nullptr; token = peek(++length)) {
            if (token->type == Type::Newline || token->type == Type::LeftBrace ||
                token->type == Type::RightBrace)
                break;
            if (token->type == Type::Word && isMarkAndMore(token->text))
                return fail(*token, std::string(1, token->text[0]) + " needs a space after it");
            if (token->type == Type::Colon && colon != 0) return fail(*token, "a second ':'");
            if (token->type == Type::Colon) colon = length;
        }
        const std::size_t block = startOfBlock(length);
        if (block != 0) return readHeader(first, colon, length, block);
        if (colon != 0) return fail(first, "a line with ':' has to be followed by '{'");
        if (mDepth == 0)
            return fail(first, mTakesSetupsAlone
                                   ? "expected: shadow_camera_setup NAME, or shadow_camera_setup "
                                     "NAME : PARENT, and then its block between '{' and '}'"
                                   : "expected: an object such as material NAME, and then its "
                                     "block between '{' and '}'");
        if (mTakesSetupsAlone) ++mOutline.objects.back().lines;
        mNext += length;
        return true;
    }

    static bool isMarkAndMore(const std::string& word) {
        return word.size() > 1 && (word[0] == '{' || word[0] == '}' || word[0] == ':');
    }

    /// How far ahead the block of a header of that length begins, maybe in a line after it; 0 where
    /// no block follows.
    std::size_t startOfBlock(std::size_t length) const {
        std::size_t ahead = length;
        while (peek(ahead) != nullptr && peek(ahead)->type == Type::Newline)
            ++ahead;
        return peek(ahead) != nullptr && peek(ahead)->type == Type::LeftBrace ? ahead : 0;
    }

    bool readHeader(const ScriptToken& first, std::size_t colon, std::size_t length,
                    std::size_t block) {
        const std::size_t type = first.text == "abstract" ? 1 : 0;
        const std::size_t endOfNames = colon != 0 ? colon : length;
        if (mTakesSetupsAlone && mDepth > 0)
            return fail(
                first, "a shadow_camera_setup has no blocks within; is a '}' missing before this?");
        if (mTakesSetupsAlone && (type >= length || peek(type)->text != "shadow_camera_setup"))
            return fail(first, "'" + first.text +
                                   "' does not belong here: a .shadow file has shadow_camera_setup "
                                   "alone, and what they import");
        if (mTakesSetupsAlone &&
            (endOfNames != type + 2 || !isName(*peek(type + 1)) || peek(type + 1)->text.empty()))
            return fail(first, "a shadow_camera_setup needs one name");
        if (colon != 0 && (colon + 1 >= length || !areNames(colon + 1, length)))
            return fail(first, "expected the name of a parent after ':'");
        if (++mDepth > GreatestDepth) return fail(first, "too many blocks within blocks");
        if (mDepth == 1 && type + 1 < endOfNames) {
            mOutline.objects.push_back({peek(type + 1)->text, first.line, {}});
            for (std::size_t i = colon + 1; mTakesSetupsAlone && colon != 0 && i < length; ++i)
                mOutline.objects.back().parents.push_back(peek(i)->text);
        }
        mNext += block + 1;
        return true;
    }

    bool areNames(std::size_t begin, std::size_t end) const {
        for (std::size_t i = begin; i < end; ++i)
            if (!isName(*peek(i))) return false;
        return true;
    }

    const std::vector<ScriptToken>& mTokens;
    std::size_t mNext = 0;
    std::size_t mDepth = 0;
    const std::string& mFile;
    bool mTakesSetupsAlone;
    ScriptOutline& mOutline;
    ScriptVariables& mVariables;
    std::optional<ScriptFault> mFault;
};

} // namespace

std::optional<ScriptFault> readOutline(const std::vector<ScriptToken>& tokens,
                                       const std::string& file, ScriptOutline& outline,
                                       ScriptVariables& variables) {
    return OutlineReader(tokens, file, outline, variables).run();
}

} // namespace Lixel
