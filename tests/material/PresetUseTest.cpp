// Presets of scripts in a scene: what they draw, and what they refuse.

#include "PresetScene.h"

#include <Lixel/material/ShadowMaterials.h>
#include <Lixel/setup/ShadowCameraSetups.h>

namespace Lixel::Tests {
namespace {

TEST(Presets, DrawWhatCallsDraw) {
    std::vector<int> called;
    {
        UnshadowedScene scene("Lixel/Surface/Integrated/Maps3");
        Ogre::SceneManager& manager = scene.stage.sceneManager();
        Ogre::Light& sun = *scene.lights.front();
        manager.setShadowTechnique(IntegratedTechnique);
        manager.setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, 3);
        manager.setShadowTextureSettings(1024, 3, Ogre::PF_FLOAT32_R);
        manager.setShadowTextureSelfShadow(true);
        setShadowMaterials(manager);
        sun.setCastShadows(true);
        sun.setCustomShadowCameraSetup(CascadesShadowCameraSetup::create());
        called = scene.draw();
    }
    UnshadowedScene scene("Lixel/Surface/Integrated/Maps3");
    const std::vector<int> unshadowed = scene.draw();
    EXPECT_GT(differing(called, unshadowed), 0.5);
    apply("Lixel/Sun", *scene.lights.front());
    EXPECT_EQ(differing(scene.draw(), called, 0), 0.0);
    scene.keepPicture("preset-sun");
}

TEST(Presets, AreOneLineForEveryKindOfLight) {
    for (const char* const name :
         {"Lixel/Sun", "Lixel/Landscape", "Lixel/Small", "Lixel/Spot", "Lixel/Point"}) {
        UnshadowedScene scene("Lixel/Surface/Integrated/Maps6");
        Ogre::Light& light = *scene.lights.front();
        if (std::string(name) == "Lixel/Spot" || std::string(name) == "Lixel/Point") {
            light.setType(std::string(name) == "Lixel/Spot" ? Ogre::Light::LT_SPOTLIGHT
                                                            : Ogre::Light::LT_POINT);
            light.setSpotlightRange(Ogre::Degree(60), Ogre::Degree(70));
            light.getParentSceneNode()->setPosition(4, 4, 0);
        }
        const std::vector<int> unshadowed = scene.draw();
        LogCollector log;
        apply(name, light);
        const std::vector<int> shadowed = scene.draw();
        scene.keepPicture("preset-" + std::string(name).substr(6));
        EXPECT_GT(differing(shadowed, unshadowed), 0.5) << name;
        EXPECT_GT(shadowed[scene.pixelOf(Ogre::Vector3(1.5F, 0, 2))], 20) << name;
        EXPECT_EQ(shadowed[scene.pixelOf(Ogre::Vector3(-1.5F, 0, 0))], 0) << name;
        EXPECT_EQ(log.count("Lixel:"), 0U) << name << ": " << log.all();
    }
}

TEST(Presets, MayBeASceneManagers) {
    UnshadowedScene scene("Lixel/Surface/Integrated");
    for (Ogre::Light* light : scene.lights) {
        light->setVisible(true);
        light->setCastShadows(true);
    }
    ShadowCameraSetupManager::getByName("Lixel/Small")->applyTo(scene.stage.sceneManager());
    EXPECT_EQ(scene.stage.sceneManager().getShadowTextureConfigList().size(), 3U);
    const std::vector<int> all = scene.draw();
    EXPECT_EQ(scene.stage.sceneManager().getShadowCameraSetup(),
              ShadowCameraSetupManager::getByName("Lixel/Small")->getSetup());
    // In the shadow of two of three.
    EXPECT_LT(all[scene.pixelOf(Ogre::Vector3(-1.5F, 0, 0))],
              all[scene.pixelOf(Ogre::Vector3(4, 0, 4))]);
}

TEST(Presets, OfDifferentLightsStandTogether) {
    UnshadowedScene scene("Lixel/Surface/Integrated/Maps6");
    Ogre::Light& spot = *scene.lights[2];
    spot.setVisible(true);
    apply("Lixel/Sun", *scene.lights.front());
    apply("Lixel/Spot", spot);
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    EXPECT_EQ(manager.getShadowTextureConfigList().size(), 4U);
    EXPECT_EQ(manager.getShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL), 3U);
    EXPECT_EQ(manager.getShadowTextureCountPerLightType(Ogre::Light::LT_SPOTLIGHT), 1U);
    LogCollector log;
    const std::vector<int> together = scene.draw();
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
    scene.lights.front()->setVisible(false);
    const std::vector<int> spotAlone = scene.draw();
    scene.lights.front()->setVisible(true);
    spot.setVisible(false);
    const std::vector<int> sunAlone = scene.draw();
    std::vector<int> sum(sunAlone.size());
    for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] = std::min(255, sunAlone[i] + spotAlone[i]);
    EXPECT_EQ(differing(together, sum, 2), 0.0);
}

