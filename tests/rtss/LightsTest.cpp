// What the shader system draws with Lixel's shadows, against Lixel's own surface.

#include "ShaderSystemScene.h"

#include <Lixel/setup/ShadowCameraSetups.h>

namespace Lixel::Tests {
namespace {

struct LightCase {
    const char* name;
    std::size_t sun, spot, lamp; ///< maps; 0: no such light
};

std::ostream& operator<<(std::ostream& out, const LightCase& lights) {
    return out << lights.name;
}

void addLights(ShaderSystemScene& scene, const LightCase& lights) {
    if (lights.sun > 0) scene.addSun();
    if (lights.spot > 0) scene.addSpot();
    if (lights.lamp > 0) scene.addLamp();
    scene.setMaps(lights.sun, lights.spot, lights.lamp);
}

std::string caseName(const testing::TestParamInfo<LightCase>& info) {
    return info.param.name;
}

class ShaderSystemLights : public testing::TestWithParam<LightCase> {};

TEST_P(ShaderSystemLights, AreShadowedAsInLixelsSurface) {
    ShaderSystemScene scene;
    addLights(scene, GetParam());
    const Picture bare = scene.draw();
    Lixel::ShaderSystem::enable(scene.shaderSystem.generator);
    const Picture shadowed = scene.draw();
    scene.keepPicture(GetParam().name);
    EXPECT_TRUE(isOther(shadowed, bare)) << "nothing is in shadow";
    EXPECT_TRUE(isSame(shadowed, scene.drawLixels()));
}

INSTANTIATE_TEST_SUITE_P(Maps, ShaderSystemLights,
                         testing::Values(LightCase{"Sun", 1, 0, 0},
                                         LightCase{"SunOfThree", 3, 0, 0},
                                         LightCase{"Spot", 0, 1, 0}, LightCase{"Lamp", 0, 0, 6},
                                         LightCase{"SunAndSpot", 3, 1, 0},
                                         LightCase{"All", 3, 1, 6}),
                         caseName);

TEST(ShaderSystemShadows, AreAlikeUnderBothIntegratedTechniques) {
    ShaderSystemScene scene;
    addLights(scene, {"All", 3, 1, 6});
    Lixel::ShaderSystem::enable(scene.shaderSystem.generator);
    const Picture additive = scene.draw();
    scene.manager().setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE_INTEGRATED);
    EXPECT_EQ(scene.draw(), additive);
}

TEST(ShaderSystemShadows, AreThoseOfSeveralLightsOfAKind) {
    ShaderSystemScene scene;
    scene.addSun();
    Ogre::Light& second = *scene.manager().createLight("second");
    second.setType(Ogre::Light::LT_DIRECTIONAL);
    second.setDiffuseColour(0.1F, 0.3F, 0.3F);
    second.setCustomShadowCameraSetup(XPSMShadowCameraSetup::create());
    Ogre::SceneNode* const node = scene.manager().getRootSceneNode()->createChildSceneNode();
    node->attachObject(&second);
    node->setDirection(Ogre::Vector3(1, -1, 0.3F), Ogre::Node::TS_WORLD);
    scene.setMaps(2, 0, 0);
    scene.manager().setShadowTextureSettings(512, 4, Ogre::PF_FLOAT32_R);
    Lixel::ShaderSystem::enable(scene.shaderSystem.generator);
    const Picture both = scene.draw();
    scene.keepPicture("two-suns");
    EXPECT_TRUE(isSame(both, scene.drawLixels()));
}

TEST(ShaderSystemShadows, FollowChangedNumbersOfMapsAndLights) {
    ShaderSystemScene scene;
    addLights(scene, {"Sun", 1, 0, 0});
    Lixel::ShaderSystem::enable(scene.shaderSystem.generator);
    EXPECT_TRUE(isSame(scene.draw(), scene.drawLixels()));
    scene.setMaps(3, 0, 0);
    EXPECT_TRUE(isSame(scene.draw(), scene.drawLixels())) << "more maps";
    scene.addLamp();
    scene.setMaps(3, 0, 6);
    EXPECT_TRUE(isSame(scene.draw(), scene.drawLixels())) << "a lamp";
    scene.setMaps(1, 0, 6);
    EXPECT_TRUE(isSame(scene.draw(), scene.drawLixels())) << "fewer maps";
    scene.manager().setShadowTechnique(Ogre::SHADOWTYPE_NONE);
    const Picture bare = scene.draw();
    scene.manager().setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    EXPECT_TRUE(isOther(scene.draw(), bare)) << "shadows off and on";
    EXPECT_TRUE(isSame(scene.draw(), scene.drawLixels())) << "shadows off and on";
}

TEST(ShaderSystemShadows, OfALightWithoutSetupAreNone) {
    ShaderSystemScene scene;
    addLights(scene, {"SunAndSpot", 1, 1, 0});
    const Picture bare = scene.draw();
    Lixel::ShaderSystem::enable(scene.shaderSystem.generator);
    scene.manager().getLight("sun")->setCustomShadowCameraSetup(nullptr);
    const Picture sunWithout = scene.draw();
    scene.keepPicture("sun-without-setup");
    EXPECT_TRUE(isOther(sunWithout, bare)) << "the spot's shadow";
    EXPECT_TRUE(isSame(sunWithout, scene.drawLixels()));
    scene.manager().getLight("spot")->setCustomShadowCameraSetup(nullptr);
    EXPECT_TRUE(isSame(scene.draw(), bare));
}

TEST(ShaderSystemShadows, OfALightThatCastsNoneAreNone) {
    ShaderSystemScene scene;
    addLights(scene, {"SunAndSpot", 3, 1, 0});
    Lixel::ShaderSystem::enable(scene.shaderSystem.generator);
    scene.manager().getLight("sun")->setCastShadows(false);
    const Picture spotAlone = scene.draw();
    EXPECT_TRUE(isSame(spotAlone, scene.drawLixels()));
}

} // namespace
} // namespace Lixel::Tests
