// What a material says beside its shadows: normal maps, specular light, fog, colours of vertices.

#include "ShaderSystemScene.h"

#include <cmath>

namespace Lixel::Tests {
namespace {

/// What a lit picture becomes under a visibility, which two other pictures of the same scene show.
/// Where these are too dark to show it, what it became.
Picture shadowedAs(const Picture& lit, const Picture& otherShadowed, const Picture& otherLit,
                   const Picture& became) {
    constexpr int Dark = 60;
    Picture shadowed = became;
    for (std::size_t i = 0; i < lit.size(); ++i)
        if (otherLit[i] > Dark)
            shadowed[i] = static_cast<std::uint8_t>(
                std::lround(lit[i] * static_cast<double>(otherShadowed[i]) / otherLit[i]));
    return shadowed;
}

class ShaderSystemMaterials : public testing::Test {
protected:
    ShaderSystemMaterials() {
        sun.setDiffuseColour(0.9F, 0.9F, 0.9F);
        scene.setMaps(3, 0, 0);
        Lixel::ShaderSystem::enable(generator());
        plainShadowed = scene.draw();
        plainLit = drawLit();
    }

    Ogre::RTShader::ShaderGenerator& generator() { return scene.shaderSystem.generator; }

    Picture drawLit() {
        sun.setCastShadows(false);
        Picture picture = scene.draw();
        sun.setCastShadows(true);
        return picture;
    }

    /// Shadows fall on the material where they fall on the plain one.
    void expectShadows(const std::string& name) {
        const Picture shadowed = scene.draw();
        scene.keepPicture(name);
        const Picture lit = drawLit();
        EXPECT_TRUE(isOther(lit, plainLit)) << "the material is as the plain one";
        EXPECT_TRUE(isOther(shadowed, lit)) << "nothing is in shadow";
        EXPECT_TRUE(isSame(shadowed, shadowedAs(lit, plainShadowed, plainLit, shadowed)));
    }

