#include "cg/translation/Semantics.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <unordered_map>

namespace Lixel::Cg {

Semantic semanticOf(std::string_view text) {
    struct Alias {
        std::string base;
        unsigned index = 0;
    };
    static const std::unordered_map<std::string, Alias> aliases = {
        {"HPOS", {"POSITION"}},
        {"SV_POSITION", {"POSITION"}},
        {"COL", {"COLOR"}},
        {"DIFFUSE", {"COLOR"}},
        {"SPECULAR", {"COLOR", 1}},
        {"SV_TARGET", {"COLOR"}},
        {"TEX", {"TEXCOORD"}},
        {"FOGC", {"FOG"}},
        {"FOGCOORD", {"FOG"}},
        {"PSIZ", {"PSIZE"}},
        {"SV_DEPTH", {"DEPTH"}},
        {"DEPR", {"DEPTH"}},
        {"WPOS", {"WPOS"}},
        {"FACE", {"VFACE"}},
        {"BLENDWEIGHTS", {"BLENDWEIGHT"}},
        {"BINORM", {"BINORMAL"}},
    };
    Semantic semantic;
    const auto digits = std::find_if(text.rbegin(), text.rend(), [](char c) {
        return std::isdigit(static_cast<unsigned char>(c)) == 0;
    });
    const std::string_view base = text.substr(0, static_cast<std::size_t>(text.rend() - digits));
    const std::string_view number = text.substr(base.size());
    std::from_chars(number.data(), number.data() + number.size(), semantic.index);
    semantic.base = base;
    std::transform(semantic.base.begin(), semantic.base.end(), semantic.base.begin(), [](char c) {
        return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    });
    if (const auto alias = aliases.find(semantic.base); alias != aliases.end()) {
        semantic.base = alias->second.base;
        semantic.index += alias->second.index;
    }
    return semantic;
}

std::optional<std::string> attributeOf(const Semantic& semantic) {
    // Cg's ATTR0 to ATTR15 are the attributes of ARB_vertex_program.
    static constexpr const char* Numbered[] = {
        "vertex", "blendWeights", "normal",       "colour", "secondary_colour",
        nullptr,  nullptr,        "blendIndices", "uv0",    "uv1",
        "uv2",    "uv3",          "uv4",          "uv5",    "uv6",
        "uv7"};
    static const std::unordered_map<std::string, std::string> names = {
        {"POSITION", "vertex"}, {"BLENDWEIGHT", "blendWeights"}, {"BLENDINDICES", "blendIndices"},
        {"NORMAL", "normal"},   {"TANGENT", "tangent"},          {"BINORMAL", "binormal"}};
    if (semantic.is("TEXCOORD") && semantic.index < 8) return "uv" + std::to_string(semantic.index);
    if (semantic.is("COLOR") && semantic.index < 2)
        return semantic.index == 0 ? "colour" : "secondary_colour";
    if (semantic.is("ATTR") && semantic.index < std::size(Numbered) &&
        Numbered[semantic.index] != nullptr)
        return Numbered[semantic.index];
    const auto name = names.find(semantic.base);
    if (name == names.end() || semantic.index != 0) return {};
    return name->second;
}

} // namespace Lixel::Cg
