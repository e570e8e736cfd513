// Billboards, and so particles: OGRE turns them towards the camera that draws, in maps the light's.

#include "MaterialScene.h"

namespace Lixel::Tests {
namespace {

class Billboards : public testing::Test {
protected:
    Billboards() {
        for (Ogre::Light* light : scene.lights)
            light->setVisible(light == scene.lights.front());
        scene.box->setVisible(false);
        auto& manager = scene.stage.sceneManager();
        // A light that shines along -x and -y alone: a billboard that faced along z would be
        // edge-on.
        Ogre::BillboardSet* const billboards = manager.createBillboardSet(1);
        billboards->setDefaultDimensions(2, 2);
        const auto material = Ogre::MaterialManager::getSingleton()
                                  .getByName("Lixel/Surface")
                                  ->clone("Test/Billboard");
        material->setCullingMode(Ogre::CULL_NONE); // or it has no back, which is what casts
        billboards->setMaterial(material);
        billboards->createBillboard(0, 3, 0);
        billboards->setCastShadows(true);
        manager.getRootSceneNode()->createChildSceneNode()->attachObject(billboards);
        scene.draw();
    }

    /// At a place of the ground, relative to the middle of the shadow.
    bool isShadowed(const std::vector<int>& picture, Ogre::Real x, Ogre::Real z) {
        const std::size_t pixel = scene.pixelOf(Ogre::Vector3(-3 + x, 0, z));
        return picture[pixel] < 20;
    }

    MaterialScene scene{AdditiveTechnique, "Lixel/Receiver"};
};

TEST_F(Billboards, FaceTheLightInItsMap) {
    const std::vector<int> picture = scene.draw();
    scene.keepPicture("billboard");
    // 2 along z, and along x as a slope of 45 degrees makes them longer.
    for (const auto& [x, z] : {std::pair(0.0F, 0.0F),
                               {-1.3F, 0.0F},
                               {1.3F, 0.0F},
                               {0.0F, 0.9F},
                               {0.0F, -0.9F},
                               {-1.3F, -0.9F},
                               {-1.3F, 0.9F}})
        EXPECT_TRUE(isShadowed(picture, x, z)) << x << ", " << z;
    for (const auto& [x, z] : {std::pair(-1.6F, 0.0F), {1.6F, 0.0F}, {0.0F, 1.2F}, {0.0F, -1.2F}})
        EXPECT_FALSE(isShadowed(picture, x, z)) << x << ", " << z;
}

} // namespace
} // namespace Lixel::Tests
