// Scripts and shaders that are edited while a program draws.

#include "EditedFolder.h"
#include "MaterialScene.h"
#include "PlainVertex.h"

#include <Lixel/reload/Reload.h>
#include <Lixel/script/ShadowCameraSetupManager.h>

#include <OgreScriptCompiler.h>

namespace Lixel::Tests {
namespace {

const char* const Shader = R"(#version 330 core
#include "edited.glsl"
out vec4 fragColour;
void main()
{
    fragColour = vec4(level(), 0.0, 0.0, 1.0);
}
)";

std::string programsIn(const std::string& language) {
    return "vertex_program Edited/VP " + language + R"(
{
    source edited.vert
    default_params
    {
        param_named_auto worldViewProj worldviewproj_matrix
    }
}
fragment_program Edited/FP )" +
           language + R"(
{
    source edited.frag
    default_params
    {
        param_named scale float 1
    }
}
)";
}

/// The fragment program's parameters are given by `lines`.
std::string materialWith(const std::string& lines) {
    return "material Edited/Level\n{\n    technique\n    {\n        pass\n        {\n"
           "            vertex_program_ref Edited/VP\n            {\n            }\n"
           "            fragment_program_ref Edited/FP\n            {\n                " +
           lines + "\n            }\n        }\n    }\n}\n";
}

std::string levelOf(const std::string& value) {
    return "uniform float scale;\nfloat level()\n{\n    return " + value + " * scale;\n}\n";
}

/// A ground whose colour is in files, with programs of the first language that OGRE knows: half of
/// white to begin with.
class Reload : public testing::TestWithParam<const char*> {
protected:
    Reload() : scene(IntegratedTechnique, "") {
        scene.wear("Lixel/Surface/Integrated");
        folder.write("edited.vert", PlainVertex);
        folder.write("edited.frag", Shader);
        folder.write("edited.glsl", levelOf("0.5"));
        folder.write("edited.program", programs());
        folder.write("edited.material", materialWith(""));
        // Broken from the start.
        folder.write("later.frag", "#version 330 core\nwrong");
        folder.write("later.program", std::string("fragment_program Edited/LaterFP ") + GetParam() +
                                          "\n{\n"
                                          "    source later.frag\n    default_params\n    {\n"
                                          "    }\n}\n");
        folder.parse();
        static_cast<Ogre::Entity&>(*scene.ground->getAttachedObject(0))
            .setMaterialName("Edited/Level", EditedFolder::Group);
        EXPECT_EQ(level(), 128);
    }

    std::string programs() const { return programsIn(GetParam()); }
    int level() { return scene.draw()[scene.pixelOf(Ogre::Vector3(4, 0, 4))]; }

    void expectAll(const std::vector<std::string>& errors, const std::string& text) const {
        EXPECT_FALSE(errors.empty()) << text;
        for (const std::string& error : errors)
            EXPECT_NE(error.find(text), std::string::npos) << error;
    }

    MaterialScene scene;
    EditedFolder folder;
};

INSTANTIATE_TEST_SUITE_P(Languages, Reload, testing::Values("glsl", "lixel_glsl glsl"));

TEST_P(Reload, ShowsWhatAShaderIncludes) {
    folder.write("edited.glsl", levelOf("0.25"));
    EXPECT_EQ(level(), 128) << "nothing was read yet";
    EXPECT_TRUE(folder.reload().empty());
    EXPECT_EQ(level(), 64);
}

TEST_P(Reload, ShowsAMaterial) {
    folder.write("edited.material", materialWith("param_named scale float 0.5"));
    EXPECT_TRUE(folder.reload().empty());
    EXPECT_EQ(level(), 64);
    folder.write("edited.material", materialWith(""));
    EXPECT_TRUE(folder.reload().empty());
    EXPECT_EQ(level(), 128) << "a line that went has no effect any more";
}

TEST_P(Reload, ShowsAProgramsDefaults) {
    std::string half = programs();
    half.replace(half.find("float 1"), 7, "float 0.5");
    folder.write("edited.program", half);
    EXPECT_TRUE(folder.reload().empty());
    EXPECT_EQ(level(), 64);
}

TEST_P(Reload, ShowsDefinitionsOfThePreprocessor) {
    folder.write("edited.glsl", "uniform float scale;\n#ifdef DARK\nuniform float dark;\n#else\n"
                                "const float dark = 1.0;\n#endif\n"
                                "float level()\n{\n    return 0.5 * dark * scale;\n}\n");
    EXPECT_TRUE(folder.reload().empty());
    EXPECT_EQ(level(), 128);
    std::string dark = programs();
    dark.replace(dark.find("source edited.frag"), 18,
                 "source edited.frag\n    preprocessor_defines DARK=1");
    dark.replace(dark.find("float 1"), 7, "float 1\n        param_named dark float 0.5");
    folder.write("edited.program", dark);
    EXPECT_EQ(folder.reload(), std::vector<std::string>());
    EXPECT_EQ(level(), 64);
}

TEST_P(Reload, KeepsTheLastGoodShader) {
    folder.write("edited.glsl", levelOf("0.25 +"));
    expectAll(folder.reload(), "edited.frag does not compile, or a file is missing");
    EXPECT_EQ(level(), 128);
    folder.write("edited.glsl", levelOf("0.25"));
    EXPECT_TRUE(folder.reload().empty());
    EXPECT_EQ(level(), 64);
}

