// Programs in Cg and HLSL as scripts name them, drawn by each of OGRE's OpenGL render systems.

#include "DrawingOgre.h"

#include <gtest/gtest.h>

namespace Lixel::Tests {
namespace {

class Drawing : public testing::TestWithParam<RenderPath> {
protected:
    DrawingOgre ogre{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(RenderSystems, Drawing,
                         testing::Values(GL3Plus, GL3PlusSeparate, LegacyGL),
                         [](const auto& path) { return std::string(path.param.name); });

/// A pass with both programs of one file.
std::string material(const std::string& name, const std::string& file, const std::string& language,
                     const std::string& vertexParameters, const std::string& fragmentParameters) {
    const bool cg = language == "cg";
    return "vertex_program " + name + "VP " + language + " { source " + file +
           "\n entry_point vertex_main\n " + (cg ? "profiles arbvp1 vs_2_0" : "target vs_2_0") +
           "\n}\nfragment_program " + name + "FP " + language + " { source " + file +
           "\n entry_point fragment_main\n " + (cg ? "profiles arbf1 ps_2_0" : "target ps_2_0") +
           "\n}\nmaterial " + name + "\n{ technique { pass { cull_hardware none\n" +
           "vertex_program_ref " + name + "VP {\n" + vertexParameters +
           "\n}\nfragment_program_ref " + name + "FP {\n" + fragmentParameters + "\n} } } }\n";
}

TEST_P(Drawing, CgAsArticlesHaveIt) {
    ogre.write("a.cg", R"(
struct Output { float4 position : POSITION; float4 texCoord : TEXCOORD0; fixed4 colour : COLOR; };
Output vertex_main(float4 position : POSITION, in varying float2 uv : TEXCOORD0,
                   fixed4 colour : COLOR, uniform float4x4 worldViewProj) {
    Output output;
    output.position = mul(worldViewProj, position);
    output.texCoord = float4(uv, 0, 1);
    output.colour = colour;
    return output;
}
void fragment_main(float4 texCoord : TEXCOORD0, fixed4 colour : COLOR,
                   uniform float4 tint, out float4 result : COLOR) {
    result = float4(colour.rgb * tint.rgb, 1) + float4(0, 0, texCoord.w * .25x, 0);
})");
    ogre.write("a.material",
               material("A", "a.cg", "cg", "param_named_auto worldViewProj worldviewproj_matrix",
                        "param_named tint float4 1 0.5 1 1"));
    ogre.readScripts();
    EXPECT_EQ(ogre.draw("A"), (Pixel{51, 51, 217})) << ogre.logged("");
}

TEST_P(Drawing, HlslWithGlobalParameters) {
    ogre.write("b.hlsl", R"(
float4x4 worldViewProj : WORLDVIEWPROJECTION;
float3 tint = { 0.5, 0.25, 1 };
static const float scale = 2.0;
void vertex_main(float4 position : POSITION, out float4 outPosition : POSITION,
                 float2 uv : TEXCOORD0, out float2 outUv : TEXCOORD0) {
    outPosition = mul(worldViewProj, position);
    outUv = uv;
}
float4 fragment_main(float4 uv : TEXCOORD0) : COLOR { return float4(tint * scale * 0.4, 1); }
)");
    ogre.write("b.material", material("B", "b.hlsl", "hlsl",
                                      "param_named_auto worldViewProj worldviewproj_matrix", ""));
    ogre.readScripts();
    EXPECT_EQ(ogre.draw("B"), (Pixel{102, 51, 204})) << ogre.logged("");
}

} // namespace
} // namespace Lixel::Tests
