// What OGRE's scripts say of Cg and HLSL programs, and what becomes of programs that are wrong.

#include "DrawingOgre.h"

#include <OgreGpuProgramManager.h>
#include <OgreHighLevelGpuProgramManager.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgrePlugin.h>
#include <OgreResourceBackgroundQueue.h>
#include <OgreResourceGroupManager.h>
#include <OgreStringInterface.h>
#include <OgreTechnique.h>
#include <OgreUnifiedHighLevelGpuProgram.h>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace Lixel::Tests {
namespace {

class Scripts : public testing::TestWithParam<RenderPath> {
protected:
    /// A vertex program V and a material M whose fragment program has that body, parameters before
    /// it and lines of its script.
    void writeProgram(const std::string& source, const std::string& words,
                      const std::string& reference = "", const std::string& language = "cg") {
        ogre.write("v.cg", "float4 main(float4 p : POSITION) : POSITION { return p; }");
        ogre.write("f.cg", source);
        ogre.write("m.material", "vertex_program V cg { source v.cg\n profiles arbvp1\n }\n"
                                 "fragment_program F " +
                                     language + " { source f.cg\n" + words +
                                     "\n}\nmaterial M { technique { pass { cull_hardware none\n"
                                     "vertex_program_ref V { }\nfragment_program_ref F {\n" +
                                     reference + "\n} } } }\n");
        ogre.readScripts();
    }