TEST(Presets, ThatContradictOneAnotherAreRefused) {
    UnshadowedScene scene("Lixel/Surface/Integrated/Maps6");
    const EditedScript script("shadow_camera_setup A\n{\nmap_size 256\nmaps 1\n}\n"
                              "shadow_camera_setup B\n{\nmap_size 512\n}\n"
                              "shadow_camera_setup C\n{\ntechnique Cascades\n}\n"
                              "shadow_camera_setup D\n{\nshadow_technique texture_additive\n"
                              "maps 2\n}\n"
                              "shadow_camera_setup E\n{\ncaster_material My/Missing\n}\n");
    Ogre::Light &one = *scene.lights[0], &other = *scene.lights[1];
    EXPECT_EQ(refusalOf("A", one), "");
    EXPECT_EQ(refusalOf("B", other),
              "map_size: 'A' says 256 256 and 'B', which is used in the same scene, says 512 512; "
              "OGRE has one for all of a scene manager");
    EXPECT_FALSE(other.getCustomShadowCameraSetup());
    EXPECT_FALSE(other.getCastShadows());
    EXPECT_EQ(refusalOf("C", other),
              "maps: 'A' says 1 and 'C', which is used in the same scene, says 3; OGRE has one for "
              "all lights of a type");
    EXPECT_EQ(refusalOf("C", *scene.lights[2]), "") << "a light of another type";
    EXPECT_EQ(
        refusalOf("E", other),
        "caster: there is no material 'My/Missing'; Lixel's are Lixel/Caster (caster_material "
        "is said by: E; receiver_material by: nobody)");
    // In place of what the light has, it may say otherwise.
    EXPECT_EQ(refusalOf("B", one), "");
    EXPECT_EQ(refusalOf("D", other).substr(0, 30), "maps: OGRE reads several maps ")
        << "B does not say how many";
    other.setVisible(false);
    scene.lights[2]->setCustomShadowCameraSetup({});
    one.setCustomShadowCameraSetup({});
    EXPECT_EQ(refusalOf("D", one),
              "maps: OGRE reads several maps of a light only under an integrated shadow_technique, "
              "and this is texture_additive; 'D' has 2")
        << "those that were taken off no longer count";
    EXPECT_EQ(refusalOf("C", *scene.stage.sceneManager().createLight()), "");
}

TEST(Presets, FollowTheirScript) {
    UnshadowedScene scene("Lixel/Surface/Integrated");
    const std::vector<int> unshadowed = scene.draw();
    const EditedScript script("shadow_camera_setup A\n{\ntechnique Uniform\nmap_size 512\n}\n");
    Ogre::Light& sun = *scene.lights.front();
    apply("A", sun);
    const std::vector<int> fine = scene.draw();
    EXPECT_GT(differing(fine, unshadowed), 0.5);

    EXPECT_EQ(script.edit("shadow_camera_setup A\n{\ntechnique XPSM\nmap_size 32\n}\n"), 0U);
    EXPECT_TRUE(std::dynamic_pointer_cast<XPSMShadowCameraSetup>(sun.getCustomShadowCameraSetup()));
    const std::vector<int> coarse = scene.draw();
    EXPECT_GT(differing(coarse, fine), 0.0);
    EXPECT_GT(differing(coarse, unshadowed), 0.5);

    EXPECT_EQ(script.edit("shadow_camera_setup A\n{\ntechnique XPSM\nmap_size 0\n}\n"), 1U);
    EXPECT_EQ(differing(scene.draw(), coarse, 0), 0.0) << "an error keeps what was right";

    EXPECT_EQ(script.edit("shadow_camera_setup A\n{\ntechnique Uniform\nmap_size 512\n}\n"), 0U);
    EXPECT_EQ(differing(scene.draw(), fine, 0), 0.0);

    // What an application takes off stays off.
    sun.setCastShadows(false);
    EXPECT_EQ(script.edit("shadow_camera_setup A\n{\ntechnique XPSM\nmap_size 512\n}\n"), 0U);
    EXPECT_FALSE(sun.getCastShadows());
    sun.setCastShadows(true);
    sun.setCustomShadowCameraSetup(XPSMShadowCameraSetup::create());
    EXPECT_EQ(script.edit("shadow_camera_setup A\n{\ntechnique Uniform\nmap_size 32\n}\n"), 0U);
    EXPECT_TRUE(std::dynamic_pointer_cast<XPSMShadowCameraSetup>(sun.getCustomShadowCameraSetup()));
    EXPECT_EQ(scene.stage.sceneManager().getShadowTextureConfigList()[0].width, 512U);
}

