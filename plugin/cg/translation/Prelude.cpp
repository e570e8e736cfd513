#include "cg/translation/Prelude.h"

namespace Lixel::Cg {
namespace {

struct LibraryFunction {
    const char* name;
    /// Its overloads, after the prefix that preludeNameOf gives each, marked $. lookup1D and so on
    /// are texture lookups that both stages have.
    const char* text;
};

constexpr LibraryFunction Functions[] = {
    // With a coordinate more than the texture has, Cg's lookup compares that with a depth.
    {"tex1D", "float4 $tex1D(sampler1D s, float c) { return lookup1D(s, c); }"
              "float4 $tex1D(sampler1D s, float2 c) { return lookup1D(s, c.x); }"},
    {"tex2D", "float4 $tex2D(sampler2D s, float2 c) { return lookup2D(s, c); }"
              "float4 $tex2D(sampler2D s, float3 c) { return lookup2D(s, c.xy); }"
              "float4 $tex2D(sampler2D s, float4 c) { return lookup2D(s, c.xy); }"
              "float4 $tex2D(sampler2D s, float2 c, float2 x, float2 y)"
              "{ return tex2Dgrad(s, c, x, y); }"},
    {"tex3D", "float4 $tex3D(sampler3D s, float3 c) { return lookup3D(s, c); }"},
    {"texCUBE", "float4 $texCUBE(samplerCUBE s, float3 c) { return lookupCUBE(s, c); }"},
    // The last coordinate divides.
    {"tex1Dproj", "float4 $tex1Dproj(sampler1D s, float2 c) { return lookup1D(s, c.x / c.y); }"
                  "float4 $tex1Dproj(sampler1D s, float4 c) { return lookup1D(s, c.x / c.w); }"},
    {"tex2Dproj", "float4 $tex2Dproj(sampler2D s, float3 c) { return lookup2D(s, c.xy / c.z); }"
                  "float4 $tex2Dproj(sampler2D s, float4 c) { return lookup2D(s, c.xy / c.w); }"},
    {"f1tex1D", "float $f1tex1D(sampler1D s, float c) { return lookup1D(s, c).x; }"},
    {"f3tex1D", "float3 $f3tex1D(sampler1D s, float c) { return lookup1D(s, c).xyz; }"},
    {"f4tex1D", "float4 $f4tex1D(sampler1D s, float c) { return lookup1D(s, c); }"},
    {"h4tex1D", "float4 $h4tex1D(sampler1D s, float c) { return lookup1D(s, c); }"},
    {"f1tex2D", "float $f1tex2D(sampler2D s, float2 c) { return lookup2D(s, c).x; }"},
    {"f2tex2D", "float2 $f2tex2D(sampler2D s, float2 c) { return lookup2D(s, c).xy; }"},
    {"f3tex2D", "float3 $f3tex2D(sampler2D s, float2 c) { return lookup2D(s, c).xyz; }"},
    {"f4tex2D", "float4 $f4tex2D(sampler2D s, float2 c) { return lookup2D(s, c); }"},
    {"h1tex2D", "float $h1tex2D(sampler2D s, float2 c) { return lookup2D(s, c).x; }"},
    {"h3tex2D", "float3 $h3tex2D(sampler2D s, float2 c) { return lookup2D(s, c).xyz; }"},
    {"h4tex2D", "float4 $h4tex2D(sampler2D s, float2 c) { return lookup2D(s, c); }"},
    {"x4tex2D", "float4 $x4tex2D(sampler2D s, float2 c) { return lookup2D(s, c); }"},
    {"f1tex2Dproj",
     "float $f1tex2Dproj(sampler2D s, float4 c) { return lookup2D(s, c.xy / c.w).x; }"},
    {"f3tex2Dproj",
     "float3 $f3tex2Dproj(sampler2D s, float4 c) { return lookup2D(s, c.xy / c.w).xyz; }"},
    {"f4tex2Dproj",
     "float4 $f4tex2Dproj(sampler2D s, float4 c) { return lookup2D(s, c.xy / c.w); }"},
    {"f3texCUBE", "float3 $f3texCUBE(samplerCUBE s, float3 c) { return lookupCUBE(s, c).xyz; }"},
    {"f4texCUBE", "float4 $f4texCUBE(samplerCUBE s, float3 c) { return lookupCUBE(s, c); }"},
    {"h4texCUBE", "float4 $h4texCUBE(samplerCUBE s, float3 c) { return lookupCUBE(s, c); }"},
};

constexpr std::string_view Prefix = "lixel_cg_";

} // namespace

std::string preludeNameOf(std::string_view name) {
    if (name == PostIncrement) name = "increment";
    if (name == PostDecrement) name = "decrement";
    return std::string(Prefix) + std::string(name);
}

namespace {

/// A lookup in a vertex program, which has no derivatives, is of the largest image.
struct Lookup {
    std::string_view name;
    const char* inFragment;
    const char* inVertex;
};

constexpr Lookup Lookups[] = {
    {"lookup1D", "float4 $lookup1D(sampler1D s, float c) { return tex1D(s, c); }",
     "float4 $lookup1D(sampler1D s, float c) { return tex1Dlod(s, float4(c, 0, 0, 0)); }"},
    {"lookup2D", "float4 $lookup2D(sampler2D s, float2 c) { return tex2D(s, c); }",
     "float4 $lookup2D(sampler2D s, float2 c) { return tex2Dlod(s, float4(c, 0, 0)); }"},
    {"lookup3D", "float4 $lookup3D(sampler3D s, float3 c) { return tex3D(s, c); }",
     "float4 $lookup3D(sampler3D s, float3 c) { return tex3Dlod(s, float4(c, 0)); }"},
    {"lookupCUBE", "float4 $lookupCUBE(samplerCUBE s, float3 c) { return texCUBE(s, c); }",
     "float4 $lookupCUBE(samplerCUBE s, float3 c) { return texCUBElod(s, float4(c, 0)); }"},
};

/// Overloads for all types that can be counted with.
std::string countingFunctions(std::string_view sign) {
    const std::string name = preludeNameOf(sign);
    std::string text;
    for (const char* base : {"int", "uint", "float"}) {
        for (const char* size : {"", "2", "3", "4"}) {
            const std::string type = std::string(base) + size;
            text += type + ' ' + name + "(inout " + type + " x) { " + type + " y = x; x " +
                    (sign == PostIncrement ? '+' : '-') + "= 1; return y; }\n";
        }
    }
    return text;
}

/// With the prefix in the place of $, and before the lookups.
std::string prefixed(std::string_view text) {
    std::string result;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '$') {
            result += Prefix;
            continue;
        }
        const bool begins = text.substr(at).starts_with("lookup") && at > 0 && text[at - 1] == ' ';
        if (begins) result += Prefix;
        result += text[at];
    }
    return result + '\n';
}

} // namespace