    ShaderSystemScene scene;
    Ogre::Light& sun = scene.addSun();
    Picture plainShadowed, plainLit;
};

TEST_F(ShaderSystemMaterials, KeepVertexColoursAndTextures) {
    // A gradient, without a file.
    Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().createManual(
        "Test/Texture", Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, 16, 16, 0, Ogre::PF_BYTE_RGBA);
    std::vector<Ogre::uint8> texels(16 * 16 * 4);
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = i % 4 == 3 ? 255 : static_cast<Ogre::uint8>(80 + i % 160);
    texture->getBuffer()->blitFromMemory(
        Ogre::PixelBox(16, 16, 1, Ogre::PF_BYTE_RGBA, texels.data()));
    ShaderSystemScene::parse(
        "material Test/Coloured { technique { pass { diffuse 1 0.4 0.2; texture_unit { texture "
        "Test/Texture } } } }");
    scene.wear("Test/Coloured");
    expectShadows("coloured");
}

TEST_F(ShaderSystemMaterials, KeepNormalMaps) {
    Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().createManual(
        "Test/Normals", Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, 8, 8, 0, Ogre::PF_BYTE_RGB);
    std::vector<Ogre::uint8> texels;
    for (int i = 0; i < 8 * 8; ++i) // steps to both sides
        for (const int component : {i % 8 < 4 ? 90 : 166, 128, 240})
            texels.push_back(static_cast<Ogre::uint8>(component));
    texture->getBuffer()->blitFromMemory(Ogre::PixelBox(8, 8, 1, Ogre::PF_BYTE_RGB, texels.data()));
    for (const auto& [name, object] : scene.manager().getMovableObjects("Entity"))
        static_cast<Ogre::Entity*>(object)->getMesh()->buildTangentVectors();
    ShaderSystemScene::parse(
        "material Test/Bumpy { technique { pass { rtshader_system { lighting_stage normal_map "
        "Test/Normals tangent_space } } } }");
    scene.wear("Test/Bumpy");
    expectShadows("normal-map");
}

TEST_F(ShaderSystemMaterials, KeepSpecularLightOutOfShadows) {
    ShaderSystemScene::parse(
        "material Test/Shiny { technique { pass { diffuse 0.3 0.3 0.3; specular 1 1 1 5 } } }");
    sun.getParentSceneNode()->setDirection(Ogre::Vector3(-0.2F, -1, 1), Ogre::Node::TS_WORLD);
    plainShadowed = scene.draw();
    plainLit = drawLit();
    scene.wear("Test/Shiny");
    expectShadows("specular");
}

TEST_F(ShaderSystemMaterials, KeepColoursOfVertices) {
    ShaderSystemScene::parse(
        "material Test/Tracking { technique { pass { diffuse vertexcolour } } }");
    Ogre::ManualObject& wall = *scene.manager().createManualObject("wall");
    wall.begin(ShaderSystemScene::Plain, Ogre::RenderOperation::OT_TRIANGLE_LIST);
    for (const Ogre::Vector3& corner :
         {Ogre::Vector3(-9, 0.01F, 5), Ogre::Vector3(9, 0.01F, 5), Ogre::Vector3(9, 0.01F, -7),
          Ogre::Vector3(-9, 0.01F, -7)}) {
        wall.position(corner);
        wall.normal(Ogre::Vector3::UNIT_Y);
        wall.colour(corner.x > 0 ? 1.0F : 0.3F, corner.z > 0 ? 1.0F : 0.5F, 0.6F);
    }
    wall.quad(0, 1, 2, 3);
    wall.end();
    scene.manager().getRootSceneNode()->createChildSceneNode()->attachObject(&wall);
    wall.setCastShadows(false);
    plainShadowed = scene.draw();
    plainLit = drawLit();
    wall.setMaterialName(0, "Test/Tracking");
    expectShadows("vertex-colours");
}

TEST_F(ShaderSystemMaterials, KeepFog) {
    scene.manager().setFog(Ogre::FOG_LINEAR, Ogre::ColourValue::Black, 0, 5, 600);
    expectShadows("fog");
}

TEST_F(ShaderSystemMaterials, ThatReceiveNoShadowsOrAreUnlitAreLeftAlone) {
    ShaderSystemScene::parse(
        "material Test/Off { receive_shadows off; technique { pass { diffuse 0.5 0.9 0.5 } } } "
        "material Test/Unlit { technique { pass { lighting off } } }");
    // A slab in the box's shadow receives, so that there are maps.
    scene.addCube(Ogre::Vector3(-2, 0.01F, 1), Ogre::Vector3(1.5F, 0.02F, 0.8F));
    scene.wear(ShaderSystemScene::Plain);
    auto& ground = *static_cast<Ogre::Entity*>(scene.ground->getAttachedObject(0));
    const std::size_t inShadow = scene.redOf(Ogre::Vector3(-2, 0, 0.2F));
    ASSERT_LT(plainShadowed[inShadow], 10);
    for (const char* material : {"Test/Off", "Test/Unlit"}) {
        LogCollector log;
        ground.setMaterialName(material);
        const Picture drawn = scene.draw();
        const Picture lit = drawLit();
        EXPECT_GT(drawn[inShadow], 50) << material;
        EXPECT_EQ(drawn[inShadow], lit[inShadow]) << material;
        EXPECT_TRUE(differenceOf(drawn, lit).percent > 0) << "there are no maps";
        EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
    }
}

/// Light that is summed up per vertex has no shadows that a pixel could see.
TEST_F(ShaderSystemMaterials, LitPerVertexAreNamedInTheLog) {
    LogCollector log;
    ShaderSystemScene::parse(
        "material Test/PerVertex { technique { pass { rtshader_system { lighting_stage ffp } } } "
        "}");
    scene.wear("Test/PerVertex");
    const Picture drawn = scene.draw();
    scene.draw();
    EXPECT_TRUE(isSame(drawn, drawLit()));
    EXPECT_EQ(log.count("nothing casts shadows on material 'Test/PerVertex', which is lit per "
                        "vertex"),
              1U)
        << log.all();
}

TEST_F(ShaderSystemMaterials, DrawnOnceForEachLightAreNamedInTheLog) {
    LogCollector log;
    ShaderSystemScene::parse(
        "material Test/Iterating { technique { pass { iteration once_per_light directional } } }");
    scene.wear("Test/Iterating");
    const Picture drawn = scene.draw();
    EXPECT_TRUE(isSame(drawn, drawLit()));
    EXPECT_EQ(log.count("material 'Test/Iterating', which has a pass that is drawn once for each"),
              1U)
        << log.all();
}

TEST_F(ShaderSystemMaterials, WithoutRoomForAllMapsAreNamedInTheLog) {
    LogCollector log;
    std::string script = "material Test/Full { technique { pass {";
    for (int unit = 0; unit < 14; ++unit)
        script += " texture_unit { texture Test/OneTexel }";
    Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().createManual(
        "Test/OneTexel", Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, 1, 1, 0, Ogre::PF_BYTE_RGBA);
    Ogre::uint32 white = 0xFFFFFFFF;
    texture->getBuffer()->blitFromMemory(Ogre::PixelBox(1, 1, 1, Ogre::PF_BYTE_RGBA, &white));
    ShaderSystemScene::parse(script + " } } }");
    scene.wear("Test/Full");
    scene.draw();
    scene.keepPicture("no-room");
    EXPECT_EQ(log.count("material 'Test/Full' has 14 textures, which leaves units for 2 of 3 "
                        "shadow maps"),
              1U)
        << log.all();
}

} // namespace
} // namespace Lixel::Tests
