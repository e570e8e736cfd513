// Which input it was, where the log says that there is no map because of it.

#include "TestStage.h"

#include <Lixel/scene/OgreVersions.h>

#include <functional>

namespace Lixel::Tests {
namespace {

struct InvalidCase {
    const char* name;
    std::function<void(Ogre::SceneManager&, Ogre::Light&)> spoil;
    const char* said;
};

void makeSpot(Ogre::Light& light) {
    light.setType(Ogre::Light::LT_SPOTLIGHT);
    light.setSpotlightRange(Ogre::Degree(50), Ogre::Degree(60));
    light.setAttenuation(100, 1, 0, 0);
    light.getParentSceneNode()->setPosition(2, 4, 6); // in view
}

class InvalidInput : public testing::TestWithParam<InvalidCase> {};

TEST_P(InvalidInput, IsNamedOnce) {
    BoxOnGround scene;
    LogCollector log;
    GetParam().spoil(scene.stage.sceneManager(), scene.stage.light());
    for (int i = 0; i < 3; ++i)
        scene.stage.drawFrame();
    // Since 13.6 OGRE ends on negative distances before it asks any setup; the guard names those.
    const bool guarded = log.count("or a negative distance; it neither shines") != 0;
    EXPECT_EQ(guarded, !canDrawShadowsOf(scene.stage.light()));
    if (!guarded) {
        EXPECT_EQ(log.count("no shadow map for light 'Light': invalid input: " +
                            std::string(GetParam().said)),
                  1U)
            << log.all();
    }
    EXPECT_EQ(log.count("Lixel:"), 1U) << log.all();
}

INSTANTIATE_TEST_SUITE_P(
    Cases, InvalidInput,
    testing::Values(
        InvalidCase{
            "SmallTexture",
            [](Ogre::SceneManager& manager, Ogre::Light&) { manager.setShadowTextureSize(4); },
            "the shadow texture is 4 x 4 pixels, and the border of a map with a filter "
            "radius of 1 takes "},
        InvalidCase{"NegativeShadowDistance",
                    [](Ogre::SceneManager&, Ogre::Light& light) { light.setShadowFarDistance(-1); },
                    "its shadow distance is -1"},
        InvalidCase{"NegativeShadowDistanceOfTheScene",
                    [](Ogre::SceneManager& manager, Ogre::Light& light) {
                        light.resetShadowFarDistance();
                        manager.setShadowFarDistance(-2.5F);
                    },
                    "its shadow distance is -2.5"},
        InvalidCase{"RangeBeforeTheNearDistance",
                    [](Ogre::SceneManager&, Ogre::Light& light) {
                        makeSpot(light);
                        light.setShadowNearClipDistance(2);
                        light.setAttenuation(1.5F, 1, 0, 0);
                    },
                    "its range is 1.5, and its shadows begin at 2"},
        InvalidCase{"SpotWithoutAngle",
                    [](Ogre::SceneManager&, Ogre::Light& light) {
                        makeSpot(light);
                        light.setSpotlightRange(Ogre::Degree(0), Ogre::Degree(0));
                    },
                    "its outer angle is 0 degrees"}),
    [](const auto& invalid) { return std::string(invalid.param.name); });

} // namespace
} // namespace Lixel::Tests
