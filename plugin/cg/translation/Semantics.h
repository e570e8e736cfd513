#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace Lixel::Cg {

/// What a value of a program's interface means.
struct Semantic {
    std::string base; ///< in capitals, of several names for one thing always the same
    unsigned index = 0;

    std::string name() const { return base + std::to_string(index); }
    bool is(std::string_view other) const { return base == other; }
};

/// Reads a semantic such as texcoord3. HPOS and SV_Position are POSITION, COL1 and SPECULAR are
/// COLOR with the index 1, SV_Target is COLOR, and so on.
Semantic semanticOf(std::string_view text);

/// The vertex attribute that OGRE binds for a semantic: vertex, normal, uv0 and so on. Nothing if
/// it has none.
std::optional<std::string> attributeOf(const Semantic& semantic);

} // namespace Lixel::Cg
