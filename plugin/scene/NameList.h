#pragma once

#include <string>

namespace Lixel {

/// Names for a message: "a, b, c".
template <typename Names>
std::string joinNames(const Names& names) {
    std::string text;
    for (const auto& name : names) {
        if (!text.empty()) text += ", ";
        text += name;
    }
    return text;
}

} // namespace Lixel
