// Sources that are wrong in ways that nobody thought of: each is translated or refused, in bounded
// time, and what is translated is GLSL.

#include "../stress/Random.h"
#include "Translated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace Lixel::Tests {
namespace {

const std::vector<std::string> Seeds = {
    R"(#include "a.cgh"
// a comment
static const float two = 2; float2 offsets[2] = { 1, 2, 3, 4 };
uniform float4 tint = float4(1, .5x, 2f, two);
struct Out { float4 p : POSITION; float2 uv[2] : TEXCOORD0; fixed4 c : COLOR; };
Out main(in varying float4 p : POSITION, float3 n : NORMAL, uniform float4x4 world,
         uniform float3x4 bones[3],
         uniform bool on, int4 b : BLENDINDICES) {
    Out o; o.p = mul(world, float4(mul(bones[b.x], p), 1));
    for (int i = 0; i < 2; i++) { o.uv[i] = on ? offsets[i] : helper(n).xy; }
    o.c = tint * (n.x > 0 ? 1 : 0.5); return o; })",
    R"(#define LOOK(s, c) tex2D(s, c)
uniform sampler2D a : register(s1); sampler b : TEXUNIT0;
float4 light(float3 n, uniform float k) { if (n.z < 0) discard; return pow(abs(n.x), k); }
void main(float4 uv : TEXCOORD0, float4 w : WPOS, uniform sampler2D sample, uniform float line = 3,
          out float4 c : COLOR, out float d : DEPTH) {
    float4 point = LOOK(a, uv.xy) + tex2Dproj(sample, uv) * line;
    c = lerp(point, LOOK(b, w.xy), saturate(light(uv.xyz, 2h))); d = fmod(w.z, 1); })",
    R"(cbuffer N : register(b0) { float4 t : packoffset(c0); row_major float4x4 m; };
Texture2D image : register(t0); SamplerState state { Filter = Linear; };
struct In { float4 p : SV_Position; float2 uv : TEXCOORD0; float f : FOG; };
float scale < string UIName = "x"; float UIMin = 0; > = 2;
float4 main(In i) : SV_Target { switch ((int)i.f) { case 1: return t; default: break; }
    float2x2 r = { 1, 0, 0, 1 }; uint k = 3; do { k--; } while (k > 1);
    return image.Sample(state, mul(r, i.uv)) * scale + mul(m, t) * k; }
technique T { pass P { PixelShader = compile ps_2_0 main(); } })"};

const std::vector<std::string> Pieces = {"{",
                                         "}",
                                         "(",
                                         ")",
                                         "[",
                                         "]",
                                         ";",
                                         ",",
                                         ":",
                                         "::",
                                         "=",
                                         "<",
                                         ">",
                                         "\"",
                                         "'",
                                         "/*",
                                         "*/",
                                         "//",
                                         "#",
                                         "##",
                                         "\n#define A A\n",
                                         "\n#if\n",
                                         "\n#endif\n",
                                         "\n#line 7 \"x\"\n",
                                         "\n#include \"a.cgh\"\n",
                                         "\\\n",
                                         "0",
                                         "1e999",
                                         "2f",
                                         ".25x",
                                         "0x",
                                         "-",
                                         "!",
                                         "uniform ",
                                         "varying ",
                                         "static ",
                                         "const ",
                                         "struct ",
                                         "float4 ",
                                         "float3x3 ",
                                         "fixed2 ",
                                         "int ",
                                         "bool ",
                                         "sampler2D ",
                                         "sampler ",
                                         "texture ",
                                         "Texture2D ",
                                         "void ",
                                         "return ",
                                         "if (1) ",
                                         "else ",
                                         "for (;;) ",
                                         "main",
                                         "helper",
                                         "tint",
                                         "p",
                                         ": POSITION ",
                                         ": TEXCOORD9 ",
                                         ": register(s99) ",
                                         "TEXUNIT7",
                                         "typedef ",
                                         "cbuffer ",
                                         "technique ",
                                         "samplerRECT ",
                                         "glstate",
                                         "tex2D(a, 1)",
                                         "arbfp1 ",
                                         "[99999999]",
                                         "[-1]",
                                         ".xyzw",
                                         std::string(1, '\0'),
                                         "\xff\xfe",
                                         "lixel_main",
                                         "gl_Position",
                                         "main_",
                                         "out ",
                                         "inout "};

