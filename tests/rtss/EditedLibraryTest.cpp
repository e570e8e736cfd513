// Shaders that the shader system's programs include, edited while these draw.

#include "EditedFolder.h"
#include "ShaderSystemScene.h"

#include <Lixel/scene/OgreVersions.h>

#include <RTShaderSystem/OgreShaderFFPRenderState.h>
#include <RTShaderSystem/OgreShaderFunction.h>
#include <RTShaderSystem/OgreShaderProgram.h>
#include <RTShaderSystem/OgreShaderProgramSet.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace Lixel::Tests {
namespace {

using namespace Ogre::RTShader;

const char* const Library = "LixelShaderSystem.glsl";
const char* const Included = "LixelShadow.glsl";

std::size_t programCount() {
    std::size_t count = 0;
    for (const auto& [handle, resource] : programManager().getResourceIterator())
        count += resource ? 1 : 0;
    return count;
}

/// A scene whose programs include copies of Lixel's files.
class ShaderSystemEdited : public testing::Test {
protected:
    ShaderSystemEdited() : files("ShaderSystemEdited") {
        auto& groups = Ogre::ResourceGroupManager::getSingleton();
        std::string folder;
        for (const auto& location : groups.getResourceLocationList(Ogre::RGN_DEFAULT))
            if (Ogre::StringUtil::endsWith(location.archive->getName(), "programs/glsl"))
                folder = location.archive->getName();
        for (const auto& file : std::filesystem::directory_iterator(folder)) {
            std::stringstream text;
            text << std::ifstream(file.path()).rdbuf();
            texts[file.path().filename()] = text.str();
            files.write(file.path().filename(), text.str());
        }
        groups.removeResourceLocation(folder);
        groups.addResourceLocation(files.path().string(), "FileSystem", Ogre::RGN_DEFAULT);
        scene.addSun();
        scene.setMaps(3, 0, 0);
        lit = scene.draw();
        Lixel::ShaderSystem::enable(scene.shaderSystem.generator);
        shadowed = scene.draw();
        EXPECT_TRUE(isOther(shadowed, lit));
    }

    /// A file as it is in Lixel's folder, with one text in place of another.
    void edit(const std::string& file, const std::string& from, const std::string& to) {
        std::string text = texts.at(file);
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        files.write(file, text.replace(at, from.size(), to));
    }
    void editLibrary(const std::string& to) {
        edit(Library, "visibility = lixelVisibilityIn(",
             "visibility = " + to + "lixelVisibilityIn(");
    }
    void putBack(const std::string& file) { files.write(file, texts.at(file)); }

    static std::vector<std::string> reload() { return Lixel::reload(Ogre::RGN_DEFAULT); }
    static void expectError(const std::string& file) {
        LogCollector log;
        std::vector<std::string> errors = reload();
        // Lixel's own programs include some of its files, too.
        std::erase_if(errors, [](const std::string& error) {
            return error.find("programs of OGRE's shader system: ") != 0;
        });
        ASSERT_EQ(errors.size(), 1U);
        EXPECT_NE(errors[0].find(file), std::string::npos) << errors[0];
        EXPECT_EQ(log.count(errors[0]), 1U) << log.all();
    }

