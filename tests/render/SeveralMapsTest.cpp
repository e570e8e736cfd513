// Lights with several maps: slices, faces, cubes, as OGRE draws them.

#include "TestStage.h"

#include "common/MapCapture.h"
#include "common/Measurement.h"
#include "common/OracleView.h"

#include <fmt/core.h>

#include <optional>

namespace Lixel::Tests {
namespace {

using namespace Samples;

void setMaps(Stage& stage, int side, std::size_t count) {
    Ogre::SceneManager& manager = stage.sceneManager();
    manager.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    for (const auto type :
         {Ogre::Light::LT_DIRECTIONAL, Ogre::Light::LT_SPOTLIGHT, Ogre::Light::LT_POINT})
        manager.setShadowTextureCountPerLightType(type, count);
    manager.setShadowTextureSettings(static_cast<Ogre::ushort>(side),
                                     static_cast<Ogre::ushort>(count), Ogre::PF_FLOAT32_R);
}

class SeveralMaps : public testing::TestWithParam<const char*> {};

/// The picture errs as its matrices say that it should, and little.
TEST_P(SeveralMaps, OfTheSunAreDrawnAsEmulated) {
    constexpr int Width = 400;
    constexpr int Height = 300;
    constexpr int MapSize = 1024;
    const SampleScene& scene = *findSampleScene("field");
    Stage stage({.headless = true, .width = Width, .height = Height});
    stage.show(scene);
    const double reach = static_cast<double>(scene.shadowDistance);
    const ShadowOracle oracle(collectTriangles(stage.sceneManager()));
    MapEmulation emulation(oracle, casterFaces(stage.sceneManager()));
    MapCapture capture(stage);
    const NamedSetup& setup = *findEmulatedSetup(GetParam());
    for (const SampleLight& light : std::span(scene.lights).first(2)) {
        stage.setView(scene.views.front());
        stage.setLight(light);
        emulation.setView(oracleView(stage.camera(), Width, Height, reach));
        emulation.setLight(oracleLight(stage.light()));
        const auto maps = capture.capture(setup, MapSize, reach, oracle.scene().wsOrigin);
        ASSERT_EQ(maps.size(), setup.maps);
        EXPECT_GT(maps[0].width, 0);
        const ClassificationError expected = emulation.error(maps);

        capture.begin(setup, MapSize, reach, oracle.scene().wsOrigin);
        const ClassificationError drawn =
            compareWithTruth(emulation.truth(), capture.nextVisibility());
        fmt::print("{}, {}: drawn {:.3f} %, emulated {:.3f} %, {} shadowed pixels\n", setup.name,
                   light.name, drawn.error, expected.error, drawn.shadowed);
        EXPECT_GT(drawn.shadowed, 1000U);
        // As in EmulationTest: a tenth, and 40 pixels of rasterisation.
        EXPECT_NEAR(drawn.error, expected.error,
                    0.1 * drawn.error + 4000.0 / static_cast<double>(drawn.counted()));
    }
}

INSTANTIATE_TEST_SUITE_P(Setups, SeveralMaps,
                         testing::Values("Cascades-2", "Cascades-3", "Uniform-Cascades-3",
                                         "Stable-Cascades-3", "Cube", "Ogre-PSSM-3"),
                         [](const auto& instance) {
                             std::string name = instance.param;
                             std::erase(name, '-');
                             return name;
                         });

/// A lamp with boxes of height 2 on all sides of it.
class Lamp : public BoxOnGround {
public:
    explicit Lamp(float height) : BoxOnGround("", "Uniform") {
        stage.light().setType(Ogre::Light::LT_POINT);
        stage.light().setAttenuation(200, 1, 0, 0);
        stage.light().getParentSceneNode()->setPosition(0, height, 0);
        box->setPosition(4, 1, 0);
        addCube(Ogre::Vector3(-4, 1, 1), Ogre::Vector3(2, 2, 2));
        addCube(Ogre::Vector3(0, 1, -5), Ogre::Vector3(2, 2, 2));
        addCube(Ogre::Vector3(0, 1, 4), Ogre::Vector3(1, 2, 1));
    }

