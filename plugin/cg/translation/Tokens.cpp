#include "cg/translation/Tokens.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace Lixel::Cg {
namespace {

bool beginsWord(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool continuesWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool isDigit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// The longest first.
constexpr std::array<std::string_view, 24> Marks = {
    "<<=", ">>=", "...", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "++",
    "--",  "+=",  "-=",  "*=", "/=", "%=", "&=", "|=", "^=", "::", "->", "##"};

class TokenReader {
public:
    TokenReader(std::string_view text, std::string file) : mText(text) {
        mTokens.files.push_back(std::move(file));
    }

    Tokens read() {
        while (mAt < mText.size())
            readOne();
        return std::move(mTokens);
    }

private:
    void readOne() {
        const char c = mText[mAt];
        if (c == '\n') {
            ++mPlace.line;
            ++mAt;
            mLineIsEmpty = true;
        } else if (std::isspace(static_cast<unsigned char>(c)) != 0 || c == '\\') {
            ++mAt;
        } else if (c == '#' && mLineIsEmpty) {
            readDirective();
        } else if (mText.substr(mAt, 2) == "//") {
            mAt = std::min(mText.find('\n', mAt), mText.size());
        } else if (mText.substr(mAt, 2) == "/*") {
            skipComment();
        } else {
            mLineIsEmpty = false;
            const std::size_t length = lengthOfToken(c);
            mTokens.list.push_back({mKind, mText.substr(mAt, length), mAt, mPlace});
            mAt += length;
        }
    }

    void skipComment() {
        const std::size_t end = mText.find("*/", mAt + 2);
        const std::size_t after = end == std::string_view::npos ? mText.size() : end + 2;
        mPlace.line += static_cast<unsigned>(
            std::count(mText.begin() + static_cast<std::ptrdiff_t>(mAt),
                       mText.begin() + static_cast<std::ptrdiff_t>(after), '\n'));
        mAt = after;
    }

    /// Takes note of #line, and skips all others.
    void readDirective() {
        const std::size_t end = std::min(mText.find('\n', mAt), mText.size());
        std::string_view line = mText.substr(mAt + 1, end - mAt - 1);
        mAt = end;
        const auto skipSpace = [&line] {
            while (!line.empty() && (line.front() == ' ' || line.front() == '\t'))
                line.remove_prefix(1);
        };
        skipSpace();
        if (!line.starts_with("line")) return;
        line.remove_prefix(4);
        skipSpace();
        unsigned number = 0;
        const auto [rest, error] = std::from_chars(line.data(), line.data() + line.size(), number);
        if (error != std::errc()) return;
        // The newline that ends the directive counts.
        mPlace.line = number - 1;
        line.remove_prefix(static_cast<std::size_t>(rest - line.data()));
        skipSpace();
        const std::size_t quote = line.rfind('"');
        if (line.empty() || line.front() != '"' || quote == 0) return;
        const std::string file(line.substr(1, quote - 1));
        const auto known = std::find(mTokens.files.begin(), mTokens.files.end(), file);
        mPlace.file = static_cast<std::size_t>(known - mTokens.files.begin());
        if (known == mTokens.files.end()) mTokens.files.push_back(file);
    }

    std::size_t lengthOfToken(char c) {
        const std::string_view rest = mText.substr(mAt);
        std::size_t length = 1;
        if (beginsWord(c)) {
            mKind = Token::Kind::Word;
            while (length < rest.size() && continuesWord(rest[length]))
                ++length;
        } else if (isDigit(c) || (c == '.' && rest.size() > 1 && isDigit(rest[1]))) {
            mKind = Token::Kind::Number;
            while (length < rest.size() && continuesNumber(rest, length))
                ++length;
        } else if (c == '"') {
            mKind = Token::Kind::Text;
            while (length < rest.size() && rest[length] != '"' && rest[length] != '\n')
                ++length;
            if (length < rest.size() && rest[length] == '"') ++length;
        } else {
            mKind = Token::Kind::Mark;
            for (const std::string_view mark : Marks) {
                if (rest.starts_with(mark)) {
                    length = mark.size();
                    break;
                }
            }
        }
        return length;
    }

    static bool continuesNumber(std::string_view rest, std::size_t at) {
        const char c = rest[at];
        if (continuesWord(c) || c == '.') return true;
        const char before = rest[at - 1];
        return (c == '+' || c == '-') && (before == 'e' || before == 'E') &&
               !rest.starts_with("0x") && !rest.starts_with("0X");
    }

    std::string_view mText;
    Tokens mTokens;
    std::size_t mAt = 0;
    Place mPlace;
    Token::Kind mKind = Token::Kind::Mark;
    bool mLineIsEmpty = true;
};

} // namespace

std::size_t Tokens::afterClosing(std::size_t open, std::size_t last) const {
    std::size_t depth = 0;
    for (std::size_t at = open; at < last; ++at) {
        const Token& token = list[at];
        if (token.is("(") || token.is("[") || token.is("{")) ++depth;
        if ((token.is(")") || token.is("]") || token.is("}")) && --depth == 0) return at + 1;
    }
    return last;
}

Tokens tokensOf(std::string_view text, std::string file) {
    return TokenReader(text, std::move(file)).read();
}

} // namespace Lixel::Cg
