// Programs in Cg and HLSL as scripts name them, drawn by each of OGRE's OpenGL render systems.

#include "DrawingOgre.h"

#include <OgreHardwarePixelBuffer.h>
#include <OgreImage.h>
#include <OgreSceneNode.h>
#include <OgreTextureManager.h>

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
    EXPECT_EQ(ogre.draw("A"), (Pixel{51, 51, 217})) << ogre.problems();
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
    EXPECT_EQ(ogre.draw("B"), (Pixel{102, 51, 204})) << ogre.problems();
}

TEST_P(Drawing, ObjectsHaveTheirOwnMatrices) {
    ogre.write("m.cg", R"(
void vertex_main(float4 position : POSITION, out float4 p : POSITION, out float4 c : COLOR,
                 uniform float4x4 world, uniform float3x3 rotation, uniform float4x4 notUsed) {
    p = mul(world, position);
    c = float4(mul(rotation, float3(1, 0, 0)), 1);
}
float4 fragment_main(float4 c : COLOR) : COLOR { return c; })");
    ogre.write("m.material", material("M", "m.cg", "cg",
                                      "param_named_auto world world_matrix\n"
                                      "param_named_auto rotation world_matrix\n"
                                      "param_named_auto notUsed view_matrix",
                                      ""));
    ogre.readScripts();
    Ogre::SceneNode& left = ogre.addRectangle("M");
    left.setPosition(-0.5F, 0, -0.1F);
    left.setScale(0.5F, 1, 1);
    Ogre::SceneNode& right = ogre.addRectangle("M");
    right.setPosition(0.5F, 0, -0.1F);
    right.setScale(0.25F, 1, 1);
    ogre.draw("M");
    EXPECT_EQ(ogre.pixel(2, 8), (Pixel{128, 0, 0})) << ogre.problems();
    EXPECT_EQ(ogre.pixel(12, 8), (Pixel{64, 0, 0}));
    EXPECT_EQ(ogre.pixel(15, 8), (Pixel{255, 0, 0}));
}

/// A texture of one colour, 2D or a cube.
void makeTexture(const std::string& name, const Ogre::ColourValue& colour,
                 Ogre::TextureType type = Ogre::TEX_TYPE_2D) {
    auto texture = Ogre::TextureManager::getSingleton().createManual(name, Ogre::RGN_DEFAULT, type,
                                                                     2, 2, 0, Ogre::PF_BYTE_RGBA);
    Ogre::Image image(Ogre::PF_BYTE_RGBA, 2, 2);
    image.setTo(colour);
    for (std::size_t face = 0; face < texture->getNumFaces(); ++face)
        texture->getBuffer(face)->blitFromMemory(image.getPixelBox());
}

TEST_P(Drawing, SamplersByRegisterAndOrder) {
    makeTexture("red", Ogre::ColourValue(0.2F, 0, 0));
    makeTexture("green", Ogre::ColourValue(0, 0.4F, 0));
    makeTexture("blue", Ogre::ColourValue(0, 0, 0.6F), Ogre::TEX_TYPE_CUBE_MAP);
    ogre.write("s.cg", R"(
void vertex_main(float4 position : POSITION, float2 uv : TEXCOORD0, out float4 p : POSITION,
                 out float2 u : TEXCOORD0) { p = position; u = uv; }
float4 fragment_main(float2 uv : TEXCOORD0, uniform samplerCUBE sky,
                     uniform sampler2D first : register(s0),
                     uniform sampler2D unused, uniform sampler2D second : TEXUNIT1) : COLOR {
    return float4(1, 0, 0, 0) * tex2D(first, uv) + tex2D(second, uv) + texCUBE(sky, float3(uv, 1));
})");
    std::string script = material("S", "s.cg", "cg", "", "");
    const std::string units = "} texture_unit { texture red\n } texture_unit { texture green\n }"
                              " texture_unit { texture blue cubic\n } } } }\n";
    script.replace(script.rfind("} } } }"), std::string::npos, units);
    ogre.write("s.material", script);
    ogre.readScripts();
    EXPECT_EQ(ogre.draw("S"), (Pixel{51, 102, 153})) << ogre.problems();
}

} // namespace
} // namespace Lixel::Tests
