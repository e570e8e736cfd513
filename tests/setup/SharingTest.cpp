// What comes before and after a setup: other lights, cameras, scene managers, OGRE's own setups.

#include "TestStage.h"

#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/ShadowCameraSetups.h>

namespace Lixel::Tests {
namespace {

TEST(Sharing, OneSurveyServesAllLights) {
    struct Surveys : ShadowMapObserver {
        Surveys() { addShadowMapObserver(*this); }
        void shadowMapFitted(const ShadowMap& map) override {
            taken += map.surveyMicroseconds > 0.0 ? 1 : 0;
            ++maps;
        }
        int taken = 0;
        int maps = 0;
    };
    BoxOnGround scene;
    Ogre::Light* const second = scene.stage.sceneManager().createLight("second");
    second->setType(Ogre::Light::LT_DIRECTIONAL);
    Ogre::SceneNode* const node =
        scene.stage.sceneManager().getRootSceneNode()->createChildSceneNode();
    node->attachObject(second);
    node->setDirection(Ogre::Vector3(1, -1, 0.5F), Ogre::Node::TS_WORLD);
    // One instance for both lights.
    second->setCustomShadowCameraSetup(scene.stage.light().getCustomShadowCameraSetup());
    scene.stage.sceneManager().setShadowTextureSettings(512, 2, Ogre::PF_FLOAT32_R);
    scene.stage.drawFrame();
    Surveys surveys;
    scene.stage.drawFrame();
    EXPECT_EQ(surveys.maps, 2);
    EXPECT_EQ(surveys.taken, 1);
}

/// Programs keep what another scene manager's light left in them.
TEST(Sharing, ASceneManagerWithoutSetupsHasNoShadows) {
    BoxOnGround scene;
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
    // The same once more, under OGRE's default setup.
    Ogre::SceneManager& other = *scene.stage.root().createSceneManager();
    other.setAmbientLight(Ogre::ColourValue::Black);
    other.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE);
    other.setShadowTextureSettings(512, 1, Ogre::PF_FLOAT32_R);
    other.setShadowFarDistance(100);
    Ogre::MaterialManager& materials = Ogre::MaterialManager::getSingleton();
    other.setShadowTextureCasterMaterial(materials.getByName("Lixel/Caster"));
    other.setShadowTextureReceiverMaterial(materials.getByName("Lixel/Receiver/Visibility"));
    Ogre::Entity* const ground = other.createEntity(Ogre::SceneManager::PT_CUBE);
    ground->setMaterial(materials.getByName("Lixel/Surface"));
    ground->setCastShadows(false);
    Ogre::SceneNode* const groundNode =
        other.getRootSceneNode()->createChildSceneNode(Ogre::Vector3(0, -0.5F, 0));
    groundNode->setScale(2, 0.01F, 2);
    groundNode->attachObject(ground);
    Ogre::Light* const sun = other.createLight();
    sun->setType(Ogre::Light::LT_DIRECTIONAL);
    Ogre::SceneNode* const sunNode = other.getRootSceneNode()->createChildSceneNode();
    sunNode->attachObject(sun);
    sunNode->setDirection(Ogre::Vector3(-1, -1, 0), Ogre::Node::TS_WORLD);
    Ogre::Camera* const viewer = other.createCamera("Other");
    viewer->setNearClipDistance(0.1F);
    Ogre::SceneNode* const viewerNode =
        other.getRootSceneNode()->createChildSceneNode(Ogre::Vector3(0, 8, 16));
    viewerNode->attachObject(viewer);
    viewerNode->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
    scene.stage.viewport().setCamera(viewer);
    for (int i = 0; i < 2; ++i) {
        scene.stage.drawFrame();
        const std::vector<std::uint8_t> picture = scene.stage.picture();
        // The middle of the picture, where the box shadows the ground in the other scene manager.
        const std::size_t middle = 3 * (120 * 320 + 150);
        for (std::size_t pixel = 0; pixel < 40; ++pixel)
            EXPECT_GE(picture[middle + 3 * pixel], 128) << pixel;
    }
    scene.stage.viewport().setCamera(&scene.stage.camera());
}

/// OGRE takes the first light's second map for the second light's; it is an error in the log.
TEST(Sharing, ModulativeLightsWithSeveralTexturesKeepTheReceiver) {
    BoxOnGround scene;
    LogCollector log;
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    manager.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE);
    const Ogre::MaterialPtr receiver =
        Ogre::MaterialManager::getSingleton().getByName("Lixel/Receiver/Modulative");
    manager.setShadowTextureReceiverMaterial(receiver);
    manager.setShadowTextureCountPerLightType(Ogre::Light::LT_SPOTLIGHT, 2);
    manager.setShadowTextureCount(4);
    scene.stage.light().setType(Ogre::Light::LT_SPOTLIGHT);
    scene.stage.light().getParentSceneNode()->setPosition(6, 6, 0);
    Ogre::Light* const second = manager.createLight("second");
    second->setType(Ogre::Light::LT_SPOTLIGHT);
    Ogre::SceneNode* const node =
        manager.getRootSceneNode()->createChildSceneNode(Ogre::Vector3(-6, 6, 0));
    node->attachObject(second);
    node->setDirection(Ogre::Vector3(1, -1, 0), Ogre::Node::TS_WORLD);
    second->setCustomShadowCameraSetup(scene.stage.light().getCustomShadowCameraSetup());
    scene.stage.drawFrame();
    scene.stage.drawFrame();
    EXPECT_EQ(receiver->getTechnique(0)->getPass(0)->getNumTextureUnitStates(), 1U)
        << "OGRE added its texture spot_shadow_fade.dds, which is nowhere";
    EXPECT_NO_THROW(receiver->reload());
    EXPECT_EQ(log.count("uses more than one of a light only under an integrated"), 2U);
}

