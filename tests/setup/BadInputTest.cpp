// Bad frames: no abort, no wrong shadow, one line in the log, and shadows again afterwards.

#include "SpoiltLight.h"
#include "TestStage.h"

namespace Lixel::Tests {
namespace {

/// Left of the box, in its shadow; the sun is on the right, 45 degrees high.

/// Errors of a settled frame of this scene are some tenths of a percent, at texel edges.
constexpr double GoodFrame = 0.5;

class BadInput : public testing::TestWithParam<const char*> {
protected:
    BoxOnGround scene{GetParam()};
    LogCollector log;
    LastMap last;

    void expectGoodFrame() {
        EXPECT_LT(scene.visibilityAt(InShadow), 128);
        EXPECT_GE(scene.visibilityAt(InTheSun), 128);
        EXPECT_LT(scene.nextFrameError().error, GoodFrame);
        EXPECT_TRUE(last.fit.hasMap());
    }

    /// A triangle over the box that claims to be everywhere.
    Ogre::ManualObject* addCloud() {
        Ogre::ManualObject* const cloud = scene.stage.sceneManager().createManualObject("cloud");
        cloud->begin("Lixel/Surface", Ogre::RenderOperation::OT_TRIANGLE_LIST);
        for (const Ogre::Vector3& p :
             {Ogre::Vector3(-1, 3, -1), Ogre::Vector3(-1, 3, 1), Ogre::Vector3(1, 3, 1)}) {
            cloud->position(p);
            cloud->normal(Ogre::Vector3::UNIT_Y);
        }
        cloud->triangle(0, 1, 2);
        cloud->end();
        cloud->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
        Ogre::SceneNode* const node =
            scene.stage.sceneManager().getRootSceneNode()->createChildSceneNode();
        node->attachObject(cloud);
        return cloud;
    }
};

TEST_P(BadInput, GoodFramesHaveShadows) {
    expectGoodFrame();
    EXPECT_EQ(log.count("Lixel:"), 0U);
}

TEST_P(BadInput, LightWithNaN) {
    expectGoodFrame();
    const Ogre::Vector3 direction = scene.stage.light().getDerivedDirection();
    SpoiltLight light(scene.stage.light());
    light.spoil();
    for (int i = 0; i < 3; ++i)
        scene.stage.drawFrame();
    EXPECT_EQ(log.count("not finite"), 1U);
    light.mend();
    EXPECT_LT(scene.stage.light().getDerivedDirection().distance(direction), 1e-5F);
    expectGoodFrame();
    EXPECT_EQ(log.count("Lixel:"), 1U);
}

TEST_P(BadInput, LightWithNaNInTheFirstFrame) {
    SpoiltLight light(scene.stage.light());
    light.spoil();
    scene.stage.drawFrame();
    EXPECT_EQ(log.count("not finite"), 1U);
    light.mend();
    expectGoodFrame();
}

TEST_P(BadInput, InfiniteBoxIsEverywhere) {
    Ogre::ManualObject* const cloud = addCloud();
    EXPECT_LT(scene.nextFrameError().error, GoodFrame);
    EXPECT_EQ(last.fit.reason, FitReason::UnboundedBody);
    scene.stage.drawFrame();
    EXPECT_EQ(log.count("'cloud' has no bounds"), 1U);

    cloud->detachFromParent();
    expectGoodFrame();
    EXPECT_EQ(log.count("Lixel:"), 1U);
}

TEST_P(BadInput, InfiniteBoxAndViewWithoutEnd) {
    scene.stage.camera().setFarClipDistance(0);
    scene.stage.sceneManager().setShadowFarDistance(0);
    scene.stage.light().resetShadowFarDistance();
    Ogre::ManualObject* const cloud = addCloud();
    for (int i = 0; i < 3; ++i)
        scene.stage.drawFrame();
    EXPECT_EQ(last.fit.reason, FitReason::Unbounded);
    EXPECT_EQ(log.count("no shadow map for light 'Light'"), 1U);
    EXPECT_GE(scene.visibilityAt(InShadow), 128) << "without a map everything is lit";

    cloud->detachFromParent();
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
}

TEST_P(BadInput, EmptyScene) {
    scene.stage.sceneManager().getRootSceneNode()->removeChild(scene.box);
    scene.stage.sceneManager().getRootSceneNode()->removeChild(scene.ground);
    for (int i = 0; i < 3; ++i)
        scene.stage.drawFrame();
    EXPECT_FALSE(last.fit.hasMap());
    EXPECT_EQ(last.fit.reason, FitReason::NoReceivers);
    EXPECT_EQ(log.count("Lixel:"), 0U) << "a light that shadows nothing is no news";
    scene.stage.sceneManager().getRootSceneNode()->addChild(scene.ground);
    EXPECT_GE(scene.visibilityAt(InShadow), 128);
    scene.stage.sceneManager().getRootSceneNode()->addChild(scene.box);
    expectGoodFrame();
}

TEST_P(BadInput, ZeroSizeBox) {
    Ogre::SceneNode* const point = scene.addCube(Ogre::Vector3(5, 1, 0), Ogre::Vector3(0, 0, 0));
    expectGoodFrame();
    scene.box->setVisible(false);
    // Only the point casts: a focus region without area.
    EXPECT_LT(scene.nextFrameError().error, GoodFrame);
    EXPECT_GE(scene.visibilityAt(InShadow), 128);
    scene.box->setVisible(true);
    point->setVisible(false);
    expectGoodFrame();
    EXPECT_EQ(log.count("Lixel:"), 0U);
}

TEST_P(BadInput, LightAlongTheView) {
    scene.stage.light().getParentSceneNode()->setDirection(
        scene.stage.camera().getDerivedDirection(), Ogre::Node::TS_WORLD);
    EXPECT_LT(scene.nextFrameError().error, GoodFrame);
    EXPECT_TRUE(last.fit.hasMap());
    EXPECT_EQ(log.count("Lixel:"), 0U);
}

TEST_P(BadInput, LightAgainstTheView) {
    scene.stage.camera().getParentSceneNode()->setPosition(Ogre::Vector3(0, 2, 16));
    scene.stage.camera().getParentSceneNode()->lookAt(Ogre::Vector3(0, 2.5F, 0),
                                                      Ogre::Node::TS_WORLD);
    Ogre::Vector3 direction = -scene.stage.camera().getDerivedDirection();
    scene.stage.light().getParentSceneNode()->setDirection(direction, Ogre::Node::TS_WORLD);
    EXPECT_LT(scene.nextFrameError().error, GoodFrame);
    EXPECT_EQ(log.count("Lixel:"), 0U);
}

TEST_P(BadInput, LightStraightDown) {
    scene.stage.light().getParentSceneNode()->setDirection(Ogre::Vector3::NEGATIVE_UNIT_Y,
                                                           Ogre::Node::TS_WORLD);
    const Samples::ClassificationError error = scene.nextFrameError();
    EXPECT_LT(error.error, GoodFrame);
    EXPECT_TRUE(last.fit.hasMap());
    // Level with the ground, the light lies along the camera's up.
    scene.stage.camera().getParentSceneNode()->setPosition(Ogre::Vector3(0, 3, 16));
    scene.stage.camera().getParentSceneNode()->lookAt(Ogre::Vector3(0, 3, 0), Ogre::Node::TS_WORLD);
    EXPECT_LT(scene.nextFrameError().error, GoodFrame);
    EXPECT_EQ(log.count("Lixel:"), 0U);
}

TEST_P(BadInput, PointLightInsideACasterHasAConeOfShadowsAndSaysSo) {
    // It would need six maps, and has one.
    scene.stage.light().setType(Ogre::Light::LT_POINT);
    scene.stage.light().getParentSceneNode()->setPosition(Ogre::Vector3(0, 1, 0));
    for (int i = 0; i < 3; ++i)
        scene.stage.drawFrame();
    EXPECT_EQ(last.fit.reason, FitReason::PartOfLight);
    EXPECT_TRUE(last.fit.hasMap());
    EXPECT_EQ(log.count("light 'Light' shines too wide for the maps that it has"), 1U);
}

INSTANTIATE_TEST_SUITE_P(SceneManagers, BadInput, testing::Values("", "OctreeSceneManager"),
                         [](const auto& manager) {
                             return std::string(manager.param).empty() ? "Default" : "Octree";
                         });

} // namespace
} // namespace Lixel::Tests
