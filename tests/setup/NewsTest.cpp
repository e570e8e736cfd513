// What the log says of a light, and how often.

#include "TestStage.h"

#include <Lixel/setup/News.h>

namespace Lixel::Tests {
namespace {

const char* const TooFew = "light 'Light' shines too wide for the maps that it has";

/// A light that would need six maps, and has one.
void makePoint(Ogre::Light& light) {
    light.setType(Ogre::Light::LT_POINT);
    light.getParentSceneNode()->setPosition(0, 1, 0);
}

TEST(News, EachKindOnce) {
    News news;
    EXPECT_TRUE(news.isNew(3, 0)) << "in the first frame of all";
    EXPECT_FALSE(news.isNew(3, 0));
    EXPECT_TRUE(news.isNew(31, 0));
    EXPECT_FALSE(news.isNew(3, 1));
    EXPECT_FALSE(news.isNew(31, News::Quiet));
}

TEST(News, AgainAfterLongPeace) {
    News news;
    EXPECT_TRUE(news.isNew(0, 100));
    // As long as it goes on, or comes back soon, it is old.
    for (unsigned long frame = 100; frame < 10 * News::Quiet; frame += News::Quiet)
        EXPECT_FALSE(news.isNew(0, frame));
    News other;
    EXPECT_TRUE(other.isNew(0, 100));
    EXPECT_FALSE(other.isNew(0, 100 + News::Quiet));
    EXPECT_TRUE(other.isNew(0, 100 + 2 * News::Quiet + 1));
}

TEST(News, AgainUnderANewRootWhoseFramesCountFromZero) {
    News news;
    EXPECT_TRUE(news.isNew(0, 5000));
    EXPECT_TRUE(news.isNew(0, 0));
}

TEST(News, AFlickeringLightIsToldOfOnce) {
    BoxOnGround scene;
    LogCollector log;
    for (int i = 0; i < 20; ++i) {
        if (i % 2 == 0)
            makePoint(scene.stage.light());
        else
            scene.stage.light().setType(Ogre::Light::LT_DIRECTIONAL);
        scene.stage.drawFrame();
    }
    EXPECT_EQ(log.count(TooFew), 1U);
}

TEST(News, ALightIsToldOfOnceForAllCameras) {
    BoxOnGround scene;
    LogCollector log;
    makePoint(scene.stage.light());
    for (int i = 1; i < 4; ++i) {
        Ogre::Camera* const camera = scene.stage.sceneManager().createCamera(std::to_string(i));
        scene.stage.sceneManager().getRootSceneNode()->createChildSceneNode()->attachObject(camera);
        camera->getParentSceneNode()->setPosition(0, 8, 16);
        camera->getParentSceneNode()->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
        camera->setNearClipDistance(0.1F);
        scene.stage.window().addViewport(camera, i, 0.2F * static_cast<float>(i), 0, 0.2F, 0.2F);
    }
    scene.stage.drawFrame();
    scene.stage.drawFrame();
    EXPECT_EQ(log.count(TooFew), 1U);
}

} // namespace
} // namespace Lixel::Tests