    DrawingOgre ogre{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(RenderSystems, Scripts,
                         testing::Values(GL3Plus, GL3PlusSeparate, LegacyGL),
                         [](const auto& path) { return std::string(path.param.name); });

TEST_P(Scripts, DefinesArgumentsAndIncludes) {
    ogre.write("colour.cgh", "float4 colour() { return float4(RED, GREEN, BLUE, OGRE_CG); }");
    writeProgram("#include \"colour.cgh\"\nfloat4 fragment() : COLOR { return colour(); }",
                 "entry_point fragment\nprofiles arbfp1\n"
                 "compile_arguments -DRED=0.2 -D GREEN=0.4\npreprocessor_defines BLUE=0.6");
    EXPECT_EQ(ogre.draw("M"), (Pixel{51, 102, 153})) << ogre.problems();
}

TEST_P(Scripts, DefaultValuesAndDefaultParameters) {
    writeProgram("float4 main(uniform float3 a = float3(0.4, 0.4, 0.4), uniform float2 b[2] = "
                 "{{0,0},{0.2,0.4}},\n uniform float c = 1, uniform float unused = 3) : COLOR {\n"
                 "return float4(a * c + float3(0, b[1]), 1); }",
                 "profiles arbfp1\ndefault_params { param_named c float 0.5\n"
                 "param_named unused float4 1 2 3 4\n }");
    EXPECT_EQ(ogre.draw("M"), (Pixel{51, 102, 153})) << ogre.problems();
    EXPECT_EQ(ogre.logged("does not exist"), "");
}

/// As for Cg and Direct3D, each parameter may be given four numbers, and each element of an array
/// takes four.
TEST_P(Scripts, NumbersArePadded) {
    writeProgram(
        "float4 main(uniform float a, uniform float b, uniform float2 c[2], uniform int n,\n"
        " uniform bool on) : COLOR { return on ? float4(a, b, c[n].y, 1) : 0; }",
        "profiles arbfp1",
        "param_named a float4 0.2 9 9 9\nparam_named b float 0.4\n"
        "param_named c float8 9 9 9 9 9 0.6 9 9\nparam_named n int 1\n"
        "param_named on int 1");
    EXPECT_EQ(ogre.draw("M"), (Pixel{51, 102, 153})) << ogre.problems();
}

TEST_P(Scripts, ParametersByIndexHaveNoEffect) {
    writeProgram("float4 main(uniform float4 a) : COLOR { return a; }", "profiles arbfp1",
                 "param_named a float4 0 1 0 1\nparam_indexed 0 float4 1 1 1 1\n"
                 "param_indexed 7 float8 1 1 1 1 1 1 1 1\n"
                 "param_indexed_auto 3 worldviewproj_matrix");
    EXPECT_EQ(ogre.draw("M"), (Pixel{0, 255, 0})) << ogre.problems();
}

TEST_P(Scripts, WhatChongsArticleUses) {
    ogre.write("shadow.hlsl", R"(
void main(float4 position : POSITION, float4 normal : NORMAL, out float4 outPos : POSITION,
          out float4 outShadowUV : TEXCOORD0, uniform float4x4 worldMatrix,
          uniform float4x4 viewProjMatrix, uniform float4x4 texViewProj,
          uniform float4x4 inverseWorldViewProj, uniform float4 lightPosition) {
    float4 worldPos = mul(worldMatrix, position);
    outPos = mul(viewProjMatrix, worldPos);
    outShadowUV = mul(texViewProj, worldPos) * 0 + mul(inverseWorldViewProj, outPos);
})");
    ogre.write("read.cg",
               "float4 main(float4 uv : TEXCOORD0, uniform sampler2D shadowMap : TEXUNIT0) "
               ": COLOR { return float4(abs(uv.xyz) / 2 / uv.w, 1) "
               "+ 0 * tex2Dproj(shadowMap, uv); }");
    ogre.write("a.material", R"(
vertex_program Lxl/VP hlsl { source shadow.hlsl
    entry_point main
    target vs_2_0 }
fragment_program Lxl/FP cg { source read.cg
    entry_point main
    profiles arbf1 ps_2_0 }
material M { technique { pass { cull_hardware none
    vertex_program_ref Lxl/VP {
        param_named_auto worldMatrix world_matrix
        param_named_auto viewProjMatrix viewproj_matrix
        param_named_auto texViewProj texture_viewproj_matrix
        param_named_auto inverseWorldViewProj inverse_worldviewproj_matrix
        param_named_auto lightPosition light_position 0 }
    fragment_program_ref Lxl/FP { } } } })");
    ogre.readScripts();
    // The rectangle's middle is at (0, 0, 0.5).
    const Pixel pixel = ogre.draw("M");
    EXPECT_LE(pixel.red, 8) << ogre.problems();
    EXPECT_EQ(pixel.blue, 64);
    EXPECT_EQ(ogre.logged("rror:"), "");
}

TEST_P(Scripts, BrokenProgramBreaksItsOwnMaterialAlone) {
    ogre.write("good.cg", "float4 main(float4 p : POSITION) : POSITION { return p; }\n"
                          "float4 red() : COLOR { return float4(1, 0, 0, 1); }");
    ogre.write("bad.cg", "float4 main() : COLOR {\n\n    return undefinedThing;\n}");
    ogre.write("m.material", R"(
vertex_program V cg { source good.cg
 profiles arbvp1 }
fragment_program Good cg { source good.cg
 entry_point red
 profiles arbfp1 }
fragment_program Bad cg { source bad.cg
 profiles arbfp1 }
fragment_program Missing cg { source none.cg
 profiles arbfp1 }
fragment_program Foreign cg { source good.cg
 profiles gs_4_0 }
material Good { technique { pass { cull_hardware none
 vertex_program_ref V { }
 fragment_program_ref Good { } } } }
material FallsBack { technique { pass { vertex_program_ref V { }
 fragment_program_ref Bad { } } }
 technique { pass { cull_hardware none
 vertex_program_ref V { }
 fragment_program_ref Good { } } } }
material Missing { technique { pass { vertex_program_ref V { }
 fragment_program_ref Missing { } } } }
material Foreign { technique { pass { vertex_program_ref V { }
 fragment_program_ref Foreign { } } } })");
    ogre.readScripts();
    EXPECT_EQ(ogre.draw("Good"), (Pixel{255, 0, 0}));
    EXPECT_EQ(ogre.draw("FallsBack"), (Pixel{255, 0, 0}));
    EXPECT_NE(ogre.logged("ERROR: bad.cg:3: 'undefinedThing' : unknown variable"), "");
    for (const char* name : {"Missing", "Foreign"}) {
        const auto material = Ogre::MaterialManager::getSingleton().getByName(name);
        EXPECT_NO_THROW(material->load());
        EXPECT_EQ(material->getSupportedTechniques().size(), 0u);
    }
    EXPECT_NE(ogre.logged("none.cg"), "");
    EXPECT_NE(ogre.logged("Foreign cannot be used"), "") << ogre.logged("Foreign");
}

TEST_P(Scripts, UnifiedProgramsAndListsOfLanguagesPreferGlsl) {
    const bool legacy = GetParam().plugin == LegacyGL.plugin;
    ogre.write("v.cg", "float4 main(float4 p : POSITION) : POSITION { return p; }");
    ogre.write("f.cg", "float4 main() : COLOR { return 1; }");
    ogre.write("f.glsl", legacy ? "#version 120\nvoid main() { gl_FragColor = vec4(1.0); }"
                                : "#version 330\nout vec4 f; void main() { f = vec4(1.0); }");
    ogre.write("m.material", R"(
fragment_program G glsl { source f.glsl
 }
fragment_program C cg { source f.cg
 profiles arbfp1 }
fragment_program Unknown cg { source f.cg
 profiles gs_4_0 }
fragment_program H hlsl { source f.cg
 target ps_2_0 }
fragment_program GlslFirst unified { delegate G
 delegate C
 delegate H }
fragment_program NoGlsl unified { delegate H
 delegate C
 delegate Unknown }
fragment_program List hlsl cg glsl { source f.glsl
 }
fragment_program Short hlsl glsles { source f.cg
 target ps_2_0
 })");
    ogre.readScripts();
    const auto language = [](const char* name) {
        const auto program = Ogre::GpuProgramManager::getSingleton().getByName(name);
        auto* unified = dynamic_cast<Ogre::UnifiedHighLevelGpuProgram*>(program.get());
        return unified == nullptr ? program->getLanguage() : unified->_getDelegate()->getLanguage();
    };
    EXPECT_EQ(language("GlslFirst"), "glsl");
    EXPECT_EQ(language("NoGlsl"), "cg");
    EXPECT_EQ(language("List"), "glsl");
    EXPECT_EQ(language("Short"), "hlsl");
}

TEST_P(Scripts, ReloadTakesTheNewSource) {
    writeProgram("float4 main(uniform float4 a) : COLOR { return a; }", "profiles arbfp1",
                 "param_named a float4 0 1 0 1");
    EXPECT_EQ(ogre.draw("M"), (Pixel{0, 255, 0}));
    ogre.write("f.cg",
               "float4 main(uniform float b, uniform float4 a) : COLOR { return a.yxzw + b; }");
    const auto program = Ogre::GpuProgramManager::getSingleton().getByName("F");
    program->reload();
    EXPECT_EQ(ogre.draw("M"), (Pixel{255, 0, 0})) << ogre.problems();
    ogre.write("f.cg", "float4 main( : COLOR");
    program->reload();
    EXPECT_FALSE(program->isSupported());
    ogre.write("f.cg", "float4 main() : COLOR { return float4(0, 0, 1, 1); }");
    program->reload();
    EXPECT_TRUE(program->isSupported());
    EXPECT_EQ(ogre.draw("M"), (Pixel{0, 0, 255})) << ogre.problems();
}

TEST_P(Scripts, ProgramsFromText) {
    const auto make = [](const char* name, Ogre::GpuProgramType type, const char* profile,
                         const char* source) {
        auto program = Ogre::HighLevelGpuProgramManager::getSingleton().createProgram(
            name, Ogre::RGN_DEFAULT, "cg", type);
        program->setSource(source);
        EXPECT_TRUE(program->setParameter("profiles", profile));
        EXPECT_EQ(program->getParameter("profiles"), profile);
        program->load();
        EXPECT_TRUE(program->isSupported());
    };
    make("V", Ogre::GPT_VERTEX_PROGRAM, "vs_2_0 arbvp1",
         "float4 main(float4 p : POSITION) : POSITION { return p; }");
    make("F", Ogre::GPT_FRAGMENT_PROGRAM, "ps_2_0 arbfp1",
         "float4 main() : COLOR { return float4(0, 1, 1, 1); }");
    auto material = Ogre::MaterialManager::getSingleton().create("M", Ogre::RGN_DEFAULT);
    Ogre::Pass* pass = material->getTechnique(0)->getPass(0);
    pass->setCullingMode(Ogre::CULL_NONE);
    pass->setVertexProgram("V");
    pass->setFragmentProgram("F");
    EXPECT_EQ(ogre.draw("M"), (Pixel{0, 255, 255}));
}

/// OGRE prepares resources in a thread of its own, and loads them in the one that has OpenGL.
TEST_P(Scripts, PreparedInTheBackground) {
    writeProgram("float4 main() : COLOR { return float4(1, 1, 0, 1); }", "profiles arbfp1");
    const auto program = Ogre::GpuProgramManager::getSingleton().getByName("F");
    program->unload();
    std::thread([&program] { program->prepare(); }).join();
    EXPECT_TRUE(program->isPrepared());
    EXPECT_EQ(ogre.draw("M"), (Pixel{255, 255, 0}));
}

TEST_P(Scripts, CacheFolder) {
    Ogre::StringInterface* settings = nullptr;
    for (Ogre::Plugin* plugin : ogre.root().getInstalledPlugins())
        if (plugin->getName() == "Lixel Cg")
            settings = dynamic_cast<Ogre::StringInterface*>(plugin);
    ASSERT_NE(settings, nullptr);
    const auto folder = ogre.folder() / "cache";
    EXPECT_EQ(settings->getParameter("cache_folder"), "");
    EXPECT_TRUE(settings->setParameter("cache_folder", folder.string()));
    EXPECT_EQ(settings->getParameter("cache_folder"), folder.string());
    writeProgram("float4 main() : COLOR { return 1; }", "profiles arbfp1");
    EXPECT_EQ(ogre.draw("M"), (Pixel{255, 255, 255}));
    const auto files = std::filesystem::directory_iterator(folder);
    EXPECT_EQ(std::distance(begin(files), end(files)), 2);
}

/// In OpenGL 2.1 a program of one stage works with OpenGL's fixed functions for the other.
TEST(LegacyScripts, EitherProgramAlone) {
    DrawingOgre ogre(LegacyGL);
    ogre.write("a.cg", R"(
void v(float4 p : POSITION, float4 c : COLOR, out float4 o : POSITION, out float4 oc : COLOR) {
    o = p; oc = c * 2; }
float4 f(float4 c : COLOR) : COLOR { return float4(c.rgb + 0.2, 1); })");
    ogre.write("a.material", R"(
vertex_program V cg { source a.cg
 entry_point v
 profiles arbvp1 }
fragment_program F cg { source a.cg
 entry_point f
 profiles arbfp1 }
material V { technique { pass { cull_hardware none
 vertex_program_ref V { } } } }
material F { technique { pass { cull_hardware none
 lighting off
 diffuse vertexcolour
 ambient vertexcolour
 fragment_program_ref F { } } } })");
    ogre.readScripts();
    EXPECT_EQ(ogre.draw("V"), (Pixel{102, 204, 255})) << ogre.problems();
    EXPECT_EQ(ogre.draw("F"), (Pixel{102, 153, 204})) << ogre.problems();
}

} // namespace
} // namespace Lixel::Tests
