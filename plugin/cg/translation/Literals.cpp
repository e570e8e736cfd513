#include "cg/translation/Literals.h"

#include <algorithm>
#include <cctype>

namespace Lixel::Cg {
namespace {

bool isLetterOfLiteral(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The end of a number or word that begins there.
std::size_t endOfRun(std::string_view text, std::size_t at, bool number) {
    std::size_t end = at;
    while (end < text.size()) {
        const char c = text[end];
        const bool signOfExponent = number && end > at && (c == '+' || c == '-') &&
                                    (text[end - 1] == 'e' || text[end - 1] == 'E');
        if (!isLetterOfLiteral(c) && !(number && c == '.') && !signOfExponent) break;
        ++end;
    }
    return end;
}

/// The literal with the suffix f, or as it is where it has none of Cg's suffixes.
std::string plainLiteral(std::string_view literal) {
    const auto suffix = std::find_if(literal.begin(), literal.end(), [](char c) {
        return std::isdigit(static_cast<unsigned char>(c)) == 0 && c != '.' && c != 'e' &&
               c != 'E' && c != '+' && c != '-';
    });
    if (suffix == literal.end() || suffix + 1 != literal.end()) return std::string(literal);
    const int letter = std::tolower(static_cast<unsigned char>(*suffix));
    if (letter != 'f' && letter != 'h' && letter != 'x') return std::string(literal);
    std::string plain(literal.begin(), suffix);
    if (plain.find_first_of(".eE") == std::string::npos) plain += ".0";
    return plain + 'f';
}

} // namespace

std::string withPlainLiterals(std::string_view source) {
    std::string result;
    result.reserve(source.size() + 16);
    const auto copyTo = [&](std::size_t at, std::size_t end) {
        end = std::min(end, source.size());
        result += source.substr(at, end - at);
        return end;
    };
    std::size_t at = 0;
    while (at < source.size()) {
        const char c = source[at];
        const char next = at + 1 < source.size() ? source[at + 1] : '\0';
        const bool digitNext = std::isdigit(static_cast<unsigned char>(next)) != 0;
        if (c == '/' && next == '/') {
            at = copyTo(at, source.find('\n', at));
        } else if (c == '/' && next == '*') {
            const std::size_t end = source.find("*/", at + 2);
            at = copyTo(at, end == std::string_view::npos ? end : end + 2);
        } else if (c == '"') {
            const std::size_t end = source.find_first_of("\"\n", at + 1);
            at = copyTo(at, end == std::string_view::npos ? end : end + 1);
        } else if (std::isdigit(static_cast<unsigned char>(c)) != 0 || (c == '.' && digitNext)) {
            const std::size_t end = endOfRun(source, at, true);
            result += plainLiteral(source.substr(at, end - at));
            at = end;
        } else if (isLetterOfLiteral(c)) {
            at = copyTo(at, endOfRun(source, at, false));
        } else if (c == '\r') {
            ++at;
        } else {
            at = copyTo(at, at + 1);
        }
    }
    // Without it a directive at the end would not be read.
    if (!result.ends_with('\n')) result += '\n';
    return result;
}

} // namespace Lixel::Cg