/// Points are told in the world, and reach the fit wherever the viewer stands.
TEST(Sharing, VisiblePointsDecideTheWarp) {
    BoxOnGround scene("", "Optimal");
    LastMap last;
    const auto warpFor = [&](const Vec3& point) {
        // A new instance: a used one follows its last warp.
        const auto setup = std::make_shared<OptimalShadowCameraSetup>();
        std::vector<VisiblePoint> points;
        for (int i = 0; i < 20; ++i)
            points.push_back({point + Vec3(-0.02 * i, 0.0, 0.01 * i), Vec3::UnitY()});
        setup->setVisiblePoints(points);
        scene.stage.setShadowSetup(setup);
        scene.stage.drawFrame();
        return last.fit.liWarp;
    };
    // Both ends of the box' shadow, which are all that matters in turn.
    const Vec2 near = warpFor(Vec3(-1.5, 0.0, 0.5));
    const Vec2 far = warpFor(Vec3(-2.5, 0.0, -0.8));
    EXPECT_GT((near - far).norm(), 0.1 * (near.norm() + far.norm()));
    EXPECT_GT(near.norm() + far.norm(), 0.0);
}

TEST(Sharing, OgresOwnSetupsFollowUndisturbed) {
    BoxOnGround scene;
    const auto draw = [&](const Ogre::ShadowCameraSetupPtr& setup) {
        scene.stage.setShadowSetup(setup);
        scene.stage.drawFrame();
        scene.stage.drawFrame();
        return scene.stage.picture();
    };
    const auto before = draw(Samples::findShadowSetup("Ogre-Focused")->create());
    const auto xpsm = draw(XPSMShadowCameraSetup::create());
    const auto after = draw(Samples::findShadowSetup("Ogre-Focused")->create());
    EXPECT_EQ(before, after) << "something of ours is left in the shadow camera";
    EXPECT_NE(before, xpsm);
}

/// OGRE 13.6 and newer give each shadow camera a culling frustum of its own, and crash where it is
/// gone in the next frame.
/// As OGRE's deferred shading sample: a camera of its own, in the main viewport.
TEST(Sharing, ACameraOfTheApplicationsGetsMatricesAlone) {
    BoxOnGround scene;
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    scene.stage.drawFrame();
    LastMap published;
    const int before = published.count;
    Ogre::Frustum* culling = nullptr;
    {
        Ogre::Camera own("own", &manager);
        for (Ogre::Viewport* viewport :
             {&scene.stage.viewport(), static_cast<Ogre::Viewport*>(nullptr)}) {
            own._notifyViewport(viewport);
            scene.stage.light().getCustomShadowCameraSetup()->getShadowCamera(
                &manager, &scene.stage.camera(), &scene.stage.viewport(), &scene.stage.light(),
                &own, 0);
            EXPECT_TRUE(own.isCustomProjectionMatrixEnabled());
            EXPECT_EQ(own.getCullingFrustum(), culling);
        }
    }
    EXPECT_EQ(published.count, before);
    EXPECT_TRUE(scene.stage.viewport().isAutoUpdated());
    EXPECT_LT(scene.nextFrameError().error, 0.5) << "the window is drawn as before";
}

/// Drops the last reference to a light's setup between the preparation of its map and its drawing.
class DropsSetup : public SceneManagerListener {
public:
    explicit DropsSetup(Ogre::SceneManager& manager) : mManager(manager) {
        addSceneManagerListener(mManager, *this);
    }
    ~DropsSetup() override { removeSceneManagerListener(mManager, *this); }
    void shadowTextureCasterPreViewProj(Ogre::Light* light, Ogre::Camera*, std::size_t) override {
        light->resetCustomShadowCameraSetup();
        ++count;
    }
    int count = 0;

private:
    Ogre::SceneManager& mManager;
};

TEST(Sharing, TheLastReferenceToASetupMayGoBeforeItsPass) {
    BoxOnGround scene;
    DropsSetup drops(scene.stage.sceneManager());
    scene.stage.drawFrame();
    scene.stage.drawFrame();
    EXPECT_GT(drops.count, 0);
}

