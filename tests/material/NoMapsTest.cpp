// What the log says where Lixel's materials are drawn and no map of Lixel's ever is.

#include "MaterialScene.h"

#include <Lixel/material/ShadowMaterials.h>
#include <Lixel/setup/ObservedShadowCameraSetup.h>

#include <OgreShadowCameraSetupFocused.h>

namespace Lixel::Tests {
namespace {

const char* const NoSetup = "no light that casts shadows has a setup of Lixel's";
const char* const NoTextures = "has no shadow textures";

/// Long enough for two looks.
constexpr int TwoLooks = 70;

void drawFor(MaterialScene& scene, int frames = TwoLooks) {
    for (int i = 0; i < frames; ++i)
        scene.stage.drawFrame();
}

/// None of the lights has a setup.
class SceneWithoutSetups : public MaterialScene {
public:
    SceneWithoutSetups(Ogre::ShadowTechnique technique, const std::string& receiver)
        : MaterialScene(technique, receiver) {
        for (Ogre::Light* light : lights)
            light->setCustomShadowCameraSetup(nullptr);
    }
};

TEST(NoMaps, AreNamedWithTheSetupThatIsMissing) {
    for (const auto& [technique, receiver, surface] :
         {std::tuple(AdditiveTechnique, "Lixel/Receiver", "Lixel/Surface"),
          std::tuple(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE, "Lixel/Receiver/Modulative",
                     "Lixel/Surface"),
          std::tuple(IntegratedTechnique, "", "Lixel/Surface/Integrated")}) {
        SceneWithoutSetups scene(technique, receiver);
        LogCollector log;
        scene.wear(surface);
        drawFor(scene, 3);
        EXPECT_EQ(log.count("Lixel:"), 0U) << "a scene that is being made: " << log.all();
        drawFor(scene);
        EXPECT_EQ(log.count(NoSetup), 1U) << surface << ": " << log.all();
        EXPECT_EQ(log.count("Lixel:"), 1U) << log.all();
    }
}

TEST(NoMaps, AreNamedUnderOgresOwnSetups) {
    SceneWithoutSetups scene(AdditiveTechnique, "Lixel/Receiver");
    LogCollector log;
    scene.stage.sceneManager().setShadowCameraSetup(Ogre::FocusedShadowCameraSetup::create());
    scene.lights[0]->setCustomShadowCameraSetup(Ogre::DefaultShadowCameraSetup::create());
    drawFor(scene);
    EXPECT_EQ(log.count(NoSetup), 1U) << log.all();
}

TEST(NoMaps, AreNamedWithTheTexturesThatAreMissing) {
    for (const auto& [technique, receiver, surface] :
         {std::tuple(AdditiveTechnique, "Lixel/Receiver", "Lixel/Surface"),
          std::tuple(IntegratedTechnique, "", "Lixel/Surface/Integrated")}) {
        MaterialScene scene(technique, receiver);
        LogCollector log;
        scene.stage.sceneManager().setShadowTextureCount(0);
        scene.wear(surface);
        drawFor(scene);
        EXPECT_EQ(log.count(NoTextures), 1U) << surface << ": " << log.all();
        EXPECT_EQ(log.count("Lixel:"), 1U) << log.all();
    }
}

TEST(NoMaps, AreNamedWhereTheLightsTypeHasNone) {
    MaterialScene scene(IntegratedTechnique, "");
    LogCollector log;
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    for (const auto type : {Ogre::Light::LT_DIRECTIONAL, Ogre::Light::LT_SPOTLIGHT})
        manager.setShadowTextureCountPerLightType(type, 0);
    scene.wear("Lixel/Surface/Integrated");
    drawFor(scene);
    EXPECT_EQ(log.count("has no shadow textures for lights of the types"), 1U) << log.all();
    EXPECT_EQ(log.count("Lixel:"), 1U) << log.all();
}

TEST(NoMaps, AreNoNewsWhereNoShadowsAreWanted) {
    SceneWithoutSetups scene(AdditiveTechnique, "Lixel/Receiver");
    LogCollector log;
    scene.stage.sceneManager().setShadowTechnique(Ogre::SHADOWTYPE_NONE);
    drawFor(scene);
    EXPECT_EQ(log.count("Lixel:"), 0U) << "no technique: " << log.all();
    scene.stage.sceneManager().setShadowTechnique(AdditiveTechnique);
    scene.stage.window().getViewport(0)->setShadowsEnabled(false);
    drawFor(scene);
    EXPECT_EQ(log.count("Lixel:"), 0U) << "a viewport without: " << log.all();
    scene.stage.window().getViewport(0)->setShadowsEnabled(true);
    for (Ogre::Light* light : scene.lights)
        light->setCastShadows(false);
    drawFor(scene);
    EXPECT_EQ(log.count("Lixel:"), 0U) << "no light casts any: " << log.all();
    for (Ogre::Light* light : scene.lights)
        light->setCastShadows(true);
    drawFor(scene);
    EXPECT_EQ(log.count(NoSetup), 1U) << log.all();
}

TEST(NoMaps, AreNoNewsOfSetupsThatAreObserved) {
    SceneWithoutSetups scene(AdditiveTechnique, "Lixel/Receiver");
    scene.stage.sceneManager().setShadowCameraSetup(
        ObservedShadowCameraSetup::create(Ogre::DefaultShadowCameraSetup::create()));
    LogCollector log;
    drawFor(scene);
    EXPECT_EQ(log.count(NoSetup), 0U) << log.all();
}

TEST(NoMaps, AreNoNewsOfForeignMaterials) {
    SceneWithoutSetups scene(IntegratedTechnique, "");
    setShadowMaterials(scene.stage.sceneManager(), "", "Test/DepthCaster");
    scene.stage.sceneManager().setShadowTextureSettings(256, 3, Ogre::PF_DEPTH16);
    LogCollector log;
    scene.wear("Test/Pssm");
    drawFor(scene);
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
}

} // namespace
} // namespace Lixel::Tests
