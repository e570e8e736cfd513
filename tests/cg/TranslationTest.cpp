// What Cg and HLSL sources are translated to. The first tests are what HLSL's front end makes of Cg
// by itself and should not: each works, or is refused with its line.

#include "Translated.h"

#include <gtest/gtest.h>

#include <thread>

namespace Lixel::Tests {
namespace {

using Cg::Stage;
using Cg::Translation;

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(CgOnly, Fixed) {
    translated({Stage::Fragment, R"(
fixed4 main(fixed2 uv : TEXCOORD0, uniform fixed3x3 m) : COLOR {
    fixed a = uv.x; half2 b = uv; return fixed4(mul(m, fixed3(a, b)), 1);
})"});
}

TEST(CgOnly, Varying) {
    translated({Stage::Fragment, R"(
struct Input { varying float2 uv : TEXCOORD0; };
float4 main(in varying float4 c : COLOR, varying float2 uv : TEXCOORD1, Input i) : COLOR {
    return c + uv.xyxy + i.uv.xyxy;
})"});
}

TEST(CgOnly, NamesThatHlslReserves) {
    const Translation t = translated({Stage::Fragment, R"(
float4 point;
float4 main(float2 uv : TEXCOORD0, uniform float4 sample, uniform sampler2D texture,
            uniform float line, uniform float linear[2]) : COLOR {
    float4 triangle = sample * point;
    return triangle * line + tex2D(texture, uv) * linear[1];
})"});
    for (const char* name : {"point", "sample", "line", "linear"})
        EXPECT_TRUE(parameterOf(t, name).used) << name;
    ASSERT_EQ(t.samplers.size(), 1u);
    EXPECT_EQ(t.samplers[0].name, "texture");
}

TEST(CgOnly, TextureUnits) {
    const Translation t = translated({Stage::Fragment, R"(
uniform sampler2D a : TEXUNIT3;
float4 main(float2 uv : TEXCOORD0, sampler2D b : TEXUNIT1, uniform sampler2D c : register(s2),
            uniform sampler2D d) : COLOR {
    return tex2D(a, uv) + tex2D(b, uv) + tex2D(c, uv) + tex2D(d, uv);
})"});
    std::map<std::string, unsigned> units;
    for (const auto& sampler : t.samplers)
        units[sampler.name] = sampler.unit;
    EXPECT_EQ(units, (std::map<std::string, unsigned>{{"a", 3}, {"b", 1}, {"c", 2}, {"d", 0}}));
}

TEST(CgOnly, Literals) {
    const Translation t = translated({Stage::Fragment, R"(
#define HALF .5h /* 2f */
float4 main() : COLOR { return float4(2f, .25x, HALF, 1e1f) + 0x10 + 3; } // 2f)"});
    EXPECT_TRUE(holds(t.glsl, "vec4(21.0, 19.25, 19.5, 29.0)") || holds(t.glsl, "0.25")) << t.glsl;
}

TEST(CgOnly, ProjectionByThree) {
    const Translation t = translated({Stage::Fragment, R"(
float4 main(float3 p : TEXCOORD0, float4 q : TEXCOORD1, uniform sampler2D s) : COLOR {
    return tex2Dproj(s, p) + tex2Dproj(s, q);
})"});
    EXPECT_TRUE(holds(t.glsl, "c.xy / vec2(c.z)")) << t.glsl;
    EXPECT_TRUE(holds(t.glsl, "c.xy / vec2(c.w)")) << t.glsl;
}

TEST(CgOnly, DefaultValues) {
    const Translation t = translated({Stage::Fragment, R"(
static const float two = 2;
uniform float4 tint = float4(1, 0.5, two * 2, -.25x);
float weights[3] = { 0.25, 0.5, 0.25 };
float2 offsets[] = { { 1, 2 }, { 3, 4 } };
float4 main(uniform float scale = 0.5, uniform float3 grey = 0.75, uniform int n = 3,
            uniform bool on = true) : COLOR {
    return tint * scale + grey.xyzz * weights[n] + (on ? offsets[n].xyxy : 0);
})"});
    using Values = std::vector<float>;
    EXPECT_EQ(parameterOf(t, "tint").defaults, (Values{1, 0.5F, 4, -0.25F}));
    EXPECT_EQ(parameterOf(t, "weights").defaults, (Values{0.25F, 0.5F, 0.25F}));
    EXPECT_EQ(parameterOf(t, "offsets").defaults, (Values{1, 2, 3, 4}));
    EXPECT_EQ(parameterOf(t, "offsets").elements, 2u);
    EXPECT_EQ(parameterOf(t, "scale").defaults, (Values{0.5F}));
    EXPECT_EQ(parameterOf(t, "grey").defaults, (Values{0.75F, 0.75F, 0.75F}));
    EXPECT_EQ(parameterOf(t, "n").defaults, (Values{3}));
    EXPECT_EQ(parameterOf(t, "on").defaults, (Values{1}));
}

TEST(CgOnly, DefaultValuesThatAreNoNumbers) {
    EXPECT_EQ(errorOf({Stage::Fragment, "float4 main(\nuniform float a = sin(1)) : COLOR {\n"
                                        "return a; }"}),
              "ERROR: test.cg:2: the default value of the parameter 'a' is not made of numbers "
              "alone");
}

/// What has no counterpart in OGRE or in the front end.
TEST(CgOnly, UnsupportedIsRefusedWithItsLine) {
    const auto error = [](const std::string& parameter, const std::string& value) {
        return errorOf({Stage::Fragment, "struct Light { float4 a; };\nfloat4 main(float3 uv : "
                                         "TEXCOORD0,\n" +
                                             parameter + ") : COLOR { return " + value + "; }"});
    };
    EXPECT_EQ(error("uniform samplerRECT s", "texRECT(s, uv.xy)"),
              "ERROR: test.cg:3: samplerRECT: OGRE has no rectangle textures");
    EXPECT_EQ(error("uniform sampler2DShadow s", "tex2D(s, uv)"),
              "ERROR: test.cg:3: sampler2DShadow: use sampler2D, and compare what it returns");
    EXPECT_EQ(error("uniform Light light", "light.a"),
              "ERROR: test.cg:3: structures cannot be parameters: 'light'");
    EXPECT_EQ(error("uniform float a", "glstate.matrix.mvp[0]"),
              "ERROR: test.cg:3: glstate is not supported; take a parameter, and have the script "
              "set it by param_named_auto");
    EXPECT_EQ(error("uniform sampler2D s[2]", "tex2D(s[1], uv.xy)"),
              "ERROR: test.cg:3: arrays of samplers are not supported: 's'");
}

TEST(CgOnly, LookupThatWouldCompareDepths) {
    EXPECT_TRUE(errorOf({Stage::Fragment, R"(float4 main(float3 uv : TEXCOORD0,
                                             uniform sampler2D s) : COLOR {
        return tex2D(s, uv.xy) + tex2D(s, uv.xyzz)
             + tex2D(s, uv); })"})
                    .starts_with("ERROR: test.cg:4: a lookup with a coordinate more"));
}

TEST(CgOnly, FunctionsForProfiles) {
    Cg::Request request = requestOf({Stage::Fragment, R"(
ps_3_0 float4 choose() { return 0.125; }
arbfp1 float4 choose() { return 0.375; }
float4 main() : COLOR { return choose(); })"});
    request.profile = "arbfp1";
    EXPECT_TRUE(holds(translate(request).glsl, "0.375"));
    request.profile = "ps_3_0";
    EXPECT_TRUE(holds(translate(request).glsl, "0.125"));
    request.profile = "ps_2_0";
    EXPECT_TRUE(translate(request).succeeded());
}

TEST(Messages, NameFileAndLineIncludesIncluded) {
    const Source source = {Stage::Fragment,
                           "#include \"a.cgh\"\nfloat4 main() : COLOR { return helper(); }",
                           Cg::Language::Cg,
                           330,
                           {{"a.cgh", "\n#include <b.cgh>\nfloat4 helper() { return inner(); }"},
                            {"b.cgh", "float4 inner() {\n\n return undefinedThing; }"}}};
    EXPECT_EQ(errorOf(source), "ERROR: b.cgh:3: 'undefinedThing' : unknown variable");
}

TEST(Messages, MissingThings) {
    EXPECT_EQ(errorOf({Stage::Fragment, "float4 other() : COLOR { return 0; }"}),
              "ERROR: test.cg: there is no function 'main', which the script names as the entry "
              "point");
    EXPECT_EQ(
        errorOf({Stage::Fragment, "\n#include \"none.cg\"\nfloat4 main() : COLOR { return 0; }"}),
        "ERROR: test.cg:2: '#include' : Could not process include directive for header name: "
        "none.cg");
    EXPECT_EQ(errorOf({Stage::Fragment, "float4 main(\nfloat4 a) : COLOR { return a; }"}),
              "ERROR: test.cg:2: the parameter 'a' is neither uniform nor has it a semantic");
    EXPECT_EQ(errorOf({Stage::Vertex, "float4 main(float4 a : PATCH3) : POSITION { return a; }"}),
              "ERROR: test.cg:1: OGRE has no vertex element for the input 'PATCH3'");
    EXPECT_NE(errorOf({Stage::Fragment, ""}), "");
}

TEST(Messages, IncludesThatNeverEnd) {
    EXPECT_TRUE(holds(
        errorOf(
            {Stage::Fragment, "#include \"a\"", Cg::Language::Cg, 330, {{"a", "#include \"a\""}}}),
        "nested too deeply"));
}

TEST(Messages, NestingThatNeverEnds) {
    const std::string deep(100000, '(');
    EXPECT_TRUE(holds(errorOf({Stage::Fragment, "float4 main() : COLOR { return " + deep + "1; }"}),
                      "too many brackets in brackets"));
    std::string sum = "1";
    for (int i = 0; i < 100000; ++i)
        sum += "+1";
    EXPECT_TRUE(holds(errorOf({Stage::Fragment, "float4 main() : COLOR { return " + sum + "; }"}),
                      "too many tokens in a statement"));
}

TEST(Names, UniformsOfTheEntryPointHideOthers) {
    const Translation t = translated({Stage::Fragment, R"(
float4 tint;
float4 scale(float4 x) { return x * tint; }
struct S { float4 tint; };
float4 main(uniform float4 scale_, uniform float4 scale) : COLOR {
    S s; s.tint = scale; return s.tint * scale_ + tint; })"});
    EXPECT_TRUE(parameterOf(t, "scale").used);
    EXPECT_TRUE(parameterOf(t, "tint").used);
}

TEST(Names, OfGlslAndOfOgre) {
    const Translation t = translated({Stage::Vertex, R"(
float4 mix(float4 a) { return a; }
float4 main(float4 vertex : POSITION, uniform float4 uniform__x, uniform float4 output,
            uniform float4 vec4) : POSITION {
    return mix(vertex) + uniform__x * output + vec4; })"});
    EXPECT_TRUE(parameterOf(t, "uniform__x").used);
    EXPECT_TRUE(parameterOf(t, "vec4").used);
    EXPECT_EQ(t.attributes, std::vector<std::string>{"vertex"});
}

TEST(Interface, AttributesAndVaryings) {
    const Translation t = translated({Stage::Vertex, R"(
struct Out {
    float4 p : POSITION; float2 uv[2] : TEXCOORD0; float3x3 m : TEXCOORD2; float f : FOG; };
Out main(float3 p : POSITION, float3 n : NORMAL, float4 c : COLOR, float2 uv3 : TEXCOORD3,
         float3 t : TANGENT, int4 b : BLENDINDICES, float w : BLENDWEIGHT) {
    Out o; o.p = float4(p, 1); o.uv[0] = uv3; o.uv[1] = c.xy;
    o.m[0] = n; o.m[1] = t; o.m[2] = b.xyz;
    o.f = w; return o; })"});
    EXPECT_EQ(t.attributes, (std::vector<std::string>{"vertex", "normal", "colour", "uv3",
                                                      "tangent", "blendIndices", "blendWeights"}));
    for (const char* varying : {"v_TEXCOORD0", "v_TEXCOORD1", "v_TEXCOORD4", "v_FOG0"})
        EXPECT_TRUE(holds(t.glsl, std::string("out vec4 ") + varying + ";")) << t.glsl;
}

TEST(Interface, FragmentInputsAndOutputs) {
    const Translation t = translated({Stage::Fragment, R"(
void main(float4 w : WPOS, float face : FACE, float3 uv : TEXCOORD5, out float3 a : COLOR0,
          out float4 b : COLOR1, out float d : DEPTH) { a = uv * face; b = w; d = uv.z; })"});
    for (const char* part : {"gl_FragCoord", "gl_FrontFacing", "in vec4 v_TEXCOORD5",
                             "gl_FragDepth", "layout(location = 1) out vec4 f_COLOR1"})
        EXPECT_TRUE(holds(t.glsl, part)) << t.glsl;
}

TEST(Interface, OfFixedFunctionsInOlderGl) {
    Source source = {Stage::Vertex, R"(
void main(float4 p : POSITION, float2 uv : TEXCOORD0, out float4 o : POSITION,
          out float2 t : TEXCOORD0, out float4 c : COLOR1, out float f : FOG,
          uniform float4x4 m, uniform float2 a[3], uniform bool on) {
    o = mul(m, p); t = on ? uv : fmod(a[1], 2); c = a[2].xyxy; f = 1; })"};
    source.glslVersion = 120;
    const Translation t = translated(source);
    for (const char* part : {"gl_TexCoord[0] = ", "gl_FrontSecondaryColor = ", "gl_FogFragCoord = ",
                             "attribute vec4 uv0;"})
        EXPECT_TRUE(holds(t.glsl, part)) << t.glsl;
}

TEST(Parameters, ArePaddedToFourComponents) {
    const Translation t = translated({Stage::Vertex, R"(
float4 sum(float2 a[3]) { return a[0].xyxy + a[1].xyxy + a[2].xyxy; }
float4 main(float4 p : POSITION, uniform float3x3 n, uniform float3x4 bones[4], uniform float2 a[3],
            uniform float s, uniform float3x3 m[2]) : POSITION {
    int i = (int)p.w;
    return float4(mul(n, mul(bones[i], p)) * s + mul(m[i], p.xyz), a[i].x) + sum(a); })"});
    for (const char* part : {"uniform mat3x4 u_n;", "uniform mat3x4 u_bones[4];",
                             "uniform vec4 u_a[3];", "uniform vec4 u_s;", "uniform mat3x4 u_m[2];"})
        EXPECT_TRUE(holds(t.glsl, part)) << t.glsl;
}

TEST(Parameters, OfMatricesInTheOtherOrderAreTransposed) {
    const auto isTransposed = [](const std::string& declaration, Cg::Language language) {
        Source source = {Stage::Vertex, declaration + "; float4 main(float4 p : POSITION) : "
                                                      "POSITION { return mul(m, p); }"};
        source.language = language;
        return holds(translated(source).glsl, "transpose(");
    };
    EXPECT_FALSE(isTransposed("float4x4 m", Cg::Language::Cg));
    EXPECT_FALSE(isTransposed("row_major float4x4 m", Cg::Language::Cg));
    EXPECT_TRUE(isTransposed("column_major float4x4 m", Cg::Language::Cg));
    EXPECT_FALSE(isTransposed("float4x4 m", Cg::Language::Hlsl));
    EXPECT_FALSE(isTransposed("column_major float4x4 m", Cg::Language::Hlsl));
    EXPECT_TRUE(isTransposed("row_major float4x4 m", Cg::Language::Hlsl));
    EXPECT_TRUE(isTransposed("#pragma pack_matrix(row_major)\nfloat4x4 m", Cg::Language::Hlsl));
}

TEST(Hlsl, ConstantBuffersAndSeparateSamplers) {
    Source source = {Stage::Fragment, R"(
cbuffer Numbers : register(b0) { float4 tint : packoffset(c0); float scale; };
Texture2D image : register(t2); SamplerState state : register(s2);
SamplerState other : register(s1);
Texture2D second;
float4 read(Texture2D t, SamplerState s, float2 uv) { return t.Sample(s, uv); }
struct Input { float4 position : SV_Position; float2 uv : TEXCOORD0; };
float4 main(Input input) : SV_Target {
    return read(image, state, input.uv) * tint * scale + second.Sample(other, input.uv); })"};
    source.language = Cg::Language::Hlsl;
    const Translation t = translated(source);
    EXPECT_TRUE(parameterOf(t, "tint").used);
    ASSERT_EQ(t.samplers.size(), 2u);
    EXPECT_EQ(t.samplers[0].name, "image");
    EXPECT_EQ(t.samplers[0].unit, 2u);
    EXPECT_EQ(t.samplers[1].unit, 0u);
}

TEST(Hlsl, EffectFiles) {
    Source source = {Stage::Fragment, R"(
texture map < string name = "x.png"; >;
float scale : Scale < string UIName = "Scale"; float UIMin = 0.0; > = 2.0f;
sampler image = sampler_state { Texture = <map>; MinFilter = Linear; };
float4 main(float2 uv : TEXCOORD0) : COLOR0 { return tex2D(image, uv) * scale; }
technique T { pass P { PixelShader = compile ps_2_0 main(); } })"};
    source.language = Cg::Language::Hlsl;
    const Translation t = translated(source);
    EXPECT_EQ(parameterOf(t, "scale").defaults, std::vector<float>{2});
    ASSERT_EQ(t.samplers.size(), 1u);
}

TEST(Hlsl, FlatInitialValues) {
    translated({Stage::Fragment, R"(
static const float2 offsets[2] = { 1, 2, 3, 4 };
float4 main() : COLOR {
    const float3 taps[2] = { -1, 0, 1, 2, 2, 2 };
    float2x2 m = { 1, 0, 0, 1 };
    return float4(mul(m, offsets[1]), taps[1].xy); })"});
}

TEST(Functions, OfTheOtherStageDoNotMatter) {
    const char* text = R"(
float4 v_main(float4 p : POSITION, uniform float4x4 m) : POSITION { return mul(m, p); }
float4 main(float2 uv : TEXCOORD0, uniform sampler2D s) : COLOR { clip(uv.x - 0.5);
    return tex2D(s, uv) + ddx(uv.x); })";
    Cg::Request request = requestOf({Stage::Vertex, text});
    request.entry = "v_main";
    EXPECT_TRUE(translate(request).succeeded());
    translated({Stage::Fragment, text});
}

TEST(Functions, LookupsInVertexPrograms) {
    translated({Stage::Vertex, R"(
float4 main(float4 p : POSITION, uniform sampler2D s, uniform sampler3D v) : POSITION {
    return p + tex2D(s, p.xy) + tex3D(v, p.xyz); })"});
}

TEST(Threads, TranslateAtOnce) {
    const Source source = {Stage::Fragment, R"(
float4 main(float2 uv : TEXCOORD0, uniform sampler2D s, uniform float4 t) : COLOR {
    return tex2D(s, uv) * t; })"};
    const std::string expected = translated(source).glsl;
    std::vector<std::thread> threads;
    std::array<std::string, 4> results;
    for (std::string& result : results)
        threads.emplace_back([&result, &source] {
            for (int i = 0; i < 10; ++i)
                result = translate(requestOf(source)).glsl;
        });
    for (std::thread& thread : threads)
        thread.join();
    for (const std::string& result : results)
        EXPECT_EQ(result, expected);
}

} // namespace
} // namespace Lixel::Tests