    ClassificationError error() {
        const ShadowOracle oracle(collectTriangles(stage.sceneManager()));
        return measureError(stage, oracle, 100.0);
    }
};

TEST(PointLight, HasSixMaps) {
    for (const char* const setup : {"Uniform", "Optimal", "Cascades-3", "Cube"}) {
        SCOPED_TRACE(setup);
        Lamp lamp(3);
        LogCollector log;
        lamp.stage.setShadowSetup(findEmulatedSetup(setup)->create());
        setMaps(lamp.stage, 1024, 6);
        const ClassificationError error = lamp.error();
        fmt::print("{}: {:.3f} % of {} shadowed pixels\n", setup, error.error, error.shadowed);
        EXPECT_GT(error.shadowed, 1000U);
        EXPECT_LT(error.error, 0.5);
        EXPECT_EQ(log.count("Lixel:"), 0U);
    }
}

/// In the open, a single map is aimed at what it can shadow.
TEST(PointLight, BesideTheSceneNeedsOneMap) {
    BoxOnGround scene("", "Optimal");
    LogCollector log;
    scene.stage.light().setType(Ogre::Light::LT_POINT);
    scene.stage.light().setAttenuation(200, 1, 0, 0);
    scene.stage.light().getParentSceneNode()->setPosition(6, 7, 1);
    const ClassificationError error = scene.nextFrameError();
    EXPECT_GT(error.shadowed, 100U);
    EXPECT_LT(error.error, 0.5);
    EXPECT_EQ(log.count("Lixel:"), 0U);
}

TEST(PointLight, SaysWhereOneMapIsNotEnough) {
    Lamp lamp(1);
    LogCollector log;
    const ClassificationError error = lamp.nextFrameError();
    // Without a map all shadows would leak.
    const double all =
        100.0 * static_cast<double>(error.shadowed) / static_cast<double>(error.counted());
    fmt::print("one map: leaks {:.3f} % of {:.3f} %, acne {:.3f} %\n", error.leak, all, error.acne);
    EXPECT_LT(error.leak, all / 2.0);
    EXPECT_LT(error.acne, 0.2);
    EXPECT_EQ(log.count("light 'Light' shines too wide for the maps that it has"), 1U);
    // From above it is.
    lamp.stage.light().getParentSceneNode()->setPosition(0, 3, 0);
    EXPECT_LT(lamp.visibilityAt(Ogre::Vector3(8, 0, 0)), 128);
}

/// Where one cone is all that a lamp gets, two maps show it finer than one.
TEST(PointLight, SharesItsConeAmongCascades) {
    for (const float height : {1.0F, 3.0F}) {
        SCOPED_TRACE(height);
        Lamp lamp(height);
        setMaps(lamp.stage, 256, 2);
        lamp.stage.setShadowSetup(findEmulatedSetup("Optimal")->create());
        const double one = lamp.error().error;
        lamp.stage.setShadowSetup(findEmulatedSetup("Cascades-2")->create());
        const ClassificationError two = lamp.error();
        fmt::print("at {} m: one map {:.3f} %, two {:.3f} %\n", height, one, two.error);
        EXPECT_GT(two.shadowed, 1000U);
        EXPECT_LT(two.error, 0.95 * one);
    }
}

TEST(PointLight, SaysWhereFacesAreMissing) {
    Lamp lamp(1);
    LogCollector log;
    // Below the lamp, whose face would otherwise show nothing.
    lamp.addCube(Ogre::Vector3(0.3F, 0.1F, 0.3F), Ogre::Vector3(0.4F, 0.2F, 0.4F));
    setMaps(lamp.stage, 512, 4);
    for (int i = 0; i < 3; ++i)
        lamp.stage.drawVisibility();
    EXPECT_EQ(log.count("needs more shadow maps than it has"), 1U);
    // Faces that show nothing need no map: the one upwards here.
    setMaps(lamp.stage, 512, 5);
    EXPECT_LT(lamp.error().error, 1.0);
    EXPECT_EQ(log.count("Lixel:"), 1U);
    // Two are too few for faces: one of them is a cone.
    setMaps(lamp.stage, 512, 2);
    const ClassificationError error = lamp.error();
    EXPECT_LT(error.leak, 100.0 * static_cast<double>(error.shadowed) /
                              static_cast<double>(error.counted()) / 2.0);
    EXPECT_EQ(log.count("light 'Light' shines too wide for the maps that it has"), 1U);
}

/// Materials that read six maps, for lights that have fewer: what these lack serves nothing.
TEST(SeveralMapsOfALight, MayBeFewerThanTheMaterialReads) {
    for (const std::size_t maps : {1U, 2U, 5U})
        for (const char* const setup : {"Cube", "Cascades-3", "Uniform"}) {
            SCOPED_TRACE(std::string(setup) + " " + std::to_string(maps));
            BoxOnGround scene("", "Uniform");
            scene.stage.setShadowSetup(findEmulatedSetup(setup)->create());
            setMaps(scene.stage, 1024, maps);
            const ShadowOracle oracle(collectTriangles(scene.stage.sceneManager()));
            const ClassificationError error = measureError(scene.stage, oracle, 100.0);
            EXPECT_GT(error.shadowed, 100U);
            EXPECT_LT(error.leakPixels, error.shadowed / 10);
        }
}

/// Six per point light are asked for, and there is one texture: it is used as the only one.
TEST(SeveralMapsOfALight, AreAsManyAsThereAreTextures) {
    Lamp lamp(3);
    LogCollector log;
    Ogre::SceneManager& manager = lamp.stage.sceneManager();
    manager.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    manager.setShadowTextureCountPerLightType(Ogre::Light::LT_POINT, 6);
    manager.setShadowTextureSettings(1024, 1, Ogre::PF_FLOAT32_R);
    EXPECT_LT(lamp.error().error, 0.5);
    EXPECT_EQ(log.count("there are textures for 1"), 1U);
}

TEST(SeveralMapsOfALight, AreOneOutsideOfIntegratedTechniques) {
    BoxOnGround scene("", "Optimal");
    LogCollector log;
    scene.stage.setShadowSetup(findEmulatedSetup("Cascades-3")->create());
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    manager.setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, 3);
    manager.setShadowTextureSettings(1024, 3, Ogre::PF_FLOAT32_R);
    for (int i = 0; i < 3; ++i)
        scene.stage.drawFrame();
    EXPECT_EQ(log.count("has 3 shadow textures"), 1U);
    EXPECT_EQ(log.count("Lixel:"), 1U);
    EXPECT_LT(scene.nextFrameError().error, 0.5);
}

} // namespace
} // namespace Lixel::Tests
