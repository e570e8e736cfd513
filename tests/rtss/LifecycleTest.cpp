// Beginning and end, twice and in each order, and wrong use.

#include "EditedFolder.h"
#include "ShaderSystemScene.h"

#include <OgrePlugin.h>

#include <functional>
#include <optional>
#include <string>

namespace Lixel::Tests {
namespace {

using Ogre::RTShader::ShaderGenerator;

std::string messageOf(const std::function<void()>& call) {
    try {
        call();
    } catch (const Ogre::Exception& exception) {
        return exception.getDescription();
    }
    return "nothing was thrown";
}

Ogre::Plugin* installed(const std::string& name) {
    for (Ogre::Plugin* plugin : Ogre::Root::getSingleton().getInstalledPlugins())
        if (plugin->getName() == name) return plugin;
    return nullptr;
}

class ShaderSystemLifecycle : public testing::Test {
protected:
    ShaderSystemLifecycle() {
        scene->addSun();
        scene->setMaps(3, 0, 0);
        lit = scene->draw();
        Lixel::ShaderSystem::enable(generator());
        shadowed = scene->draw();
    }

    ShaderGenerator& generator() { return scene->shaderSystem.generator; }

    /// Ends the generator, and makes another one, for which shadows are enabled again.
    /// @param between called while there is none
    /// @param check called with the other one, which ends after it
    void restart(const std::function<void()>& between,
                 const std::function<void(ShaderGenerator&)>& check) {
        generator().removeAllShaderBasedTechniques();
        ShaderGenerator::destroy();
        between();
        ASSERT_TRUE(ShaderGenerator::initialize());
        ShaderGenerator& again = ShaderGenerator::getSingleton();
        again.addSceneManager(&scene->manager());
        Lixel::ShaderSystem::enable(again);
        check(again);
        again.removeAllShaderBasedTechniques();
        ShaderGenerator::destroy();
    }

