#include "cg/translation/Initializers.h"

#include "cg/translation/Outline.h"
#include "cg/translation/Types.h"

namespace Lixel::Cg {
namespace {

/// A declaration whose initial value in braces begins at an index.
struct InitializedArray {
    NumberType type;
    std::size_t elements = 1; ///< 0 where they are not known
};

std::optional<InitializedArray> arrayBefore(const Tokens& tokens, std::size_t equals,
                                            const Constants& constants) {
    InitializedArray result;
    std::size_t at = equals; // one after the declarator
    if (at > 0 && tokens[at - 1].is("]")) {
        const std::size_t close = at - 1;
        std::size_t open = close;
        while (open > 0 && !tokens[open].is("["))
            --open;
        const auto size = valueOf(tokens, {open + 1, close}, constants);
        result.elements = size && size->size() == 1 && size->front() >= 1 && size->front() < 65536
                              ? static_cast<std::size_t>(size->front())
                              : 0;
        at = open;
    }
    if (at < 2 || !tokens[at - 1].isWord() || !tokens[at - 2].isWord()) return {};
    const auto type = numberTypeOf(tokens, {at - 2, at - 1});
    if (!type) return {};
    result.type = *type;
    return result;
}

void groupOne(const Tokens& tokens, std::size_t equals, const Constants& constants, Edits& edits) {
    const auto array = arrayBefore(tokens, equals, constants);
    if (!array) return;
    const std::size_t size = array->type.rows * array->type.columns;
    const bool isArray = equals > 0 && tokens[equals - 1].is("]");
    if (size <= 1 || (!isArray && !array->type.isMatrix)) return;
    const std::size_t open = equals + 1;
    const std::size_t close = tokens.afterClosing(open) - 1;
    const auto items = splitAtCommas(tokens, {open + 1, close});
    if (items.size() < size || items.size() % size != 0) return;
    if (array->elements != 0 && items.size() != array->elements * size) return;
    // Of an array of unknown size, each item may be a whole element.
    for (const TokenRange item : items) {
        if (tokens.isAt(item.first, "{")) return;
        if (array->elements != 0) continue;
        const auto value = valueOf(tokens, item, constants);
        if (!value || value->size() != 1) return;
    }
    for (std::size_t i = 0; i < items.size(); i += size) {
        edits.insertBefore(items[i].first, hlslNameOf(array->type) + '(');
        edits.insertBefore(items[i + size - 1].last, ")");
    }
}

} // namespace

void groupInitializers(const Tokens& tokens, const Constants& constants, Edits& edits) {
    for (std::size_t at = 2; at + 1 < tokens.size(); ++at)
        if (tokens[at].is("=") && tokens[at + 1].is("{")) groupOne(tokens, at, constants, edits);
}

} // namespace Lixel::Cg