    EditedFolder files; ///< as long as OGRE has it
    ShaderSystemScene scene;
    std::map<std::string, std::string> texts; ///< of Lixel's files
    Picture lit, shadowed;
};

TEST_F(ShaderSystemEdited, ShowsWhatProgramsInclude) {
    editLibrary("1.0 + ");
    EXPECT_EQ(scene.draw(), shadowed) << "nothing was read yet";
    EXPECT_EQ(reload(), std::vector<std::string>());
    EXPECT_TRUE(isOther(scene.draw(), shadowed)) << "twice the light where there is some";
    putBack(Library);
    EXPECT_EQ(reload(), std::vector<std::string>());
    EXPECT_EQ(scene.draw(), shadowed);
    // What an included file includes. (Where OpenGL can tell that the map is not read, Lixel's own
    // programs lack its parameter.)
    edit(Included, "if (!(coordinate.z > 0.0)", "if (coordinate.z < 1e30 || !(coordinate.z > 0.0)");
    EXPECT_EQ(reload(), std::vector<std::string>());
    EXPECT_TRUE(isSame(scene.draw(), lit));
    EXPECT_EQ(reload(), std::vector<std::string>());
    EXPECT_TRUE(isSame(scene.draw(), lit));
}

TEST_F(ShaderSystemEdited, KeepsTheLastGoodPrograms) {
    editLibrary("1.0 + ");
    EXPECT_EQ(reload(), std::vector<std::string>());
    const Picture bright = scene.draw();
    for (int i = 0; i < 2; ++i) {
        editLibrary("1.0 +* ");
        expectError(Library);
        EXPECT_EQ(scene.draw(), bright);
    }
    // A function that programs call has another name: the file alone is right.
    edit(Library, "void Lixel_Receiver(", "void Lixel_Receives(");
    expectError(Library);
    EXPECT_EQ(scene.draw(), bright);
    putBack(Library);
    files.remove(Included);
    expectError(Library);
    EXPECT_EQ(scene.draw(), bright);
    putBack(Included);
    EXPECT_EQ(reload(), std::vector<std::string>());
    EXPECT_EQ(scene.draw(), shadowed);
}

TEST_F(ShaderSystemEdited, LeavesProgramsAloneWhereNothingTheyIncludeChanged) {
    const auto& material =
        *Ogre::MaterialManager::getSingleton().getByName(ShaderSystemScene::Plain);
    const Ogre::Technique* const made = material.getTechnique(1);
    ASSERT_EQ(made->getSchemeName(), StartedShaderSystem::Scheme);
    const Ogre::String program = made->getPass(0)->getFragmentProgramName();
    files.write("LixelUnrelated.glsl", "wrong");
    EXPECT_EQ(reload(), std::vector<std::string>());
    scene.draw();
    EXPECT_EQ(material.getTechnique(1)->getPass(0)->getFragmentProgramName(), program);
    // Nor by a reload of another group, though it was edited.
    editLibrary("1.0 + ");
    Ogre::ResourceGroupManager::getSingleton().createResourceGroup("Other");
    EXPECT_EQ(Lixel::reload("Other"), std::vector<std::string>());
    EXPECT_EQ(scene.draw(), shadowed);
}

TEST_F(ShaderSystemEdited, WaitsForASceneManager) {
    ShaderGenerator& generator = scene.shaderSystem.generator;
    generator.removeSceneManager(&scene.manager());
    editLibrary("1.0 + ");
    expectError("LixelShaderSystem.glsl was edited, and no scene manager draws");
    generator.addSceneManager(&scene.manager());
    EXPECT_EQ(scene.draw(), shadowed);
    EXPECT_EQ(reload(), std::vector<std::string>());
    EXPECT_TRUE(isOther(scene.draw(), shadowed));
}

/// With materials of one and of several programs, some of them shared.
TEST_F(ShaderSystemEdited, MayBeDoneAHundredTimes) {
    ShaderSystemScene::addMaterial("Test/Same", "");
    ShaderSystemScene::addMaterial("Test/Glossy", "specular 0.5 0.5 0.5 20");
    scene.wear("Test/Glossy");
    scene.draw();
    static_cast<Ogre::Entity&>(*scene.ground->getAttachedObject(0)).setMaterialName("Test/Same");
    scene.draw();
    editLibrary("1.0 + ");
    EXPECT_EQ(reload(), std::vector<std::string>());
    const Picture bright = scene.draw();
    putBack(Library);
    EXPECT_EQ(reload(), std::vector<std::string>());
    const Picture normal = scene.draw();
    ASSERT_TRUE(isOther(bright, normal));
    const std::size_t programs = programCount();
    for (int i = 0; i < 100; ++i) {
        const bool wrong = i % 3 == 2;
        const bool makeBright = i % 2 == 0;
        editLibrary(std::string(makeBright ? "1.0 + " : "") + (wrong ? "* " : ""));
        const Picture before = scene.draw();
        EXPECT_EQ(reload().empty(), !wrong);
        EXPECT_EQ(scene.draw(), wrong ? before : makeBright ? bright : normal) << i;
        EXPECT_EQ(programCount(), programs) << i;
    }
}

/// A part of programs beside Lixel's, from a file of the application's.
class TintState : public SubRenderState {
public:
    static const Ogre::String Name;
    const Ogre::String& getType() const override { return Name; }
    int getExecutionOrder() const override { return FFP_FOG + 1; }
    void copyFrom(const SubRenderState&) override {}
    bool createCpuSubPrograms(ProgramSet* programs) override {
        Program& pixel = *programs->getCpuProgram(Ogre::GPT_FRAGMENT_PROGRAM);
        pixel.addDependency("Tint");
        Function& main = *pixel.getMain();
        main.getStage(FFP_PS_COLOUR_END + 50)
            .callFunction("Tint",
                          {InOut(main.resolveOutputParameter(Parameter::SPC_COLOR_DIFFUSE))});
        return true;
    }
};
const Ogre::String TintState::Name = "Tests_Tint";

class TintFactory : public SubRenderStateFactory {
public:
    const Ogre::String& getType() const override { return TintState::Name; }

protected:
    SubRenderState* createInstanceImpl() override { return OGRE_NEW TintState; }
};

TEST_F(ShaderSystemEdited, ShowsWhatPartsOfOthersInclude) {
    const auto tint = [this](const std::string& factor) {
        files.write("Tint.glsl",
                    "void Tint(inout vec4 colour)\n{\n    colour *= " + factor + ";\n}\n");
    };
    ShaderGenerator& generator = scene.shaderSystem.generator;
    TintFactory factory;
    generator.addSubRenderStateFactory(&factory);
    tint("1.0");
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    groups.removeResourceLocation(files.path().string()); // OGRE looks for files when it is added
    groups.addResourceLocation(files.path().string(), "FileSystem", Ogre::RGN_DEFAULT);
    generator.getRenderState(StartedShaderSystem::Scheme)
        ->addTemplateSubRenderState(generator.createSubRenderState(TintState::Name));
    generator.invalidateScheme(StartedShaderSystem::Scheme);
    EXPECT_EQ(scene.draw(), shadowed);
    tint("0.5");
    EXPECT_EQ(reload(), std::vector<std::string>());
    const Picture dark = scene.draw();
    EXPECT_TRUE(isOther(dark, shadowed));
    tint("");
    expectError("Tint.glsl");
    EXPECT_EQ(scene.draw(), dark);
    generator.removeAllShaderBasedTechniques();
    RenderState& scheme = *generator.getRenderState(StartedShaderSystem::Scheme);
    const auto states = scheme.getSubRenderStates();
    for (SubRenderState* state : states)
        if (state->getType() == TintState::Name) scheme.removeSubRenderState(state);
    generator.removeSubRenderStateFactory(&factory);
}

} // namespace
} // namespace Lixel::Tests
