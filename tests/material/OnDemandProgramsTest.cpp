// When Lixel's programs are compiled; in all else they are what OGRE's GLSL programs are.

#include "EditedFolder.h"
#include "FreshOgre.h"
#include "MaterialScene.h"
#include "PlainVertex.h"

#include <Lixel/material/OnDemandPrograms.h>
#include <Lixel/scene/OgreVersions.h>

#include <OgreScriptCompiler.h>

#include <map>
#include <set>

namespace Lixel::Tests {
namespace {

using Names = std::set<std::string>;

/// Lixel's programs, by their names.
std::map<std::string, Ogre::HighLevelGpuProgramPtr> lixelsPrograms() {
    std::map<std::string, Ogre::HighLevelGpuProgramPtr> programs;
    for (const auto& [handle, resource] : programManager().getResourceIterator())
        if (resource->getName().starts_with("Lixel/"))
            programs[resource->getName()] =
                std::static_pointer_cast<Ogre::HighLevelGpuProgram>(resource);
    return programs;
}

Names compiledPrograms() {
    Names names;
    for (const auto& [name, program] : lixelsPrograms())
        if (isCompiled(*program)) names.insert(name);
    return names;
}

#if LIXEL_UNIFORMS_BY_TEXT

TEST(OnDemandPrograms, AreNotCompiledByScripts) {
    FreshOgre ogre;
    ogre.readScripts();
    EXPECT_GE(lixelsPrograms().size(), 16U);
    for (const auto& [name, program] : lixelsPrograms())
        EXPECT_EQ(program->getLanguage(), "lixel_glsl") << name;
    EXPECT_EQ(compiledPrograms(), Names());
}

TEST(OnDemandPrograms, AreCompiledWhereAPresetDrawsWithThem) {
    FreshOgre ogre;
    ogre.readScripts();
    ogre.drawCube("Lixel/Sun", "Lixel/Surface/Integrated/Maps3");
    EXPECT_EQ(compiledPrograms(), Names({"Lixel/AmbientFP", "Lixel/CasterFP", "Lixel/CasterVP",
                                         "Lixel/ReceiverFP/Maps3", "Lixel/SurfaceVP"}));
}

/// Parameters are read by where the compiled program has them.
TEST(OnDemandPrograms, HaveTheUniformsOfGlslPrograms) {
    FreshOgre ogre;
    ogre.readScripts();
    for (const auto& [name, program] : lixelsPrograms()) {
        const Ogre::GpuNamedConstants uniforms =
            program->createParameters()->getConstantDefinitions();
        ASSERT_FALSE(isCompiled(*program));
        const auto glsl = std::static_pointer_cast<Ogre::HighLevelGpuProgram>(
            createProgram(name + "/Glsl", program->getGroup(), "glsl", program->getType()));
        glsl->setSourceFile(program->getSourceFile());
        glsl->setPreprocessorDefines(program->getPreprocessorDefines());
        glsl->load();
        ASSERT_FALSE(glsl->hasCompileError()) << name;
        const Ogre::GpuNamedConstants& expected = glsl->getConstantDefinitions();
        EXPECT_EQ(uniforms.floatBufferSize, expected.floatBufferSize) << name;
        EXPECT_EQ(uniforms.intBufferSize, expected.intBufferSize) << name;
        EXPECT_EQ(uniforms.map.size(), expected.map.size()) << name;
        EXPECT_FALSE(expected.map.empty()) << name;
        for (const auto& [uniform, definition] : expected.map) {
            const auto found = uniforms.map.find(uniform);
            ASSERT_NE(found, uniforms.map.end()) << name << ": " << uniform;
            EXPECT_EQ(found->second.constType, definition.constType) << name << ": " << uniform;
            EXPECT_EQ(found->second.physicalIndex, definition.physicalIndex)
                << name << ": " << uniform;
            EXPECT_EQ(found->second.elementSize, definition.elementSize) << name << ": " << uniform;
            EXPECT_EQ(found->second.arraySize, definition.arraySize) << name << ": " << uniform;
        }
    }
}

/// OGRE notes how often an automatic uniform changes in the record that the render system reads.
TEST(OnDemandPrograms, ShareTheirUniformsWithWhatIsDrawn) {
    FreshOgre ogre;
    ogre.readScripts();
    ogre.drawCube("Lixel/Sun", "Lixel/Surface/Integrated/Maps3");
    const Ogre::HighLevelGpuProgramPtr program = lixelsPrograms().at("Lixel/SurfaceVP");
    const Ogre::GpuNamedConstants& bound = program->_getBindingDelegate()->getConstantDefinitions();
    EXPECT_EQ(&program->createParameters()->getConstantDefinitions(), &bound);
    EXPECT_EQ(bound.map.at("worldViewProj").variability, Ogre::GPV_PER_OBJECT);
}

/// There OpenGL has to be asked for uniforms.
TEST(OnDemandPrograms, AreCompiledByScriptsWithSeparateShaderObjects) {
    std::vector<std::uint8_t> together;
    {
        FreshOgre ogre;
        ogre.readScripts();
        ogre.drawCube("Lixel/Sun", "Lixel/Surface/Integrated/Maps3");
        together = ogre.picture();
    }
    FreshOgre ogre({.separateShaders = true});
    ogre.readScripts();
    EXPECT_EQ(compiledPrograms().size(), lixelsPrograms().size());
    ogre.drawCube("Lixel/Sun", "Lixel/Surface/Integrated/Maps3");
    EXPECT_EQ(ogre.picture(), together);
}

#endif

TEST(OnDemandPrograms, ArePlainGlslWithoutThePlugin) {
    FreshOgre ogre({.hasPlugin = false});
    const LogCollector log("");
    ogre.readScripts();
    EXPECT_GE(lixelsPrograms().size(), 16U);
    for (const auto& [name, program] : lixelsPrograms()) {
        EXPECT_EQ(program->getLanguage(), "glsl") << name;
        EXPECT_TRUE(program->isSupported()) << name;
    }
    EXPECT_EQ(compiledPrograms().size(), lixelsPrograms().size());
    EXPECT_EQ(log.count("lixel_glsl"), 0U) << log.all();
}

std::string flatFragment(const std::string& red) {
    return "#version 330 core\nout vec4 fragColour;\nvoid main()\n{\n    fragColour = vec4(" + red +
           ", 0.0, 0.0, 1.0);\n}\n";
}

std::string program(const std::string& kind, const std::string& name, const std::string& lines) {
    return kind + "_program " + name + " lixel_glsl glsl\n{\n" + lines + "}\n";
}

std::string technique(const std::string& fragment) {
    return "technique\n{\npass\n{\nvertex_program_ref Demand/VP\n{\n}\nfragment_program_ref " +
           fragment + "\n{\n}\n}\n}\n";
}

/// Scripts of an application whose programs are compiled on demand.
class DemandedPrograms : public testing::Test {
protected:
    DemandedPrograms() : scene(IntegratedTechnique, ""), folder("Demand") {
        scene.wear("Lixel/Surface/Integrated");
        folder.write("flat.vert", PlainVertex);
        folder.write("half.frag", flatFragment("0.5"));
        folder.write("wrong.glsl", "float level()\n{\n    return 0.5 + nothing;\n}\n");
        folder.write("wrong.frag",
                     "#version 330 core\n#include \"wrong.glsl\"\nout vec4 fragColour;"
                     "\nvoid main()\n{\n    fragColour = vec4(level());\n}\n");
        folder.write(
            "demand.program",
            program("vertex", "Demand/VP",
                    "source flat.vert\ndefault_params\n{\n"
                    "param_named_auto worldViewProj worldviewproj_matrix\n}\n") +
                program("fragment", "Demand/HalfFP", "source half.frag\ndefault_params\n{\n}\n") +
                program("fragment", "Demand/WrongFP", "source wrong.frag\ndefault_params\n{\n}\n") +
                program("fragment", "Demand/MissingFP",
                        "source missing.frag\ndefault_params\n{\n}\n"));
        folder.write("demand.material",
                     "material Demand/Half\n{\n" + technique("Demand/HalfFP") + "}\n" +
                         "material Demand/Wrong\n{\n" + technique("Demand/WrongFP") +
                         technique("Demand/HalfFP") + "}\n" + "material Demand/Missing\n{\n" +
                         technique("Demand/MissingFP") + technique("Demand/HalfFP") + "}\n");
    }

