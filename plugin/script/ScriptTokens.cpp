#include "script/ScriptTokens.h"

#include <algorithm>

namespace Lixel {
namespace {

using Type = ScriptToken::Type;

bool isNewline(char c) {
    return c == '\n' || c == '\r';
}

bool isSpace(char c) {
    return c == ' ' || c == '\t';
}

/// Ends a word or a variable, and is a token of its own.
bool isMark(char c) {
    return c == '{' || c == '}' || c == ':';
}

class Lexer {
public:
    explicit Lexer(std::string_view script) : mScript(script) {}

    ScriptTokens run() {
        while (mNext < mScript.size())
            readOne();
        return std::move(mResult);
    }

private:
    void readOne() {
        const char c = mScript[mNext];
        if (isNewline(c)) return readNewline();
        if (isSpace(c)) {
            ++mNext;
            return;
        }
        if (mScript.substr(mNext, 2) == "//") return skipTo(mScript.find_first_of("\r\n", mNext));
        if (mScript.substr(mNext, 2) == "/*") return skipComment();
        if (c == '"') return readQuote();
        readWord();
    }

    void add(Type type, std::string text = {}) {
        mResult.tokens.push_back({type, std::move(text), mLine});
    }

    void readNewline() {
        // Several are one, as are the two characters of Windows.
        if (mResult.tokens.empty() || mResult.tokens.back().type != Type::Newline)
            add(Type::Newline);
        count(mScript[mNext]);
        ++mNext;
    }

    /// Counts lines.
    void count(char c) {
        const bool follows = mNext > 0 && mScript[mNext - 1] == '\r';
        if (c == '\r' || (c == '\n' && !follows)) ++mLine;
    }

    /// Goes on at a place, or at the end, counting the lines up to there.
    void skipTo(std::size_t place) {
        const std::size_t end = std::min(place, mScript.size());
        for (; mNext < end; ++mNext)
            count(mScript[mNext]);
    }

    void skipComment() {
        // OGRE takes "/*/" for a whole comment.
        const std::size_t end = mScript.find("*/", mNext + 1);
        if (end == std::string_view::npos) mResult.openComment = mLine;
        skipTo(end == std::string_view::npos ? end : end + 2);
    }

    /// A backslash stands before a quotation mark that is part of the text. OGRE takes several
    /// backslashes for one.
    void readQuote() {
        const unsigned begin = mLine;
        std::string text;
        char last = '"';
        for (++mNext; mNext < mScript.size(); ++mNext) {
            const char c = mScript[mNext];
            count(c);
            if (c == '"' && last != '\\') {
                ++mNext;
                return add(Type::Quote, std::move(text));
            }
            if (c != '\\') {
                if (last == '\\' && c != '"') text += '\\';
                text += c;
            }
            last = c;
        }
        mResult.openQuote = begin;
    }

    /// Words, variables and marks. A mark that begins a word ends where the word does, so that "{"
    /// needs a space after it.
    void readWord() {
        const std::size_t begin = mNext;
        ++mNext;
        while (mNext < mScript.size() && !isNewline(mScript[mNext]) && !isSpace(mScript[mNext]) &&
               !isMark(mScript[mNext]))
            ++mNext;
        const std::string_view word = mScript.substr(begin, mNext - begin);
        add(typeOf(word), std::string(word));
        if (mNext == mScript.size() || !isMark(mScript[mNext])) return;
        const std::string_view mark = mScript.substr(mNext, 1);
        add(typeOf(mark), std::string(mark));
        ++mNext;
    }

    static Type typeOf(std::string_view word) {
        if (word == "{") return Type::LeftBrace;
        if (word == "}") return Type::RightBrace;
        if (word == ":") return Type::Colon;
        return word.front() == '$' ? Type::Variable : Type::Word;
    }

    std::string_view mScript;
    std::size_t mNext = 0;
    unsigned mLine = 1;
    ScriptTokens mResult;
};

} // namespace

ScriptTokens tokensOf(std::string_view script) {
    return Lexer(script).run();
}

} // namespace Lixel
