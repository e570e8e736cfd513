// Presets beside one another, and beside lights that an application configures by hand.

#include "PresetScene.h"

#include <Lixel/setup/ShadowCameraSetups.h>

namespace Lixel::Tests {
namespace {

std::size_t mapsOf(Ogre::SceneManager& manager, Ogre::Light::LightTypes type) {
    return manager.getShadowTextureCountPerLightType(type);
}

TEST(PresetAgreement, GivesALightTheMapsOfOthersOfItsType) {
    UnshadowedScene scene("Lixel/Surface/Integrated/Maps6");
    const EditedScript script("shadow_camera_setup One\n{\ntechnique Uniform\n}\n"
                              "shadow_camera_setup Six\n{\ntechnique Uniform\nmaps 6\n}\n");
    Ogre::Light &one = *scene.lights[0], &other = *scene.lights[1];
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    apply("One", one);
    EXPECT_EQ(mapsOf(manager, Ogre::Light::LT_DIRECTIONAL), 1U);
    const std::vector<int> alone = scene.draw();
    for (const char* const name : {"Lixel/Sun", "Six"}) {
        EXPECT_EQ(refusalOf(name, other), "");
        EXPECT_EQ(mapsOf(manager, Ogre::Light::LT_DIRECTIONAL),
                  std::string(name) == "Six" ? 6U : 3U);
        EXPECT_EQ(differing(scene.draw(), alone, 0), 0.0) << "maps to spare change no picture";
    }
    EXPECT_EQ(refusalOf("Lixel/Sun", one).substr(0, 21), "maps: 'Six' says 6 an");
}

TEST(PresetAgreement, RefusesSeveralMapsOfAllLightsThatOgreDoesNotRead) {
    UnshadowedScene scene("Lixel/Surface");
    const EditedScript script("shadow_camera_setup A\n{\ntechnique Cascades\n"
                              "shadow_technique texture_additive\n}\n");
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    const Ogre::ShadowCameraSetupPtr before = manager.getShadowCameraSetup();
    try {
        ShadowCameraSetupManager::getByName("A")->applyTo(manager);
        FAIL();
    } catch (const Ogre::Exception& exception) {
        EXPECT_NE(exception.getDescription().find("texture_additive; 'A' has 3, as Cascades have"),
                  std::string::npos)
            << exception.getDescription();
    }
    EXPECT_EQ(manager.getShadowCameraSetup(), before);
    EXPECT_EQ(manager.getShadowTechnique(), Ogre::SHADOWTYPE_NONE);
}

TEST(PresetAgreement, LeavesTexturesToLightsThatAreConfiguredByHand) {
    UnshadowedScene scene("Lixel/Surface/Integrated");
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    Ogre::Light &sun = *scene.lights[0], &other = *scene.lights[1], &spot = *scene.lights[2];
    manager.setShadowCameraSetup(Ogre::DefaultShadowCameraSetup::create());
    manager.setShadowTextureCountPerLightType(Ogre::Light::LT_SPOTLIGHT, 2);
    for (Ogre::Light* const light : {&other, &spot}) {
        light->setVisible(true);
        light->setCastShadows(true);
        light->setCustomShadowCameraSetup(UniformShadowCameraSetup::create());
    }
    apply("Lixel/Small", sun);
    EXPECT_EQ(mapsOf(manager, Ogre::Light::LT_SPOTLIGHT), 2U);
    EXPECT_EQ(manager.getShadowTextureConfigList().size(), 4U);
    // Every light casts shadows unless it is told not to: without a setup it gets no textures.
    other.setCustomShadowCameraSetup({});
    spot.setCastShadows(false);
    manager.setShadowTextureCount(1);
    apply("Lixel/Small", sun);
    EXPECT_EQ(manager.getShadowTextureConfigList().size(), 1U);
    // But it keeps those that are there, and all have them where the scene manager has a setup.
    manager.setShadowTextureCount(2);
    apply("Lixel/Small", sun);
    EXPECT_EQ(manager.getShadowTextureConfigList().size(), 2U);
    manager.setShadowTextureCount(1);
    manager.setShadowCameraSetup(UniformShadowCameraSetup::create());
    apply("Lixel/Small", sun);
    EXPECT_EQ(manager.getShadowTextureConfigList().size(), 2U);
}

TEST(PresetAgreement, NeedsNoCasterWhereItSaysNone) {
    UnshadowedScene scene("Lixel/Surface/Integrated");
    const EditedScript script("shadow_camera_setup A\n{\ncaster_material none\n}\n"
                              "shadow_camera_setup B\n{\n}\n");
    auto& materials = Ogre::MaterialManager::getSingleton();
    const Ogre::MaterialPtr caster = materials.getByName("Lixel/Caster");
    ASSERT_TRUE(caster);
    materials.remove(caster);
    EXPECT_EQ(refusalOf("A", *scene.lights[0]), "");
    scene.lights[0]->setCustomShadowCameraSetup({});
    EXPECT_NE(refusalOf("B", *scene.lights[0]), "");
}

/// Two groups outside of the global pool have a preset of one name.
TEST(PresetAgreement, FollowsTheGroupThatAPresetIsOf) {
    UnshadowedScene scene("Lixel/Surface/Integrated");
    const std::string coarse = "shadow_camera_setup A\n{\nmap_size 32\n}\n";
    const EditedScript first(coarse, "GroupA", false);
    const EditedScript second("shadow_camera_setup A\n{\nmap_size 512\n}\n", "GroupB", false);
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    const auto side = [&] { return manager.getShadowTextureConfigList()[0].width; };
    for (const char* const group : {"GroupA", "GroupB"}) {
        ShadowCameraSetupManager::getByName("A", group)->applyTo(*scene.lights[0]);
        const auto before = side();
        EXPECT_EQ(before, std::string(group) == "GroupA" ? 32U : 512U);
        EXPECT_EQ(first.edit(coarse), 0U);
        EXPECT_EQ(side(), before) << group;
    }
}

TEST(PresetAgreement, ChangesNoSceneManagerWhereAnotherRefuses) {
    UnshadowedScene scene("Lixel/Surface/Integrated");
    const std::string rest = "}\nshadow_camera_setup B\n{\nmap_size 64\n}\n";
    const EditedScript script("shadow_camera_setup A\n{\n" + rest);
    Ogre::SceneManager* const other = Ogre::Root::getSingleton().createSceneManager();
    Ogre::Light &light = *scene.lights[0], &one = *other->createLight(),
                &two = *other->createLight();
    light.setShadowFarDistance(50);
    one.setShadowFarDistance(60);
    apply("A", light);
    apply("A", one);
    apply("B", two);
    // Whichever scene manager is first: none has taken the distance over.
    EXPECT_EQ(script.edit("shadow_camera_setup A\n{\nfar_distance 7\nmap_size 32\n" + rest), 1U);
    EXPECT_EQ(light.getShadowFarDistance(), 50);
    EXPECT_EQ(one.getShadowFarDistance(), 60);
    EXPECT_EQ(scene.stage.sceneManager().getShadowTextureConfigList()[0].width, 1024U);
    EXPECT_EQ(script.edit("shadow_camera_setup A\n{\nfar_distance 7\n" + rest), 0U);
    EXPECT_EQ(light.getShadowFarDistance(), 7);
    EXPECT_EQ(one.getShadowFarDistance(), 7);
}

} // namespace
} // namespace Lixel::Tests