TEST_P(Reload, OutlivesAFileThatIsMissing) {
    folder.remove("edited.glsl");
    expectAll(folder.reload(), "a file is missing");
    EXPECT_EQ(level(), 128);
    folder.write("edited.glsl", levelOf("0.25"));
    EXPECT_EQ(folder.reload(), std::vector<std::string>());
    EXPECT_EQ(level(), 64);
}

TEST_P(Reload, KnowsWhatOtherGroupsHave) {
    const std::string surface = "import * from \"Lixel.material\"\n"
                                "material Edited/Inherits : Lixel/Surface/Integrated\n{\n}\n";
    folder.write("edited.material", surface + materialWith("param_named scale float 0.5"));
    EXPECT_EQ(folder.reload(), std::vector<std::string>());
    EXPECT_EQ(level(), 64);
}

TEST_P(Reload, DefinesSetupsOfMaterialScriptsAnew) {
    const std::string setup = "shadow_camera_setup Edited/Sun\n{\n    map_size ";
    for (const char* const size : {"256", "512", "128"}) {
        folder.write("edited.material", materialWith("") + setup + size + "\n}\n");
        EXPECT_EQ(folder.reload(), std::vector<std::string>());
        const auto preset = ShadowCameraSetupManager::getByName("Edited/Sun");
        EXPECT_EQ(preset->getSettings().at("map_size"), std::string(size) + " " + size);
    }
}

TEST_P(Reload, SaysWhereASetupIsWrong) {
    folder.write("edited.shadow", "shadow_camera_setup Edited/Wrong\n{\n    map_size none\n}\n");
    expectAll(folder.reload(), "edited.shadow(3)");
}

TEST_P(Reload, KeepsTheLastGoodMaterial) {
    for (const std::string& wrong :
         {materialWith("param_named scal float 0.5"), materialWith("param_named scale flot 0.5"),
          materialWith("param_named scale float 0.5") + "material Edited/Other\n{\n  colour 1\n}\n",
          materialWith("param_named scale float 0.5") + "material Edited/Other\n{\n"}) {
        folder.write("edited.material", wrong);
        expectAll(folder.reload(), "edited.material(");
        EXPECT_EQ(level(), 128) << wrong;
    }
    folder.write("edited.material", materialWith("param_named scale float 0.25"));
    EXPECT_TRUE(folder.reload().empty());
    EXPECT_EQ(level(), 32);
}

TEST_P(Reload, KeepsTheLastGoodProgram) {
    std::string wrong = programs();
    wrong.replace(wrong.find("float 1"), 7, "float 0.5\n        param_named scala float 1");
    folder.write("edited.program", wrong);
    expectAll(folder.reload(), "edited.program(");
    EXPECT_EQ(level(), 128);
    folder.write("edited.program", programs());
    EXPECT_TRUE(folder.reload().empty());
    wrong = programs();
    wrong.replace(wrong.find("edited.frag"), 11, "other.frag");
    folder.write("edited.program", wrong);
    expectAll(folder.reload(), "edited.program");
    EXPECT_EQ(level(), 128) << "its file is not there";
    folder.write("edited.program", programs());
    EXPECT_TRUE(folder.reload().empty());
    EXPECT_EQ(level(), 128);
}

TEST_P(Reload, ShowsAProgramThatWasBrokenFromTheStart) {
    std::string later = materialWith("");
    later.replace(later.find("Edited/FP"), 9, "Edited/LaterFP");
    folder.write("later.frag", "#version 330 core\nout vec4 fragColour;\nvoid main()\n{\n"
                               "    fragColour = vec4(0.25, 0.0, 0.0, 1.0);\n}\n");
    folder.write("edited.material", later);
    EXPECT_EQ(folder.reload(), std::vector<std::string>());
    EXPECT_EQ(level(), 64);
}

TEST_P(Reload, MayBeDoneAHundredTimes) {
    for (int i = 0; i < 100; ++i) {
        const bool wrong = i % 3 == 2;
        const bool dark = i % 2 == 0;
        folder.write("edited.glsl", levelOf(dark ? "0.25" : "0.5") + (wrong ? "}" : ""));
        folder.write("edited.material",
                     materialWith(dark ? "param_named scale float 0.5" : "") + (wrong ? "{" : ""));
        const int before = level();
        EXPECT_EQ(folder.reload().empty(), !wrong);
        EXPECT_EQ(level(), wrong ? before : dark ? 32 : 128) << i;
    }
}

TEST_P(Reload, LeavesTheApplicationsListenerInPlace) {
    Ogre::ScriptCompilerListener own;
    auto& compilers = Ogre::ScriptCompilerManager::getSingleton();
    compilers.setListener(&own);
    EXPECT_TRUE(folder.reload().empty());
    EXPECT_EQ(compilers.getListener(), &own);
    compilers.setListener(nullptr);
}

TEST_P(Reload, RefusesAGroupThatThereIsNot) {
    EXPECT_THROW(Lixel::reload("Nowhere"), Ogre::ItemIdentityException);
}

/// Lixel's own materials are drawn by scene managers that keep pointers into them.
TEST(ReloadOfLixels, ChangesNoPicture) {
    for (const auto technique : {AdditiveTechnique, IntegratedTechnique}) {
        const bool additive = technique == AdditiveTechnique;
        MaterialScene scene(technique, additive ? "Lixel/Receiver/Bilinear" : "");
        scene.wear(additive ? "Lixel/Surface" : "Lixel/Surface/Integrated/Maps3");
        const std::vector<int> before = scene.draw();
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(Lixel::reload(Ogre::RGN_DEFAULT), std::vector<std::string>());
            EXPECT_EQ(differing(before, scene.draw(), 0), 0.0);
        }
    }
}

} // namespace
} // namespace Lixel::Tests
