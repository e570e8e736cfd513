#include "cg/translation/Edits.h"

#include <algorithm>

namespace Lixel::Cg {
namespace {

/// The line structure of a text that is taken out.
std::string linesOf(std::string_view text) {
    std::string lines;
    std::size_t at = 0;
    while (true) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string_view::npos) return lines;
        lines += '\n';
        at = end + 1;
        // A directive within: it begins its line.
        if (at < text.size() && text[at] == '#') {
            const std::size_t endOfDirective = std::min(text.find('\n', at), text.size());
            lines += text.substr(at, endOfDirective - at);
            at = endOfDirective;
        }
    }
}

} // namespace

void Edits::replace(TokenRange range, std::string by) {
    if (range.empty()) return;
    const std::size_t begin = mTokens[range.first].begin;
    const std::size_t end = mTokens[range.last - 1].end();
    by += linesOf(mText.substr(begin, end - begin));
    mEdits.push_back({begin, end, std::move(by)});
}

void Edits::insertBefore(std::size_t token, std::string text) {
    const std::size_t at = token < mTokens.size() ? mTokens[token].begin : mText.size();
    mEdits.push_back({at, at, std::move(text)});
}

void Edits::insertAfter(std::size_t token, std::string text) {
    const std::size_t at = mTokens[token].end();
    mEdits.push_back({at, at, std::move(text)});
}

std::string Edits::apply() const {
    std::vector<const Edit*> edits;
    edits.reserve(mEdits.size());
    for (const Edit& edit : mEdits)
        edits.push_back(&edit);
    std::stable_sort(edits.begin(), edits.end(), [](const Edit* a, const Edit* b) {
        if (a->begin != b->begin) return a->begin < b->begin;
        // At the same place insertions come first, then what replaces most.
        const bool insertsA = a->end == a->begin;
        const bool insertsB = b->end == b->begin;
        return insertsA != insertsB ? insertsA : a->end > b->end;
    });
    std::string result;
    std::size_t at = 0;
    for (const Edit* edit : edits) {
        if (edit->begin < at) continue;
        result += mText.substr(at, edit->begin - at);
        result += edit->by;
        at = edit->end;
    }
    return result + std::string(mText.substr(at));
}

std::string lineDirective(const Tokens& tokens, Place place) {
    return "\n#line " + std::to_string(place.line) + " \"" + tokens.files[place.file] + "\"\n";
}

} // namespace Lixel::Cg
