#include "cg/translation/Prelude.h"

namespace Lixel::Cg {
namespace {

struct LibraryFunction {
    const char* name;
    /// May be several overloads. One line each, and nothing of C++.
    const char* text;
    /// Whether HLSL has it too, or reads what it is there for in another way.
    bool inHlsl = false;
};

// In Cg, the third coordinate of a projection by three is the divisor.
constexpr LibraryFunction Functions[] = {
    {"tex1D", "float4 tex1D(sampler1D s, float2 c) { return tex1D(s, c.x); }"},
    {"tex2D", "float4 tex2D(sampler2D s, float3 c) { return tex2D(s, c.xy); }"},
    {"tex1Dproj", "float4 tex1Dproj(sampler1D s, float2 c) { return tex1D(s, c.x / c.y); }"},
    {"tex2Dproj", "float4 tex2Dproj(sampler2D s, float3 c) { return tex2D(s, c.xy / c.z); }"},
    {"f1tex1D", "float f1tex1D(sampler1D s, float c) { return tex1D(s, c).x; }"},
    {"f2tex1D", "float2 f2tex1D(sampler1D s, float c) { return tex1D(s, c).xy; }"},
    {"f3tex1D", "float3 f3tex1D(sampler1D s, float c) { return tex1D(s, c).xyz; }"},
    {"f4tex1D", "float4 f4tex1D(sampler1D s, float c) { return tex1D(s, c); }"},
    {"h4tex1D", "float4 h4tex1D(sampler1D s, float c) { return tex1D(s, c); }"},
    {"f1tex2D", "float f1tex2D(sampler2D s, float2 c) { return tex2D(s, c).x; }"},
    {"f2tex2D", "float2 f2tex2D(sampler2D s, float2 c) { return tex2D(s, c).xy; }"},
    {"f3tex2D", "float3 f3tex2D(sampler2D s, float2 c) { return tex2D(s, c).xyz; }"},
    {"f4tex2D", "float4 f4tex2D(sampler2D s, float2 c) { return tex2D(s, c); }"},
    {"h1tex2D", "float h1tex2D(sampler2D s, float2 c) { return tex2D(s, c).x; }"},
    {"h2tex2D", "float2 h2tex2D(sampler2D s, float2 c) { return tex2D(s, c).xy; }"},
    {"h3tex2D", "float3 h3tex2D(sampler2D s, float2 c) { return tex2D(s, c).xyz; }"},
    {"h4tex2D", "float4 h4tex2D(sampler2D s, float2 c) { return tex2D(s, c); }"},
    {"x4tex2D", "float4 x4tex2D(sampler2D s, float2 c) { return tex2D(s, c); }"},
    {"f1tex2Dproj", "float f1tex2Dproj(sampler2D s, float4 c) { return tex2Dproj(s, c).x; }"},
    {"f3tex2Dproj", "float3 f3tex2Dproj(sampler2D s, float4 c) { return tex2Dproj(s, c).xyz; }"},
    {"f4tex2Dproj", "float4 f4tex2Dproj(sampler2D s, float4 c) { return tex2Dproj(s, c); }"},
    {"f3texCUBE", "float3 f3texCUBE(samplerCUBE s, float3 c) { return texCUBE(s, c).xyz; }"},
    {"f4texCUBE", "float4 f4texCUBE(samplerCUBE s, float3 c) { return texCUBE(s, c); }"},
    {"h4texCUBE", "float4 h4texCUBE(samplerCUBE s, float3 c) { return texCUBE(s, c); }"},
};

constexpr std::string_view ComparedTexture = "tex2D(s21;vf3;";

} // namespace

std::string preludeFor(const Request& request, const std::unordered_set<std::string_view>& words,
                       const std::unordered_set<std::string_view>& defined) {
    std::string prelude;
    for (const LibraryFunction& function : Functions) {
        if (request.language == Language::Hlsl && !function.inHlsl) continue;
        if (words.count(function.name) == 0 || defined.count(function.name) != 0) continue;
        prelude += function.text;
        prelude += '\n';
    }
    return prelude;
}

const char* whyRefused(std::string_view function) {
    if (function.starts_with(ComparedTexture))
        return "tex2D with three coordinates compares with a depth in Cg, which is not supported; "
               "give it two, and compare what it returns";
    return nullptr;
}

} // namespace Lixel::Cg
