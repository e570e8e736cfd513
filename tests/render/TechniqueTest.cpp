// The materials under each of OGRE's shadow techniques: additive, additive integrated, modulative.

#include "TestStage.h"

#include "common/OracleView.h"
#include "common/Surface.h"

namespace Lixel::Tests {
namespace {

using Samples::PixelClass;

/// The truth of the scene's next frame.
Samples::ShadowTruth truthOf(BoxOnGround& scene) {
    scene.stage.drawFrame();
    const Samples::ShadowOracle oracle(Samples::collectTriangles(scene.stage.sceneManager()));
    return oracle.classify(Samples::oracleView(scene.stage.camera(), 320, 240, 100.0),
                           Samples::oracleLight(scene.stage.light()));
}

/// Mean red of the pixels of a class, 0 to 255.
double meanOf(PixelClass pixelClass, const Samples::ShadowTruth& truth,
              const std::vector<std::uint8_t>& rgb) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        if (truth.pixels[i] != pixelClass) continue;
        sum += rgb[3 * i];
        ++count;
    }
    EXPECT_GT(count, 50U);
    return count == 0 ? -1.0 : sum / static_cast<double>(count);
}

/// Percentage of lit and shadowed ground that is nearer to the other's colour.
double misclassified(const Samples::ShadowTruth& truth, const std::vector<std::uint8_t>& rgb,
                     double lit, double shadowed) {
    std::size_t wrong = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        const PixelClass c = truth.pixels[i];
        if (c != PixelClass::Lit && c != PixelClass::Shadowed) continue;
        const bool looksLit = rgb[3 * i] > (lit + shadowed) / 2.0;
        wrong += looksLit != (c == PixelClass::Lit) ? 1U : 0U;
        ++count;
    }
    return 100.0 * static_cast<double>(wrong) / static_cast<double>(count);
}

Ogre::MaterialPtr material(const std::string& name) {
    return Ogre::MaterialManager::getSingleton().getByName(name);
}

/// Ambient light 0.2 and sunlight, on a surface of 0.8, in 8 bits.
constexpr double AmbientOnly = 0.2 * 0.8 * 255.0;

void expectShadows(BoxOnGround& scene, double shadowedLevel) {
    // The box' own top faces the light as the ground does: all of Lit has one colour.
    const Samples::ShadowTruth truth = truthOf(scene);
    scene.stage.drawFrame();
    const std::vector<std::uint8_t> rgb = scene.stage.picture();
    const double lit = meanOf(PixelClass::Lit, truth, rgb);
    const double shadowed = meanOf(PixelClass::Shadowed, truth, rgb);
    EXPECT_GT(lit, AmbientOnly + 60.0);
    EXPECT_NEAR(shadowed, shadowedLevel, 3.0);
    EXPECT_LT(misclassified(truth, rgb, lit, shadowed), 0.5);
}

TEST(Technique, Additive) {
    BoxOnGround scene;
    scene.stage.sceneManager().setShadowTextureReceiverMaterial(material("Lixel/Receiver"));
    expectShadows(scene, AmbientOnly);
}

TEST(Technique, AdditiveBilinear) {
    BoxOnGround scene;
    expectShadows(scene, AmbientOnly);
}

TEST(Technique, Modulative) {
    for (const char* const name :
         {"Lixel/Receiver/Modulative", "Lixel/Receiver/Modulative/Bilinear"}) {
        SCOPED_TRACE(name);
        BoxOnGround scene;
        scene.stage.sceneManager().setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE);
        scene.stage.sceneManager().setShadowTextureReceiverMaterial(material(name));
        scene.stage.sceneManager().setShadowColour(Ogre::ColourValue(0.5F, 0.5F, 0.5F));
        const Samples::ShadowTruth truth = truthOf(scene);
        scene.stage.drawFrame();
        const std::vector<std::uint8_t> rgb = scene.stage.picture();
        const double lit = meanOf(PixelClass::Lit, truth, rgb);
        const double shadowed = meanOf(PixelClass::Shadowed, truth, rgb);
        EXPECT_NEAR(shadowed, 0.5 * lit, 4.0);
        EXPECT_LT(misclassified(truth, rgb, lit, shadowed), 0.5);
    }
}