    std::optional<ShaderSystemScene> scene{std::in_place};
    Picture lit, shadowed;
};

TEST_F(ShaderSystemLifecycle, EnablingTwiceSetsTheOptions) {
    ASSERT_TRUE(isOther(shadowed, lit));
    // OGRE 14 has states of its own in each scheme.
    const auto count = [this] {
        return generator().getRenderState(StartedShaderSystem::Scheme)->getSubRenderStates().size();
    };
    const std::size_t once = count();
    Lixel::ShaderSystem::enable(generator());
    EXPECT_EQ(scene->draw(), shadowed);
    Lixel::ShaderSystem::enable(generator(), "", {.maps = 1});
    EXPECT_NE(scene->draw(), shadowed);
    Lixel::ShaderSystem::enable(generator(), "", {.maps = 3});
    EXPECT_EQ(scene->draw(), shadowed);
    EXPECT_EQ(count(), once);
}

/// The shader system has made techniques of those that a reload replaces.
TEST_F(ShaderSystemLifecycle, MaterialsMayBeReloaded) {
    const EditedFolder folder;
    const auto write = [&](const std::string& diffuse) {
        folder.write("edited.material", "material Edited/Plain\n{\n    technique\n    {\n"
                                        "        pass\n        {\n            diffuse " +
                                            diffuse + "\n        }\n    }\n}\n");
    };
    write("1 1 1");
    folder.parse();
    scene->wear("Edited/Plain");
    const Picture white = scene->draw();
    ASSERT_TRUE(isOther(white, lit));
    for (int i = 0; i < 3; ++i) {
        write("0.5 0.5 0.5");
        EXPECT_EQ(folder.reload(), std::vector<std::string>());
        EXPECT_TRUE(isOther(scene->draw(), white));
        write("1 1 1");
        EXPECT_EQ(folder.reload(), std::vector<std::string>());
        EXPECT_EQ(scene->draw(), white);
    }
}

TEST_F(ShaderSystemLifecycle, DisablingLeavesNothing) {
    Lixel::ShaderSystem::disable(generator());
    EXPECT_EQ(scene->draw(), lit);
    Lixel::ShaderSystem::disable(generator());
    EXPECT_EQ(scene->draw(), lit);
    Lixel::ShaderSystem::enable(generator());
    EXPECT_EQ(scene->draw(), shadowed);
}

TEST_F(ShaderSystemLifecycle, SchemesAreEnabledOneByOne) {
    generator().createScheme("mine");
    scene->stage.viewport().setMaterialScheme("mine");
    EXPECT_EQ(scene->drawAsItIs(), lit);
    Lixel::ShaderSystem::enable(generator(), "mine");
    EXPECT_EQ(scene->drawAsItIs(), shadowed);
    Lixel::ShaderSystem::disable(generator());
    EXPECT_EQ(scene->drawAsItIs(), shadowed);
    EXPECT_EQ(scene->draw(), lit);
}

TEST_F(ShaderSystemLifecycle, WrongArgumentsAreNamed) {
    EXPECT_EQ(messageOf([&] { Lixel::ShaderSystem::enable(generator(), "nine"); }),
              "scheme: the shader generator has none of the name 'nine'; it has "
              "ShaderGeneratorDefaultScheme, and ShaderGenerator::createScheme makes others");
    EXPECT_NE(messageOf([&] {
                  Lixel::ShaderSystem::disable(generator(), "nine");
              }).find("scheme: the shader generator has none of the name 'nine'"),
              std::string::npos);
    EXPECT_NE(messageOf([&] {
                  Lixel::ShaderSystem::enable(generator(), "", {.maps = 7});
              }).find("options.maps: 7 is too many; a program reads 1 to 6"),
              std::string::npos);
    EXPECT_EQ(scene->draw(), shadowed);
}

TEST_F(ShaderSystemLifecycle, OtherShadowTechniquesAreNamedInTheLog) {
    LogCollector log;
    scene->manager().setShadowTechnique(Ogre::SHADOWTYPE_NONE);
    EXPECT_EQ(scene->draw(), lit);
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
    scene->manager().setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE);
    scene->manager().setShadowTextureReceiverMaterial(
        Ogre::MaterialManager::getSingleton().getByName("Lixel/Receiver/Modulative"));
    scene->draw();
    scene->draw();
    EXPECT_EQ(log.count("only under an integrated shadow technique"), 1U) << log.all();
    scene->manager().setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    EXPECT_EQ(scene->draw(), shadowed);
}

TEST_F(ShaderSystemLifecycle, MissingProgramsAreNamedInTheLog) {
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    std::string folder;
    for (const Ogre::ResourceGroupManager::ResourceLocation& location :
         groups.getResourceLocationList(Ogre::RGN_DEFAULT))
        if (Ogre::StringUtil::endsWith(location.archive->getName(), "programs/glsl"))
            folder = location.archive->getName();
    ASSERT_NE(folder, "");
    groups.removeResourceLocation(folder);
    LogCollector log;
    generator().invalidateScheme(StartedShaderSystem::Scheme);
    EXPECT_EQ(scene->draw(), lit);
    EXPECT_EQ(log.count("the shader system's materials are not shadowed by Lixel's maps: there is "
                        "no LixelShaderSystem.glsl; add Lixel's folder materials/programs/glsl to "
                        "the resource group General"),
              1U)
        << log.all();
}

TEST_F(ShaderSystemLifecycle, ShuttingDownFirstLeavesProgramsWithoutShadows) {
    ShaderSystemScene::addMaterial("Test/Own", R"(
        rtshader_system
        {
            lixel_shadows maps auto
        })");
    ShaderSystemScene::addMaterial("Test/Unseen", R"(
        rtshader_system
        {
            lixel_shadows maps 2
        })");
    scene->wear("Test/Own");
    EXPECT_EQ(scene->draw(), shadowed);
    Lixel::ShaderSystem::shutdown();
    EXPECT_EQ(generator().getSubRenderStateFactory("Lixel_Shadows"), nullptr);
    EXPECT_EQ(scene->draw(), lit);
    Lixel::ShaderSystem::shutdown();
    EXPECT_EQ(scene->draw(), lit);
    Lixel::ShaderSystem::enable(generator());
    EXPECT_EQ(scene->draw(), shadowed);
}

TEST_F(ShaderSystemLifecycle, TheGeneratorMayGoFirstAndComeAgain) {
    scene->stage.viewport().setMaterialScheme("");
    Ogre::MaterialManager::getSingleton().removeListener(&scene->shaderSystem);
    restart(
        [] {
            Lixel::ShaderSystem::shutdown();
            Lixel::ShaderSystem::shutdown();
        },
        [](ShaderGenerator& again) {
            EXPECT_NE(again.getSubRenderStateFactory("Lixel_Shadows"), nullptr);
        });
}

TEST_F(ShaderSystemLifecycle, TheGeneratorMayBeMadeAnewWithoutShutdown) {
    restart([] {}, [this](ShaderGenerator&) { EXPECT_EQ(scene->draw(), shadowed); });
}

TEST_F(ShaderSystemLifecycle, ThePluginMayGoFirst) {
    scene->stage.root().uninstallPlugin(installed("Lixel"));
    scene->draw();
}

TEST_F(ShaderSystemLifecycle, SceneManagersMayGoFirst) {
    Ogre::SceneManager* const other = scene->stage.root().createSceneManager();
    scene->draw();
    scene->stage.root().destroySceneManager(other);
    EXPECT_EQ(scene->draw(), shadowed);
}

/// As an application that ends the generator, then Root, and shuts this library down last or never.
TEST_F(ShaderSystemLifecycle, RootMayGoBeforeShutdown) {
    scene->shutsDown = false;
    scene.reset();
    Lixel::ShaderSystem::shutdown();
}

} // namespace
} // namespace Lixel::Tests