TEST(Presets, AreThereAfterTheirGroupWasReadAnew) {
    UnshadowedScene scene("Lixel/Surface/Integrated");
    const EditedScript script("shadow_camera_setup A\n{\ntechnique Uniform\n}\n");
    apply("A", *scene.lights.front());
    const std::vector<int> before = scene.draw();
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    groups.clearResourceGroup(EditedGroup);
    EXPECT_EQ(differing(scene.draw(), before, 0), 0.0);
    script.write("shadow_camera_setup A\n{\ntechnique Uniform\nmap_size 32\n}\n");
    groups.initialiseResourceGroup(EditedGroup);
    EXPECT_EQ(differing(scene.draw(), before, 0), 0.0);
    EXPECT_EQ(ShadowCameraSetupManager::getSingleton().reload(EditedGroup).size(), 0U);
    EXPECT_GT(differing(scene.draw(), before), 0.0);
}

TEST(Presets, ThatContradictOneAnotherAfterAnEditStayAsTheyWere) {
    UnshadowedScene scene("Lixel/Surface/Integrated");
    const EditedScript script("shadow_camera_setup A\n{\nmap_size 64\n}\n"
                              "shadow_camera_setup B\n{\nmap_size 64\n}\n");
    apply("A", *scene.lights[0]);
    apply("B", *scene.lights[2]);
    const std::vector<int> before = scene.draw();
    LogCollector log;
    EXPECT_EQ(script.edit("shadow_camera_setup A\n{\nmap_size 64\n}\n"
                          "shadow_camera_setup B\n{\nmap_size 512\n}\n"),
              1U);
    EXPECT_EQ(log.count("all shadow_camera_setups stay as they were: in scene manager"), 1U)
        << log.all();
    EXPECT_EQ(ShadowCameraSetupManager::getByName("B")->getSetting("map_size"), "64 64");
    EXPECT_EQ(differing(scene.draw(), before, 0), 0.0);
    EXPECT_EQ(refusalOf("A", *scene.lights[1]), "");
}

/// With an error in every third edit: each frame shows the last one that was right.
TEST(Presets, MayBeReloadedAHundredTimes) {
    UnshadowedScene scene("Lixel/Surface/Integrated/Maps3");
    const std::string fine = "shadow_camera_setup A\n{\ntechnique Uniform\nmap_size 512\n}\n";
    const std::string coarse = "shadow_camera_setup A\n{\ntechnique Cascades\nslices Uniform\n"
                               "follow_receivers off\nmap_size 32\n}\n";
    const EditedScript script(fine);
    apply("A", *scene.lights.front());
    const std::vector<int> finePicture = scene.draw();
    EXPECT_EQ(script.edit(coarse), 0U);
    const std::vector<int> coarsePicture = scene.draw();
    EXPECT_GT(differing(finePicture, coarsePicture), 0.0);
    bool isFine = false;
    for (int edit = 0; edit < 100; ++edit) {
        if (edit % 3 == 2) {
            EXPECT_EQ(script.edit(edit % 2 == 0 ? "shadow_camera_setup A\n{\nmaps 99\n}\n"
                                                : "shadow_camera_setup A\n{\nmaps 1\n"),
                      1U);
        } else {
            isFine = !isFine;
            EXPECT_EQ(script.edit(isFine ? fine : coarse), 0U);
        }
        ASSERT_EQ(differing(scene.draw(), isFine ? finePicture : coarsePicture, 0), 0.0)
            << "after edit " << edit;
    }
}

TEST(Presets, ThatNoLongerSayADistanceGiveBackTheOneBefore) {
    const std::string begin = "shadow_camera_setup My/Near\n{\nmap_size 64\n";
    UnshadowedScene scene("Lixel/Surface/Integrated");
    const EditedScript script(begin + "}\n");
    Ogre::Light& sun = *scene.lights.front();
    apply("My/Near", sun);
    const Ogre::Real before = sun.getShadowFarDistance();
    EXPECT_EQ(script.edit(begin + "far_distance 7\n}\n"), 0U);
    EXPECT_EQ(sun.getShadowFarDistance(), 7);
    EXPECT_EQ(script.edit(begin + "far_distance 9\n}\n"), 0U);
    EXPECT_EQ(script.edit(begin + "}\n"), 0U);
    EXPECT_EQ(sun.getShadowFarDistance(), before);
    scene.stage.sceneManager().setShadowFarDistance(before + 1);
    EXPECT_EQ(sun.getShadowFarDistance(), before + 1) << "it has none of its own";
}

} // namespace
} // namespace Lixel::Tests
