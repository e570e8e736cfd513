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

TEST_F(ShaderSystemMaterials, KeepDiffuseColoursAndTextures) {
    std::vector<std::uint8_t> gradient(16 * 16 * 4);
    for (std::size_t i = 0; i < gradient.size(); ++i)
        gradient[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(80 + i % 160);
    ShaderSystemScene::addTexture("Test/Texture", gradient);
    ShaderSystemScene::addMaterial("Test/Coloured", R"(
        diffuse 1 0.4 0.2
        texture_unit
        {
            texture Test/Texture
        })");
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
    ShaderSystemScene::addMaterial("Test/Bumpy", R"(
        rtshader_system
        {
            lighting_stage normal_map Test/Normals tangent_space
        })");
    scene.wear("Test/Bumpy");
    expectShadows("normal-map");
}

TEST_F(ShaderSystemMaterials, KeepSpecularLightOutOfShadows) {
    ShaderSystemScene::addMaterial("Test/Shiny", R"(
        diffuse 0.3 0.3 0.3
        specular 1 1 1 5)");
    sun.getParentSceneNode()->setDirection(Ogre::Vector3(-0.2F, -1, 1), Ogre::Node::TS_WORLD);
    plainShadowed = scene.draw();
    plainLit = drawLit();
    scene.wear("Test/Shiny");
    expectShadows("specular");
}

TEST_F(ShaderSystemMaterials, KeepColoursOfVertices) {
    ShaderSystemScene::addMaterial("Test/Tracking", "diffuse vertexcolour");
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
    ShaderSystemScene::parse(R"(
        material Test/Off
        {
            receive_shadows off
            technique
            {
                pass
                {
                    diffuse 0.5 0.9 0.5
                }
            }
        }
        material Test/Unlit
        {
            technique
            {
                pass
                {
                    lighting off
                }
            }
        })");
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
    ShaderSystemScene::addMaterial("Test/PerVertex", R"(
        rtshader_system
        {
            lighting_stage ffp
        })");
    scene.wear("Test/PerVertex");
    const Picture drawn = scene.draw();
    scene.draw();
    EXPECT_TRUE(isSame(drawn, drawLit()));
    EXPECT_EQ(log.count("nothing casts shadows on material 'Test/PerVertex', which is lit per "
                        "vertex"),
              1U)
        << log.all();
    EXPECT_EQ(log.count("Lixel:"), 1U) << log.all();
}

TEST_F(ShaderSystemMaterials, DrawnOnceForEachLightAreNamedInTheLog) {
    LogCollector log;
    ShaderSystemScene::addMaterial("Test/Iterating", "iteration once_per_light directional");
    scene.wear("Test/Iterating");
    const Picture drawn = scene.draw();
    EXPECT_TRUE(isSame(drawn, drawLit()));
    EXPECT_EQ(log.count("material 'Test/Iterating', which has a pass that is drawn once for each"),
              1U)
        << log.all();
}

TEST_F(ShaderSystemMaterials, WithoutRoomForAllMapsAreNamedInTheLog) {
    LogCollector log;
    ShaderSystemScene::addTexture("Test/OneTexel", {255, 255, 255, 255});
    const auto full = Ogre::MaterialManager::getSingleton().create("Test/Full", Ogre::RGN_DEFAULT);
    for (int unit = 0; unit < 14; ++unit)
        full->getTechnique(0)->getPass(0)->createTextureUnitState("Test/OneTexel");
    scene.wear("Test/Full");
    scene.draw();
    scene.keepPicture("no-room");
    EXPECT_EQ(log.count("material 'Test/Full' has 14 textures, which leaves units for 2 of 3 "
                        "shadow maps: shadows in the remaining maps are missing"),
              1U)
        << log.all();
}

/// OGRE deals the maps out to units of that kind one after the other: Lixel's would have others.
TEST_F(ShaderSystemMaterials, WithShadowUnitsOfTheirOwnAreNamedInTheLog) {
    ShaderSystemScene::addMaterial("Test/OwnUnit", R"(
        texture_unit
        {
            content_type shadow
        })");
    LogCollector log;
    scene.wear("Test/OwnUnit");
    scene.draw();
    scene.draw();
    EXPECT_EQ(
        log.count("no light of a Lixel setup shadows material 'Test/OwnUnit', which has texture "
                  "units of content_type shadow already"),
        1U)
        << log.all();
}

/// Its lights are arrays. OGRE 13 cannot dim one of them; OGRE 14 can.
TEST_F(ShaderSystemMaterials, OfMetalAndRoughnessAreShadowedOrNamedInTheLog) {
    if (generator().getSubRenderStateFactory("CookTorranceLighting") == nullptr)
        GTEST_SKIP() << "there is no metal_roughness in this OGRE";
    ShaderSystemScene::addMaterial("Test/Metal", R"(
        specular 0.5 0.2 0 0
        rtshader_system
        {
            lighting_stage metal_roughness
        })");
    LogCollector log;
    scene.wear("Test/Metal");
    const Picture drawn = scene.draw();
    const bool isDimmed = OGRE_VERSION_MAJOR >= 14;
    EXPECT_EQ(log.count("material 'Test/Metal', which is lit by `lighting_stage metal_roughness`"),
              isDimmed ? 0U : 1U)
        << log.all();
    if (isDimmed)
        EXPECT_TRUE(isOther(drawn, drawLit())) << "nothing is in shadow";
    else
        EXPECT_TRUE(isSame(drawn, drawLit()));
}

} // namespace
} // namespace Lixel::Tests