class Mutator {
public:
    explicit Mutator(Random& random) : mRandom(random) {}

    std::string mutate(std::string source) {
        for (std::size_t i = mRandom.below(3) + 1; i > 0; --i)
            mutateOnce(source);
        return source;
    }

private:
    void mutateOnce(std::string& source) {
        const std::size_t at = mRandom.below(source.size() + 1);
        const std::size_t length = std::min<std::size_t>(mRandom.below(12), source.size() - at);
        switch (mRandom.below(5)) {
        case 0:
            source.erase(at, length);
            break;
        case 1:
            source.insert(at, Pieces[mRandom.below(Pieces.size())]);
            break;
        case 2:
            source.replace(at, length, Pieces[mRandom.below(Pieces.size())]);
            break;
        case 3:
            source.insert(mRandom.below(source.size() + 1), source.substr(at, length));
            break;
        default: {
            // A piece of another source.
            const std::string& other = Seeds[mRandom.below(Seeds.size())];
            source.insert(at, other.substr(mRandom.below(other.size()), mRandom.below(30)));
        }
        }
    }

    Random& mRandom;
};

/// How many sources there are; more by hand.
unsigned long mutations() {
    const char* wanted = std::getenv("LIXEL_CG_MUTATIONS");
    return wanted == nullptr ? 300 : std::strtoul(wanted, nullptr, 10);
}

TEST(Mutations, AreTranslatedOrRefused) {
    constexpr auto Longest = std::chrono::seconds(2);
    Random random(20060502);
    Mutator mutator(random);
    unsigned long translated = 0;
    unsigned long refused = 0;
    for (unsigned long i = 0; i < mutations(); ++i) {
        Source source;
        const std::size_t seed = random.below(Seeds.size());
        source.stage = seed == 0 ? Cg::Stage::Vertex : Cg::Stage::Fragment;
        source.language = seed == 2 ? Cg::Language::Hlsl : Cg::Language::Cg;
        source.glslVersion = random.oneIn(3) ? 120 : 330;
        source.text = mutator.mutate(Seeds[seed]);
        source.includes["a.cgh"] = "float4 helper(float3 n) { return n.xyzz * 2; }";
        if (random.oneIn(4)) source.includes["a.cgh"] = mutator.mutate(source.includes["a.cgh"]);

        const auto begin = std::chrono::steady_clock::now();
        const Cg::Translation translation = translate(requestOf(source));
        EXPECT_LT(std::chrono::steady_clock::now() - begin, Longest) << source.text;
        const Cg::Message* error = firstError(translation.messages);
        EXPECT_EQ(translation.succeeded(), error == nullptr) << source.text;
        if (!translation.succeeded()) continue;
        ++translated;
        if (!problemOf(translation.glsl, source.stage).empty()) ++refused;
    }
    // Neither all nor none: else nothing was tried.
    EXPECT_GT(translated, mutations() / 50);
    EXPECT_LT(translated, mutations() * 9 / 10);
    // A few are wrong in ways that only GLSL's compiler sees, such as endless loops. OGRE logs what
    // it says, and takes another technique.
    EXPECT_LE(refused * 1000, mutations());
    RecordProperty("refused", std::to_string(refused));
    RecordProperty("translated", std::to_string(translated));
}

/// The sources that are mutated are right by themselves.
TEST(Mutations, OfGoodSources) {
    for (std::size_t seed = 0; seed < Seeds.size(); ++seed) {
        Source source = {seed == 0 ? Cg::Stage::Vertex : Cg::Stage::Fragment, Seeds[seed]};
        if (seed == 2) source.language = Cg::Language::Hlsl;
        source.includes["a.cgh"] = "float4 helper(float3 n) { return n.xyzz * 2; }";
        EXPECT_EQ(errorOf(source), "");
    }
}

} // namespace
} // namespace Lixel::Tests
