// `lixel_shadows` in a material's script.

#include "ShaderSystemScene.h"

namespace Lixel::Tests {
namespace {

class ShaderSystemScript : public testing::Test {
protected:
    ShaderSystemScript() {
        scene.addSun();
        scene.setMaps(3, 0, 0);
        lit = scene.draw();
    }

    /// Draws with a material whose pass has this in its rtshader_system.
    Picture drawWith(const std::string& line) {
        const std::string name = "Test/Script" + std::to_string(mCount++);
        ShaderSystemScene::addMaterial(name, "rtshader_system\n{\n" + line + "\n}");
        scene.wear(name);
        return scene.draw();
    }

    bool isLogged(const std::string& text) const { return log.count(text) > 0; }

    ShaderSystemScene scene;
    Picture lit;
    LogCollector log{""};

private:
    int mCount = 0;
};

TEST_F(ShaderSystemScript, ShadowsItsPassAlone) {
    Lixel::ShaderSystem::install(scene.shaderSystem.generator);
    const Picture drawn = drawWith("lixel_shadows maps auto");
    scene.keepPicture("script");
    EXPECT_TRUE(isSame(drawn, scene.drawLixels()));
    EXPECT_TRUE(isSame(drawWith("lixel_shadows maps 3"), drawn));
    EXPECT_TRUE(isSame(drawWith("lighting_stage per_pixel\nlixel_shadows maps auto"), drawn));
    EXPECT_FALSE(isLogged("invalid")) << log.all();
    scene.wear(ShaderSystemScene::Plain);
    EXPECT_TRUE(isSame(scene.draw(), lit));
}

TEST_F(ShaderSystemScript, CountsMoreThanTheScheme) {
    Lixel::ShaderSystem::enable(scene.shaderSystem.generator);
    const Picture all = scene.draw();
    // What the two other maps show in shadow is lit.
    const Picture one = drawWith("lixel_shadows maps 1");
    EXPECT_NE(one, all);
    EXPECT_TRUE(isLogged("reads 1 shadow map of light 'sun', which has 3")) << log.all();
    scene.wear(ShaderSystemScene::Plain);
    EXPECT_EQ(scene.draw(), all);
}

TEST_F(ShaderSystemScript, NamesWhatItTakesWhereItIsWrong) {
    Lixel::ShaderSystem::install(scene.shaderSystem.generator);
    const std::string known = "; it takes `maps auto`, or `maps` and a number from 1 to 6";
    EXPECT_TRUE(isSame(drawWith("lixel_shadows map 3"), lit));
    EXPECT_TRUE(isLogged("lixel_shadows: there is no 'map'" + known)) << log.all();
    for (const char* wrong : {"0", "7", "-1", "33", "three"}) {
        EXPECT_TRUE(isSame(drawWith(std::string("lixel_shadows maps ") + wrong), lit));
        EXPECT_TRUE(isLogged(std::string("lixel_shadows: maps cannot be '") + wrong + "'" + known))
            << log.all();
    }
    EXPECT_TRUE(isSame(drawWith("lixel_shadows maps"), lit));
    EXPECT_TRUE(isLogged("lixel_shadows: 'maps' has no value" + known)) << log.all();
}

TEST_F(ShaderSystemScript, IsUnknownBeforeInstall) {
    EXPECT_TRUE(isSame(drawWith("lixel_shadows maps auto"), lit));
    EXPECT_TRUE(isLogged("invalid parameters")) << log.all();
}

/// OGRE drops words that stand alone before anything else sees them. The check of materials finds
/// that the shadows are missing.
TEST_F(ShaderSystemScript, WithoutParametersIsNamedInTheLog) {
    Lixel::ShaderSystem::install(scene.shaderSystem.generator);
    EXPECT_TRUE(isSame(drawWith("lixel_shadows"), lit));
    EXPECT_TRUE(isLogged("reads no shadow map, so nothing casts shadows on it")) << log.all();
}

/// With a value in any case, since OGRE drops a line without one when it reads it again.
TEST_F(ShaderSystemScript, IsWrittenByTheSerializer) {
    Lixel::ShaderSystem::install(scene.shaderSystem.generator);
    for (const std::string line : {"lixel_shadows maps 3", "lixel_shadows maps auto"}) {
        drawWith(line);
        Ogre::MaterialSerializer serializer;
        serializer.addListener(scene.shaderSystem.generator.getMaterialSerializerListener());
        serializer.queueForExport(static_cast<Ogre::Entity*>(scene.box->getAttachedObject(0))
                                      ->getSubEntity(0)
                                      ->getMaterial());
        EXPECT_NE(serializer.getQueuedAsString().find(line + '\n'), std::string::npos)
            << serializer.getQueuedAsString();
    }
}

} // namespace
} // namespace Lixel::Tests