TEST(Sharing, AShadowCamerasCullingFrustumIsBackAfterItsPass) {
    BoxOnGround scene;
    scene.stage.drawFrame();
    Ogre::Camera& shadowCamera = *scene.stage.sceneManager()
                                      .getShadowTexture(0)
                                      ->getBuffer()
                                      ->getRenderTarget()
                                      ->getViewport(0)
                                      ->getCamera();
    Ogre::Camera* const own = scene.stage.sceneManager().createCamera("own culling frustum");
    scene.stage.sceneManager().getRootSceneNode()->createChildSceneNode()->attachObject(own);
    Ogre::Frustum* const before = shadowCamera.getCullingFrustum();
    shadowCamera.setCullingFrustum(own);
    EXPECT_LT(scene.visibilityAt(InShadow), 128) << "ours decides while the map is drawn";
    EXPECT_EQ(shadowCamera.getCullingFrustum(), own);
    // Without a map the pass is left out, and nothing may change either.
    scene.box->setVisible(false);
    scene.stage.drawFrame();
    EXPECT_EQ(shadowCamera.getCullingFrustum(), own);
    shadowCamera.setCullingFrustum(before);
}

TEST(Sharing, TwoCamerasInOneFrame) {
    BoxOnGround scene;
    Ogre::Camera* const other = scene.stage.sceneManager().createCamera("Other");
    Ogre::SceneNode* const node =
        scene.stage.sceneManager().getRootSceneNode()->createChildSceneNode();
    node->attachObject(other);
    node->setPosition(0, 8, -16);
    node->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
    other->setNearClipDistance(0.1F);
    other->setAspectRatio(4.0F / 3.0F);
    const Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().createManual(
        "OtherView", "General", Ogre::TEX_TYPE_2D, 320, 240, 0, Ogre::PF_BYTE_RGB,
        Ogre::TU_RENDERTARGET);
    texture->getBuffer()->getRenderTarget()->addViewport(other);
    // The texture is drawn in the same frame as the window, before it.
    EXPECT_LT(scene.nextFrameError().error, 0.5);
    EXPECT_LT(scene.nextFrameError().error, 0.5);
}

TEST(Sharing, LightsMayComeAndGo) {
    BoxOnGround scene;
    scene.stage.drawFrame();
    for (int i = 0; i < 20; ++i) {
        Ogre::Light* const light = scene.stage.sceneManager().createLight();
        light->setType(Ogre::Light::LT_DIRECTIONAL);
        light->setCustomShadowCameraSetup(scene.stage.light().getCustomShadowCameraSetup());
        Ogre::SceneNode* const node =
            scene.stage.sceneManager().getRootSceneNode()->createChildSceneNode();
        node->attachObject(light);
        scene.stage.drawFrame();
        scene.stage.sceneManager().destroySceneNode(node);
        scene.stage.sceneManager().destroyLight(light);
        scene.stage.drawFrame();
    }
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
}

TEST(Sharing, SceneManagersMayComeAndGo) {
    BoxOnGround scene;
    scene.stage.drawFrame();
    const Ogre::ShadowCameraSetupPtr setup = scene.stage.light().getCustomShadowCameraSetup();
    for (int i = 0; i < 3; ++i) {
        Ogre::SceneManager* const manager = scene.stage.root().createSceneManager();
        manager->setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE);
        Ogre::Light* const light = manager->createLight("Light");
        light->setType(Ogre::Light::LT_DIRECTIONAL);
        light->setCustomShadowCameraSetup(setup);
        manager->getRootSceneNode()->createChildSceneNode()->attachObject(light);
        Ogre::Camera* const camera = manager->createCamera("Camera");
        manager->getRootSceneNode()->createChildSceneNode()->attachObject(camera);
        Ogre::Viewport* const viewport = scene.stage.window().addViewport(camera, 1 + i);
        scene.stage.drawFrame();
        scene.stage.window().removeViewport(viewport->getZOrder());
        scene.stage.root().destroySceneManager(manager);
        scene.stage.drawFrame();
    }
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
}

/// Where things were when an application asked for matrices is not where they are drawn.
TEST(Sharing, MatricesAskedForAloneLeaveNothingBehind) {
    std::array<Mat4, 2> drawn;
    for (const bool asks : {false, true}) {
        BoxOnGround scene("", "Uniform");
        scene.stage.drawFrame();
        if (asks) {
            Ogre::Camera own("own", &scene.stage.sceneManager());
            own._notifyViewport(&scene.stage.viewport());
            scene.stage.light().getCustomShadowCameraSetup()->getShadowCamera(
                &scene.stage.sceneManager(), &scene.stage.camera(), &scene.stage.viewport(),
                &scene.stage.light(), &own, 0);
        }
        // It receives its shadow where it goes.
        scene.ground->setPosition(0, -1, 0);
        LastMap published;
        scene.stage.drawFrame();
        ASSERT_TRUE(published.fit.hasMap());
        drawn[asks ? 1 : 0] = published.fit.clipFromWorld;
    }
    EXPECT_EQ(drawn[0], drawn[1]);
}

} // namespace
} // namespace Lixel::Tests