    int levelOf(const std::string& material) {
        static_cast<Ogre::Entity&>(*scene.ground->getAttachedObject(0))
            .setMaterialName(material, "Demand");
        return scene.draw()[scene.pixelOf(Ogre::Vector3(4, 0, 4))];
    }

    MaterialScene scene;
    EditedFolder folder;
};

TEST_F(DemandedPrograms, SayWhatIsWrongWhenTheyAreLoaded) {
    LogCollector log("wrong.frag");
    folder.parse();
#if LIXEL_UNIFORMS_BY_TEXT
    EXPECT_EQ(log.count(""), 0U) << log.all();
#endif
    const Ogre::MaterialPtr material =
        Ogre::MaterialManager::getSingleton().getByName("Demand/Wrong", "Demand");
    // As scene managers do with casters and receivers: what cannot be drawn is known at once.
    material->load();
    EXPECT_EQ(material->getBestTechnique(), material->getTechnique(1));
    EXPECT_EQ(material->getSupportedTechniques().size(), 1U);
    EXPECT_NE(material->getUnsupportedTechniquesExplanation().find("compile error"),
              std::string::npos);
    EXPECT_EQ(levelOf("Demand/Wrong"), 128);
    EXPECT_EQ(log.count("`nothing' undeclared"), 1U) << log.all();
    EXPECT_EQ(log.count("Demand/WrongFP"), 1U) << log.all();
    EXPECT_EQ(log.count("3(15)"), 1U) << "line and column: " << log.all();
}

/// Loads a material when a script makes another one.
struct EagerListener : Ogre::ScriptCompilerListener {
    explicit EagerListener(Ogre::Material& material) : eager(material) {
        Ogre::ScriptCompilerManager::getSingleton().setListener(this);
    }
    ~EagerListener() override { Ogre::ScriptCompilerManager::getSingleton().setListener(nullptr); }
    bool handleEvent(Ogre::ScriptCompiler*, Ogre::ScriptCompilerEvent* event, void*) override {
        if (event->mType == Ogre::CreateMaterialScriptCompilerEvent::eventType) eager.load();
        return false;
    }
    Ogre::Material& eager;
};

/// There nobody can tell a material that is loaded from a script that names parameters.
TEST_F(DemandedPrograms, FailWellWhileAScriptIsRead) {
    folder.parse();
    const Ogre::MaterialPtr wrong =
        Ogre::MaterialManager::getSingleton().getByName("Demand/Wrong", "Demand");
    EXPECT_FALSE(wrong->isLoaded());
    {
        const EagerListener listener(*wrong);
        EditedFolder other("Other");
        other.write("other.material", "material Demand/Other\n{\n}\n");
        other.parse();
    }
    EXPECT_TRUE(wrong->isLoaded());
    EXPECT_EQ(levelOf("Demand/Wrong"), 128) << "by its other technique";
}

TEST_F(DemandedPrograms, SayWhichFileIsMissing) {
    LogCollector log("missing.frag");
    folder.parse();
    EXPECT_GE(log.count("Demand/MissingFP"), 1U) << log.all();
    EXPECT_EQ(levelOf("Demand/Missing"), 128);
}

TEST_F(DemandedPrograms, MayBeLoadedWithoutAMaterial) {
    folder.parse();
    const Ogre::GpuProgramPtr half =
        Ogre::GpuProgramManager::getSingleton().getByName("Demand/HalfFP", "Demand");
    const Ogre::GpuProgramPtr wrong =
        Ogre::GpuProgramManager::getSingleton().getByName("Demand/WrongFP", "Demand");
    half->load();
    wrong->load();
    EXPECT_TRUE(isCompiled(*half));
    EXPECT_TRUE(half->isLoaded());
    EXPECT_FALSE(isCompiled(*wrong));
    EXPECT_TRUE(wrong->hasCompileError());
    half->unload();
    EXPECT_FALSE(isCompiled(*half));
    EXPECT_EQ(levelOf("Demand/Half"), 128);
}

#if LIXEL_UNIFORMS_BY_TEXT

/// What nothing has worn yet is read as it is on disk when something does.
TEST_F(DemandedPrograms, AreReadAgainBeforeTheyAreUsed) {
    folder.parse();
    folder.write("half.frag", "#version 330 core\nuniform float more;\nuniform float red;\n"
                              "out vec4 fragColour;\nvoid main()\n{\n"
                              "    fragColour = vec4(red + more, 0.0, 0.0, 1.0);\n}\n");
    folder.write(
        "demand.program",
        program("vertex", "Demand/VP",
                "source flat.vert\ndefault_params\n{\n"
                "param_named_auto worldViewProj worldviewproj_matrix\n}\n") +
            program("fragment", "Demand/HalfFP",
                    "source half.frag\ndefault_params\n{\nparam_named red float 0.25\n"
                    "param_named more float 0\n}\n") +
            program("fragment", "Demand/WrongFP", "source wrong.frag\ndefault_params\n{\n}\n"));
    EXPECT_EQ(folder.reload(), std::vector<std::string>());
    EXPECT_EQ(levelOf("Demand/Half"), 64);
}

#endif

} // namespace
} // namespace Lixel::Tests
