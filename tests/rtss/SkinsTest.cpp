// What vertex programs bend by bones: lit, shadowed, and casting shadows.

#include "PlacedScene.h"

namespace Lixel::Tests {
namespace {

class ShaderSystemSkins : public ShaderSystemPlaced, public testing::WithParamInterface<int> {};

/// Reference: software skinning.
TEST_P(ShaderSystemSkins, ThatProgramsBendReceiveAndCastShadows) {
    Ogre::Entity& post = addPost(GetParam());
    Ogre::MaterialManager::getSingleton().create("Test/Skin", Ogre::RGN_DEFAULT);
    skin(post, "Test/Skin");
    LogCollector log;
    scene.draw();
    const Picture bent = scene.draw();
    scene.keepPicture("skinned-" + std::to_string(GetParam()));
    EXPECT_TRUE(isBentByProgram(post)) << "OGRE bends it: nothing was tested";
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
    const Picture reference = scene.drawLixels();
    scene.keepPicture("skinned-reference-" + std::to_string(GetParam()));
    EXPECT_TRUE(isSame(bent, reference));
}

INSTANTIATE_TEST_SUITE_P(Weights, ShaderSystemSkins, testing::Values(1, 2, 4));

/// OGRE lends Lixel/Caster the textures of one object after the other.
TEST_F(ShaderSystemPlaced, SkinsCastWholeShadowsAfterAlphaTestedCasters) {
    addHoles("Test/Nothing", {0, 0}); // Lixel/Caster reads no texture of one texel
    for (const auto& [name, object] : scene.manager().getMovableObjects("Entity"))
        if (object->getCastShadows())
            static_cast<Ogre::Entity*>(object)->setMaterialName("Test/Nothing");
    Ogre::Entity& post = addPost(2);
    scene.draw();
    const Picture reference = scene.draw();
    scene.keepPicture("skinned-after-alpha-tested-reference");
    post.setCastShadows(false);
    EXPECT_TRUE(isOther(scene.draw(), reference)) << "its shadow";
    const auto& last = *Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster");
    ASSERT_GT(last.getTechnique(0)->getPass(0)->getNumTextureUnitStates(), 0U);
    Ogre::MaterialManager::getSingleton().create("Test/Skin", Ogre::RGN_DEFAULT);
    skin(post, "Test/Skin");
    scene.draw();
    post.setCastShadows(true);
    scene.draw();
    const Picture drawn = scene.draw();
    scene.keepPicture("skinned-after-alpha-tested");
    EXPECT_TRUE(isBentByProgram(post)) << "OGRE bends it: nothing was tested";
    EXPECT_TRUE(isSame(drawn, reference));
}

/// Reference: software skinning, for which OGRE lends Lixel/Caster the texture and the culling.
TEST_F(ShaderSystemPlaced, AlphaTestedSkinsCastShadowsWithHoles) {
    const std::vector<std::uint8_t> stripes{0, 255, 255, 0, 255, 0, 0, 255};
    Ogre::Entity& post = addPost(2);
    scene.draw();
    const Picture whole = scene.draw();
    addHoles("Test/Striped", stripes);
    post.setMaterialName("Test/Striped");
    scene.draw();
    const Picture reference = scene.draw();
    scene.keepPicture("skinned-alpha-tested-reference");
    EXPECT_TRUE(isOther(reference, whole));
    addHoles("Test/StripedSkin", stripes);
    skin(post, "Test/StripedSkin");
    LogCollector log;
    scene.draw();
    const Picture drawn = scene.draw();
    scene.keepPicture("skinned-alpha-tested");
    EXPECT_TRUE(isBentByProgram(post)) << "OGRE bends it: nothing was tested";
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
    // Where a stripe ends, a pixel may be on either side.
    EXPECT_LT(differenceOf(drawn, reference).percent, 0.02);
}

} // namespace
} // namespace Lixel::Tests
