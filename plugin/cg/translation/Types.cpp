#include "cg/translation/Types.h"

#include <unordered_map>
#include <unordered_set>

namespace Lixel::Cg {
namespace {

bool isCount(char c) {
    return c >= '1' && c <= '4';
}
unsigned countOf(char c) {
    return static_cast<unsigned>(c - '0');
}

/// The base of a type's name, with what follows it.
std::optional<NumberType> baseOf(std::string_view name, std::string_view& rest) {
    struct Base {
        std::string_view name;
        Parameter::Base base;
        bool isBool = false;
    };
    constexpr Base Bases[] = {
        {"float", Parameter::Base::Float},      {"min16float", Parameter::Base::Float},
        {"min10float", Parameter::Base::Float}, {"int", Parameter::Base::Int},
        {"uint", Parameter::Base::Int},         {"dword", Parameter::Base::Int},
        {"bool", Parameter::Base::Int, true}};
    for (const Base& base : Bases) {
        if (!name.starts_with(base.name)) continue;
        rest = name.substr(base.name.size());
        NumberType type;
        type.base = base.base;
        type.isBool = base.isBool;
        return type;
    }
    return {};
}

} // namespace

std::optional<NumberType> numberTypeOf(const Tokens& tokens, TokenRange range) {
    if (range.empty()) return {};
    const std::string_view name = tokens[range.first].text;
    const bool isVector = name == "vector";
    if (isVector || name == "matrix") {
        NumberType type;
        type.columns = 4;
        type.rows = isVector ? 1 : 4;
        type.isMatrix = !isVector;
        if (range.last == range.first + 1) return type;
        // < base , count [, count] >
        if (range.last != range.first + (isVector ? 6 : 8)) return {};
        std::string_view rest;
        const std::string plain = plainTypeName(tokens[range.first + 2].text);
        const auto base = baseOf(plain, rest);
        const std::string_view first = tokens[range.first + 4].text;
        const std::string_view last = tokens[range.last - 2].text;
        if (!base || !rest.empty() || first.size() != 1 || !isCount(first[0]) || last.size() != 1 ||
            !isCount(last[0]))
            return {};
        type.base = base->base;
        type.isBool = base->isBool;
        type.rows = isVector ? 1 : countOf(first[0]);
        type.columns = countOf(last[0]);
        return type;
    }
    if (range.last != range.first + 1) return {};
    std::string_view rest;
    const std::string plain = plainTypeName(name);
    auto type = baseOf(plain, rest);
    if (!type) return {};
    if (rest.empty()) return type;
    if (rest.size() == 1 && isCount(rest[0])) {
        type->columns = countOf(rest[0]);
        return type;
    }
    if (rest.size() != 3 || !isCount(rest[0]) || rest[1] != 'x' || !isCount(rest[2])) return {};
    type->rows = countOf(rest[0]);
    type->columns = countOf(rest[2]);
    type->isMatrix = true;
    return type;
}

std::string hlslNameOf(const NumberType& type) {
    std::string name = type.base == Parameter::Base::Float ? "float" : "int";
    if (type.isMatrix) return name + std::to_string(type.rows) + 'x' + std::to_string(type.columns);
    return type.columns == 1 ? name : name + std::to_string(type.columns);
}

bool isSamplerType(std::string_view type) {
    static const std::unordered_set<std::string_view> types = {
        "sampler",       "sampler1D",    "sampler2D",     "sampler3D",
        "samplerCUBE",   "SamplerState", "sampler_state", "Texture1D",
        "Texture2D",     "Texture3D",    "TextureCube",   "SamplerComparisonState",
        "Texture2DArray"};
    return types.count(type) != 0;
}

const char* whyUnsupported(std::string_view type) {
    static const std::unordered_map<std::string_view, const char*> reasons = {
        {"samplerRECT", "OGRE has no rectangle textures"},
        {"samplerRECTSHADOW", "OGRE has no rectangle textures"},
        {"samplerRECTShadow", "OGRE has no rectangle textures"},
        {"sampler1DSHADOW", "use sampler1D, and compare what it returns"},
        {"sampler2DSHADOW", "use sampler2D, and compare what it returns"},
        {"sampler2DShadow", "use sampler2D, and compare what it returns"},
        {"samplerCUBESHADOW", "use samplerCUBE, and compare what it returns"},
        {"sampler1DARRAY", "texture arrays are not supported"},
        {"sampler2DARRAY", "texture arrays are not supported"},
        {"samplerCUBEARRAY", "texture arrays are not supported"},
        {"samplerBUF", "buffer textures are not supported"},
        {"samplerRBUF", "buffer textures are not supported"},
        {"isampler2D", "integer textures are not supported"},
        {"usampler2D", "integer textures are not supported"}};
    const auto reason = reasons.find(type);
    return reason == reasons.end() ? nullptr : reason->second;
}

std::string plainTypeName(std::string_view cgName) {
    if (cgName == "cint") return "int";
    for (const std::string_view base : {"fixed", "half", "cfloat"}) {
        if (!cgName.starts_with(base)) continue;
        const std::string_view size = cgName.substr(base.size());
        const bool isVector = size.size() == 1 && isCount(size[0]);
        const bool isMatrix =
            size.size() == 3 && isCount(size[0]) && size[1] == 'x' && isCount(size[2]);
        if (size.empty() || isVector || isMatrix) return "float" + std::string(size);
    }
    return std::string(cgName);
}

} // namespace Lixel::Cg
