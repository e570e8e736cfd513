// Local lights under camera-relative rendering: they stay where they are when cameras move or go.

#include "TestStage.h"

namespace Lixel::Tests {
namespace {

class CameraRelative : public testing::Test {
protected:
    CameraRelative() {
        Ogre::Light& light = scene.stage.light();
        light.setType(Ogre::Light::LT_SPOTLIGHT);
        light.setAttenuation(1000, 1, 0, 0);
        light.setSpotlightRange(Ogre::Degree(60), Ogre::Degree(80));
        light.getParentSceneNode()->setPosition(6, 6, 3);
        light.getParentSceneNode()->setDirection(Ogre::Vector3(-6, -6, -3), Ogre::Node::TS_WORLD);
    }

    std::vector<std::uint8_t> pictureWith(bool relative) {
        scene.stage.sceneManager().setCameraRelativeRendering(relative);
        scene.stage.drawFrame();
        return scene.stage.picture();
    }

    /// Camera-relative rendering draws the same picture, up to rounding.
    void expectSamePicture() {
        const std::vector<std::uint8_t> relative = pictureWith(true);
        const std::vector<std::uint8_t> absolute = pictureWith(false);
        std::size_t different = 0;
        for (std::size_t i = 0; i < absolute.size(); ++i)
            different += std::abs(absolute[i] - relative[i]) > 8 ? 1U : 0U;
        EXPECT_LT(different, absolute.size() / 200);
    }

    BoxOnGround scene;
};

TEST_F(CameraRelative, LightStaysWhereItIs) {
    pictureWith(true);
    Ogre::SceneNode& viewer = *scene.stage.camera().getParentSceneNode();
    viewer.setPosition(9, 8, 10);
    viewer.lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
    expectSamePicture();
}

TEST_F(CameraRelative, LightOutlivesACamera) {
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    for (int i = 0; i < 20; ++i) {
        Ogre::Camera* const other = manager.createCamera("Other" + std::to_string(i));
        Ogre::SceneNode* const node = manager.getRootSceneNode()->createChildSceneNode();
        node->attachObject(other);
        node->setPosition(0, 8, 16);
        scene.stage.viewport().setCamera(other);
        pictureWith(true);
        scene.stage.viewport().setCamera(&scene.stage.camera());
        manager.destroyCamera(other);
        manager.destroySceneNode(node);
        scene.stage.light().getParentSceneNode()->setPosition(6, 6 + 0.1F * static_cast<float>(i),
                                                              3);
        expectSamePicture();
    }
}

} // namespace
} // namespace Lixel::Tests
