// A light with a NaN stays away from OGRE, and whether it is visible stays the user's own choice.

#include "SpoiltLight.h"
#include "TestStage.h"

#include <Lixel/scene/OgreVersions.h>

#include <functional>

namespace Lixel::Tests {
namespace {

class LightGuarded : public testing::Test {
protected:
    void spoil() { mSpoilt.spoil(); }
    void mend() { mSpoilt.mend(); }
    void draw() {
        for (int i = 0; i < 2; ++i)
            scene.stage.drawFrame();
    }
    bool shines() { return scene.visibilityAt(InTheSun) >= 128; }

    BoxOnGround scene;
    LogCollector log;
    Ogre::Light& light = scene.stage.light();

private:
    SpoiltLight mSpoilt{light};
};

TEST_F(LightGuarded, ShinesAgain) {
    EXPECT_TRUE(shines());
    spoil();
    EXPECT_FALSE(shines());
    EXPECT_TRUE(light.getVisible()) << "whether it is visible is the user's own";
    mend();
    EXPECT_TRUE(shines());
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
    EXPECT_EQ(log.count("not finite"), 1U);
}

TEST_F(LightGuarded, StaysHiddenThatWasHiddenBefore) {
    light.setVisible(false);
    spoil();
    draw();
    mend();
    EXPECT_FALSE(shines());
    EXPECT_FALSE(light.getVisible());
    light.setVisible(true);
    EXPECT_TRUE(shines());
}

TEST_F(LightGuarded, StaysHiddenThatWasHiddenMeanwhile) {
    spoil();
    draw();
    light.setVisible(false);
    draw();
    mend();
    EXPECT_FALSE(shines());
    EXPECT_FALSE(light.getVisible());
    light.setVisible(true);
    EXPECT_TRUE(shines());
}

TEST_F(LightGuarded, ShinesThatWasShownMeanwhile) {
    light.setVisible(false);
    spoil();
    draw();
    light.setVisible(true);
    draw();
    EXPECT_FALSE(shines());
    mend();
    EXPECT_TRUE(shines());
    EXPECT_EQ(log.count("not finite"), 1U);
}

TEST_F(LightGuarded, IsNotHandedToOgreByWhoShowsIt) {
    spoil();
    for (int i = 0; i < 5; ++i) {
        light.setVisible(true);
        light.setVisibilityFlags(1U << i);
        draw();
    }
    EXPECT_FALSE(shines());
    EXPECT_EQ(log.count("not finite"), 1U);
    mend();
    EXPECT_TRUE(shines());
    EXPECT_EQ(light.getVisibilityFlags(), 16U) << "the flags set last hold";
}

TEST_F(LightGuarded, KeepsItsVisibilityFlags) {
    light.setVisibilityFlags(6);
    spoil();
    draw();
    mend();
    draw();
    EXPECT_EQ(light.getVisibilityFlags(), 6U);
}

TEST_F(LightGuarded, LeavesANewLightOfTheSameNameAlone) {
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    Ogre::Light* lamp = manager.createLight("Lamp");
    Ogre::SceneNode* const node = manager.getRootSceneNode()->createChildSceneNode();
    node->attachObject(lamp);
    lamp->setType(Ogre::Light::LT_DIRECTIONAL);
    SpoiltLight(*lamp).spoil();
    draw();
    EXPECT_EQ(log.count("not finite"), 1U);
    manager.destroyLight(lamp);

    lamp = manager.createLight("Lamp");
    node->attachObject(lamp);
    lamp->setType(Ogre::Light::LT_DIRECTIONAL);
    lamp->setVisible(false);
    draw();
    EXPECT_FALSE(lamp->getVisible()) << "that one was hidden by its user";
    lamp->setVisible(true);
    SpoiltLight(*lamp).spoil();
    draw();
    EXPECT_EQ(log.count("not finite"), 2U) << "another light, another line";
}

/// Lights without a node have no place since OGRE 13, which crashes on them.
TEST_F(LightGuarded, MayLeaveItsNode) {
    Ogre::SceneNode& node = *light.getParentSceneNode();
    light.detachFromParent();
    draw();
    EXPECT_EQ(log.count("is attached to no scene node"), LightsHaveDirections ? 0U : 1U);
    node.attachObject(&light);
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
    EXPECT_TRUE(shines());
}

TEST_F(LightGuarded, SaysSoOnceThoughItFlickers) {
    for (int i = 0; i < 10; ++i) {
        spoil();
        draw();
        mend();
        draw();
    }
    EXPECT_EQ(log.count("not finite"), 1U);
}

TEST_F(LightGuarded, ShinesWithoutShadowsHoweverFarTheyReached) {
    light.setCastShadows(false);
    light.setShadowFarDistance(NaN);
    draw();
    EXPECT_NE(light.getVisibilityFlags(), 0U);
    EXPECT_EQ(log.count("not finite"), 0U) << log.all();
}

/// Whatever else of a light is a number.
TEST_F(LightGuarded, SurvivesANaNAnywhere) {
    using Spoil = std::function<void(Ogre::Light&)>;
    const Ogre::Radian wrong(NaN);
    const std::vector<Spoil> spoils = {
        [](Ogre::Light& l) { l.setAttenuation(NaN, 1, 0, 0); },
        [](Ogre::Light& l) { l.setAttenuation(100, NaN, NaN, NaN); },
        [](Ogre::Light& l) { l.setAttenuation(Infinity, 1, 0, 0); },
        [&](Ogre::Light& l) { l.setSpotlightOuterAngle(wrong); },
        [&](Ogre::Light& l) { l.setSpotlightInnerAngle(wrong); },
        [](Ogre::Light& l) { l.setSpotlightFalloff(NaN); },
        [](Ogre::Light& l) { l.setPowerScale(NaN); },
        [](Ogre::Light& l) { l.setShadowFarDistance(NaN); },
        [](Ogre::Light& l) { l.setShadowNearClipDistance(NaN); },
        [](Ogre::Light& l) { l.setShadowFarClipDistance(NaN); },
        [](Ogre::Light& l) { l.setShadowFarClipDistance(Infinity); },
    };
    for (const auto type :
         {Ogre::Light::LT_DIRECTIONAL, Ogre::Light::LT_SPOTLIGHT, Ogre::Light::LT_POINT})
        for (std::size_t i = 0; i < spoils.size(); ++i) {
            SCOPED_TRACE(testing::Message() << "type " << type << ", number " << i);
            Ogre::Light* const lamp = scene.stage.sceneManager().createLight();
            Ogre::SceneNode* const node =
                scene.stage.sceneManager().getRootSceneNode()->createChildSceneNode();
            node->setPosition(3, 6, 0);
            node->setDirection(Ogre::Vector3(-0.5F, -1, 0));
            node->attachObject(lamp);
            lamp->setType(type);
            lamp->setCustomShadowCameraSetup(light.getCustomShadowCameraSetup());
            // The only one, so that it has the only shadow texture.
            light.setVisible(false);
            spoils[i](*lamp);
            draw();
            scene.stage.sceneManager().destroyLight(lamp);
            light.setVisible(true);
        }
    EXPECT_TRUE(shines());
}

/// A node that moves between two frames: what it derived in the last one is finite.
TEST(LightGuard, SeesWhereNodesAreNow) {
    for (const bool isGrandparent : {false, true}) {
        BoxOnGround scene;
        Ogre::Light& light = scene.stage.light();
        light.setType(Ogre::Light::LT_SPOTLIGHT);
        light.setSpotlightRange(Ogre::Degree(60), Ogre::Degree(70));
        Ogre::SceneNode* node = light.getParentSceneNode();
        node->setPosition(4, 6, 0);
        if (isGrandparent) {
            Ogre::SceneNode* const above =
                scene.stage.sceneManager().getRootSceneNode()->createChildSceneNode();
            node->getParentSceneNode()->removeChild(node);
            above->addChild(node);
            node = above;
        }
        const Ogre::Vector3 before = node->getPosition();
        scene.stage.drawFrame();
        LogCollector log;
        node->setPosition(Infinity, 0, 0);
        scene.stage.drawFrame();
        EXPECT_EQ(log.count("not finite"), 1U) << log.all();
        node->setPosition(before);
        scene.stage.drawFrame();
        EXPECT_LT(scene.visibilityAt(InShadow), 128);
    }
}

} // namespace
} // namespace Lixel::Tests