TEST(Technique, AdditiveIntegrated) {
    BoxOnGround scene;
    scene.stage.sceneManager().setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    int index = 0;
    for (Ogre::SceneNode* node : {scene.ground, scene.box}) {
        const Ogre::MaterialPtr own =
            material("Lixel/Surface/Integrated")->clone("Integrated" + std::to_string(index++));
        own->setAmbient(Ogre::ColourValue(0.8F, 0.8F, 0.8F));
        own->setDiffuse(Ogre::ColourValue(0.8F, 0.8F, 0.8F));
        static_cast<Ogre::Entity*>(node->getAttachedObject(0))->setMaterial(own);
    }
    expectShadows(scene, AmbientOnly);
}

/// Two lights, two maps, one frame: each light's receivers read its own map.
TEST(Technique, TwoLights) {
    for (const bool integrated : {false, true}) {
        SCOPED_TRACE(integrated ? "integrated" : "additive");
        BoxOnGround scene;
        Ogre::SceneManager& manager = scene.stage.sceneManager();
        manager.setAmbientLight(Ogre::ColourValue::Black);
        if (integrated) {
            manager.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
            const Ogre::MaterialPtr own = material("Lixel/Surface/Integrated")->clone("Both");
            own->setDiffuse(Ogre::ColourValue(0.8F, 0.8F, 0.8F));
            for (Ogre::SceneNode* node : {scene.ground, scene.box})
                static_cast<Ogre::Entity*>(node->getAttachedObject(0))->setMaterial(own);
        }
        manager.setShadowTextureSettings(1024, 2, Ogre::PF_FLOAT32_R);
        scene.stage.light().setDiffuseColour(Ogre::ColourValue(1, 0, 0));
        Ogre::Light* const green = manager.createLight("green");
        green->setType(Ogre::Light::LT_DIRECTIONAL);
        green->setDiffuseColour(Ogre::ColourValue(0, 1, 0));
        Ogre::SceneNode* const node = manager.getRootSceneNode()->createChildSceneNode();
        node->attachObject(green);
        node->setDirection(Ogre::Vector3(1, -1, 0), Ogre::Node::TS_WORLD);
        green->setCustomShadowCameraSetup(Samples::findShadowSetup("Uniform")->create());

        const Samples::ShadowTruth red = truthOf(scene);
        const Samples::ShadowOracle oracle(Samples::collectTriangles(manager));
        const Samples::ShadowTruth other =
            oracle.classify(Samples::oracleView(scene.stage.camera(), 320, 240, 100.0),
                            Samples::oracleLight(*green));
        scene.stage.drawFrame();
        const std::vector<std::uint8_t> rgb = scene.stage.picture();
        std::size_t wrong = 0;
        std::size_t counted = 0;
        for (std::size_t i = 0; i < red.pixels.size(); ++i) {
            for (const auto& [truth, channel] : {std::pair(&red, 0U), std::pair(&other, 1U)}) {
                const PixelClass c = truth->pixels[i];
                if (c != PixelClass::Lit && c != PixelClass::Shadowed) continue;
                ++counted;
                wrong += (rgb[3 * i + channel] > 60) != (c == PixelClass::Lit) ? 1U : 0U;
            }
        }
        EXPECT_GT(counted, 1000U);
        EXPECT_LT(100.0 * static_cast<double>(wrong) / static_cast<double>(counted), 0.5);
    }
}

/// A spot light, whose cone ends on the ground.
TEST(Technique, SpotLight) {
    for (const float outer : {60.0F, 100.0F, 150.0F}) {
        SCOPED_TRACE(outer);
        BoxOnGround scene;
        scene.stage.light().setType(Ogre::Light::LT_SPOTLIGHT);
        scene.stage.light().setSpotlightRange(Ogre::Degree(outer * 0.8F), Ogre::Degree(outer));
        scene.stage.light().setAttenuation(200, 1, 0, 0);
        scene.stage.light().getParentSceneNode()->setPosition(Ogre::Vector3(6, 7, 1));
        scene.stage.light().getParentSceneNode()->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
        const Samples::ClassificationError error = scene.nextFrameError();
        EXPECT_GT(error.shadowed, 100U);
        EXPECT_LT(error.error, 0.5);
    }
}

} // namespace
} // namespace Lixel::Tests
