// What the log says of materials that read fewer maps than their light has.

#include "MaterialScene.h"

#include <Lixel/setup/ShadowCameraSetups.h>

namespace Lixel::Tests {
namespace {

constexpr std::size_t Slices = 3;
constexpr std::size_t Faces = 6;

/// A sun with three slices and a lamp with six faces; no other light.
class FewMaps : public testing::Test {
protected:
    FewMaps() {
        Ogre::SceneManager& manager = scene.stage.sceneManager();
        manager.setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, Slices);
        manager.setShadowTextureCountPerLightType(Ogre::Light::LT_POINT, Faces);
        manager.setShadowTextureSettings(256, Slices + Faces, Ogre::PF_FLOAT32_R);
        scene.lights[1]->setVisible(false);
        scene.lights[0]->setCustomShadowCameraSetup(CascadesShadowCameraSetup::create());
        Ogre::Light& lamp = *scene.lights[2];
        lamp.setType(Ogre::Light::LT_POINT);
        lamp.getParentSceneNode()->setPosition(2, 3, 2);
        lamp.setCustomShadowCameraSetup(OptimalShadowCameraSetup::create());
        // Something on every side of it.
        for (const Ogre::Vector3& ws :
             {Ogre::Vector3(-6, 3, 2), Ogre::Vector3(9, 3, 2), Ogre::Vector3(2, 3, -6)}) {
            scene.addCube(ws, Ogre::Vector3(1, 1, 1));
        }
    }

    /// A few frames with every object in this material.
    void draw(const std::string& material) {
        Ogre::SceneManager& manager = scene.stage.sceneManager();
        for (const auto& [name, object] : manager.getMovableObjects("Entity"))
            static_cast<Ogre::Entity*>(object)->setMaterialName(material);
        scene.draw();
        scene.draw();
    }

    MaterialScene scene{Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, ""};
    LogCollector log;
};

TEST_F(FewMaps, AreNamedOncePerLight) {
    draw("Lixel/Surface/Integrated");
    EXPECT_EQ(log.count("material 'Lixel/Surface/Integrated' reads 1 shadow map of light '" +
                        scene.lights[0]->getName() +
                        "', which has 3: shadows in the others are missing; take "
                        "Lixel/Surface/Integrated/Maps3"),
              1U)
        << log.all();
    EXPECT_EQ(log.count("reads 1 shadow map of light 'spot', which has 6: shadows in the others "
                        "are missing; take Lixel/Surface/Integrated/Maps6"),
              1U)
        << log.all();
    EXPECT_EQ(log.count("Lixel:"), 2U) << log.all();
}

TEST_F(FewMaps, AreCountedInAProgramForSeveral) {
    draw("Lixel/Surface/Integrated/Maps3");
    EXPECT_EQ(log.count("reads 3 shadow maps of light 'spot', which has 6"), 1U) << log.all();
    EXPECT_EQ(log.count("Lixel:"), 1U) << log.all();
}

TEST_F(FewMaps, AreCountedUnderOtherNames) {
    draw("Test/OneMapOfOtherNames");
    EXPECT_EQ(log.count("material 'Test/OneMapOfOtherNames' reads 1 shadow map of light"), 2U)
        << log.all();
    EXPECT_EQ(log.count("Lixel:"), 2U) << log.all();
}

TEST_F(FewMaps, AreNoNewsWhereAllAreRead) {
    draw("Lixel/Surface/Integrated/Maps6");
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
}

TEST_F(FewMaps, AreNoNewsOfForeignMaterials) {
    draw("Test/Pssm");
    EXPECT_EQ(log.count("reads"), 0U) << log.all();
}

TEST_F(FewMaps, AreNoNewsWhereNoShadowsAreWanted) {
    Ogre::MaterialManager::getSingleton()
        .getByName("Lixel/Surface/Integrated")
        ->setReceiveShadows(false);
    draw("Lixel/Surface/Integrated");
    Ogre::MaterialManager::getSingleton()
        .getByName("Lixel/Surface/Integrated")
        ->setReceiveShadows(true);
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
}

TEST_F(FewMaps, AreNoNewsWhereOneIsAllThereIs) {
    // Three textures for a setup that makes one map, and six for a lamp that casts none.
    scene.lights[0]->setCustomShadowCameraSetup(OptimalShadowCameraSetup::create());
    scene.lights[2]->setCastShadows(false);
    draw("Lixel/Surface/Integrated");
    EXPECT_EQ(log.count("reads"), 0U) << log.all();
}

TEST_F(FewMaps, OfASetupAreNamedWhereItsSunHasMore) {
    const std::string said = "light 'Light' has 3 shadow textures, and its setup fills ";
    const auto cascades = CascadesShadowCameraSetup::create();
    cascades->setOptions({.vsSplitDepths = {15.0}});
    scene.lights[0]->setCustomShadowCameraSetup(cascades);
    draw("Lixel/Surface/Integrated/Maps6");
    EXPECT_EQ(log.count(said + "2"), 1U) << log.all();
    scene.lights[0]->setCustomShadowCameraSetup(OptimalShadowCameraSetup::create());
    draw("Lixel/Surface/Integrated/Maps6");
    EXPECT_EQ(log.count(said + "1"), 1U) << log.all();
    EXPECT_EQ(log.count("Lixel:"), 2U) << "none of the lamp: " << log.all();
}

TEST_F(FewMaps, OfASunThatIsToBeDividedAreNamed) {
    scene.stage.sceneManager().setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, 1);
    draw("Lixel/Surface/Integrated/Maps6");
    EXPECT_EQ(log.count("light 'Light' has one shadow texture, and a setup that divides it among "
                        "several"),
              1U)
        << log.all();
    EXPECT_EQ(log.count("Lixel:"), 1U) << log.all();
}

TEST_F(FewMaps, OfASetupAreNoNewsBesideAnotherSun) {
    // OGRE counts textures for all suns alike.
    scene.lights[1]->setVisible(true);
    scene.stage.sceneManager().setShadowTextureSettings(256, 2 * Slices + Faces,
                                                        Ogre::PF_FLOAT32_R);
    draw("Lixel/Surface/Integrated/Maps6");
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
}

} // namespace
} // namespace Lixel::Tests