bool isInPrelude(Language language, std::string_view name) {
    if (language != Language::Cg) return false;
    for (const LibraryFunction& function : Functions)
        if (name == function.name) return true;
    return false;
}

std::string preludeFor(Stage stage, const std::unordered_set<std::string_view>& names) {
    std::string functions;
    for (const LibraryFunction& function : Functions)
        if (names.count(function.name) != 0) functions += prefixed(function.text);
    std::string lookups;
    for (const Lookup& lookup : Lookups) {
        if (functions.find(lookup.name) == std::string::npos) continue;
        lookups += prefixed(stage == Stage::Fragment ? lookup.inFragment : lookup.inVertex);
    }
    for (const std::string_view sign : {PostIncrement, PostDecrement})
        if (names.count(sign) != 0) functions += countingFunctions(sign);
    return lookups + functions;
}

const char* whyRefused(std::string_view function) {
    constexpr const char* Reason =
        "a lookup with a coordinate more than the texture has compares with a depth in Cg, which "
        "is "
        "not supported; leave the coordinate out, and compare what it returns";
    if (!function.starts_with(Prefix)) return nullptr;
    function.remove_prefix(Prefix.size());
    const std::string_view name = function.substr(0, function.find('('));
    if (name == "tex2D" && function.ends_with(";vf3;")) return Reason;
    if (name == "tex1D" && function.ends_with(";vf2;")) return Reason;
    return nullptr;
}

} // namespace Lixel::Cg
