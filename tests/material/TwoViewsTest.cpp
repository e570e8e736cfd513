// Three lights of three kinds with a setup each, in two viewports: each as if it were alone.

#include "MaterialScene.h"

#include <Lixel/setup/ShadowCameraSetups.h>

#include <algorithm>
#include <array>

namespace Lixel::Tests {
namespace {

struct Way {
    const char* name;
    Ogre::ShadowTechnique technique;
    const char* receiver;
    const char* surface;
};

class TwoViewsScene : public MaterialScene {
public:
    explicit TwoViewsScene(const Way& way) : MaterialScene(way.technique, way.receiver) {
        wear(way.surface);
        // Each map of a frame depends on that frame alone: Optimal and XPSM remember the last one.
        lights[0]->setCustomShadowCameraSetup(LiSPSMShadowCameraSetup::create());
        lights[1]->setType(Ogre::Light::LT_POINT);
        lights[1]->getParentSceneNode()->setPosition(4, 9, 3);
        lights[1]->setAttenuation(100, 1, 0, 0);
        lights[1]->setCustomShadowCameraSetup(UniformShadowCameraSetup::create());
        lights[2]->setCustomShadowCameraSetup(TrapezoidalShadowCameraSetup::create());
        viewports = {&stage.viewport(), &addView()};
        constexpr Ogre::Real Half = 0.5F;
        for (std::size_t i = 0; i < viewports.size(); ++i) {
            viewports[i]->setDimensions(static_cast<Ogre::Real>(i) * Half, 0, Half, 1);
            Ogre::Camera& camera = *viewports[i]->getCamera();
            camera.setAspectRatio(static_cast<Ogre::Real>(viewports[i]->getActualWidth()) /
                                  static_cast<Ogre::Real>(viewports[i]->getActualHeight()));
        }
    }

    /// What is drawn with one light and in one viewport, in that viewport's half of the picture.
    std::vector<int> drawAlone(const Ogre::Light& light, const Ogre::Viewport& viewport) {
        for (Ogre::Light* other : lights)
            other->setVisible(other == &light);
        for (Ogre::Viewport* other : viewports)
            other->setAutoUpdated(other == &viewport);
        std::vector<int> picture = draw();
        const auto width = static_cast<std::size_t>(stage.window().getWidth());
        const auto left = static_cast<std::size_t>(viewport.getActualLeft());
        const auto end = left + static_cast<std::size_t>(viewport.getActualWidth());
        for (std::size_t i = 0; i < picture.size(); ++i)
            if (i % width < left || i % width >= end) picture[i] = 0;
        for (Ogre::Light* other : lights)
            other->setVisible(true);
        for (Ogre::Viewport* other : viewports)
            other->setAutoUpdated(true);
        return picture;
    }

    std::array<Ogre::Viewport*, 2> viewports{};

private:
    Ogre::Viewport& addView() {
        Ogre::SceneManager& manager = stage.sceneManager();
        Ogre::Camera* const camera = manager.createCamera("second");
        camera->setNearClipDistance(0.1F);
        Ogre::SceneNode* const node =
            manager.getRootSceneNode()->createChildSceneNode(Ogre::Vector3(-12, 5, -6));
        node->attachObject(camera);
        node->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
        return *stage.window().addViewport(camera, 1);
    }
};

class TwoViews : public testing::TestWithParam<Way> {};

TEST_P(TwoViews, AreTheSumOfEachLightInEachViewAlone) {
    TwoViewsScene scene(GetParam());
    scene.draw();
    const std::vector<int> together = scene.draw();
    scene.keepPicture(std::string("two-views-") + GetParam().name);
    std::vector<int> sum(together.size(), 0);
    for (const Ogre::Viewport* viewport : scene.viewports)
        for (Ogre::Light* light : scene.lights) {
            const std::vector<int> alone = scene.drawAlone(*light, *viewport);
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] += alone[i];
            light->setCastShadows(false);
            EXPECT_GT(differing(alone, scene.drawAlone(*light, *viewport)), 0.5)
                << light->getName() << " has no shadow there: nothing was compared";
            light->setCastShadows(true);
        }
    for (int& value : sum)
        value = std::min(value, 255);
    constexpr double AtEdges = 0.05; // percent of pixels, by rounding
    EXPECT_LT(differing(together, sum), AtEdges);
}

INSTANTIATE_TEST_SUITE_P(
    Materials, TwoViews,
    testing::Values(Way{"additive", AdditiveTechnique, "Lixel/Receiver/Bilinear", "Lixel/Surface"},
                    Way{"integrated", IntegratedTechnique, "", "Lixel/Surface/Integrated"}),
    [](const testing::TestParamInfo<Way>& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace Lixel::Tests
