// One program for many: objects with other lights, viewports with other cameras, scene managers.

#include "ShaderSystemScene.h"

#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/ShadowCameraSetups.h>

namespace Lixel::Tests {
namespace {

/// The left half of a picture, or with 1 the right one.
Picture halfOf(const Picture& picture, std::size_t half) {
    constexpr std::size_t RowBytes = std::size_t{3} * 320;
    Picture found;
    for (std::size_t row = half * RowBytes / 2; row < picture.size(); row += RowBytes) {
        const auto begin = picture.begin() + static_cast<std::ptrdiff_t>(row);
        found.insert(found.end(), begin, begin + RowBytes / 2);
    }
    return found;
}

class ShaderSystemSharing : public testing::Test {
protected:
    ShaderSystemSharing() {
        scene.addSun();
        scene.addSpot();
        scene.addLamp();
        scene.setMaps(3, 1, 6);
        Lixel::ShaderSystem::enable(scene.shaderSystem.generator);
        useLightMasksOfObjects(true);
    }
    ~ShaderSystemSharing() override { useLightMasksOfObjects(false); }

    /// The sum of what is drawn with each light alone.
    Picture sumOfLights(const std::vector<std::string>& names = {"sun", "spot", "lamp"}) {
        std::vector<int> sum;
        for (const std::string& alone : names) {
            for (const std::string& name : names)
                scene.manager().getLight(name)->setVisible(name == alone);
            const Picture picture = scene.draw();
            sum.resize(picture.size());
            for (std::size_t i = 0; i < picture.size(); ++i)
                sum[i] += picture[i];
        }
        for (const std::string& name : names)
            scene.manager().getLight(name)->setVisible(true);
        Picture rounded(sum.size());
        for (std::size_t i = 0; i < sum.size(); ++i)
            rounded[i] = static_cast<std::uint8_t>(std::min(sum[i], 255));
        return rounded;
    }

    ShaderSystemScene scene;
};

TEST_F(ShaderSystemSharing, LightsAreSummedUpEachWithItsOwnShadow) {
    const Picture all = scene.draw();
    EXPECT_TRUE(isSame(all, sumOfLights()));
}

/// OGRE sorts each object's lights anew, and leaves those out that its mask excludes. Lixel's own
/// surface is no reference here: OGRE gives its passes the maps of another light.
TEST_F(ShaderSystemSharing, ObjectsWithOtherLightMasksShareAMaterial) {
    const Picture unmasked = scene.draw();
    constexpr Ogre::uint32 Sun = 1, Spot = 2, Lamp = 4;
    scene.manager().getLight("sun")->setLightMask(Sun);
    scene.manager().getLight("spot")->setLightMask(Spot);
    scene.manager().getLight("lamp")->setLightMask(Lamp);
    const auto mask = [](Ogre::SceneNode* node, Ogre::uint32 lights) {
        static_cast<Ogre::Entity*>(node->getAttachedObject(0))->setLightMask(lights);
    };
    mask(scene.ground, Spot | Lamp);
    mask(scene.box, Lamp);
    const Picture masked = scene.draw();
    scene.keepPicture("masks");
    EXPECT_TRUE(isOther(masked, unmasked));
    EXPECT_TRUE(isSame(masked, sumOfLights()));
}

/// Each object has one of two spots, in the same place of the program.
TEST_F(ShaderSystemSharing, ObjectsWithOtherLightsOfAKindShareAMaterial) {
    for (const char* name : {"sun", "lamp"})
        scene.manager().destroyLight(name);
    Ogre::Light& first = *scene.manager().getLight("spot");
    Ogre::Light& second = *scene.manager().createLight("second");
    second.setType(Ogre::Light::LT_SPOTLIGHT);
    second.setDiffuseColour(0.3F, 0.2F, 0.2F);
    second.setSpotlightRange(Ogre::Degree(50), Ogre::Degree(60));
    second.setAttenuation(100, 1, 0, 0);
    second.setCustomShadowCameraSetup(XPSMShadowCameraSetup::create());
    Ogre::SceneNode* const node =
        scene.manager().getRootSceneNode()->createChildSceneNode(Ogre::Vector3(-9, 6, 2));
    node->attachObject(&second);
    node->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
    scene.setMaps(0, 2, 0);
    scene.manager().setShadowTextureCountPerLightType(Ogre::Light::LT_SPOTLIGHT, 1);
    first.setLightMask(1);
    second.setLightMask(2);
    static_cast<Ogre::Entity*>(scene.ground->getAttachedObject(0))->setLightMask(1);
    for (const char* other : {"Cube1", "Cube2", "Cube3"})
        scene.manager().getEntity(other)->setLightMask(2);
    const Picture masked = scene.draw();
    scene.keepPicture("masked-spots");
    EXPECT_TRUE(isSame(masked, sumOfLights({"spot", "second"})));
}

/// OGRE begins with the start light's textures in such a pass.
TEST_F(ShaderSystemSharing, PassesDivideTheLights) {
    const Picture all = scene.draw();
    ShaderSystemScene::parse(R"(
        material Test/TwoPasses
        {
            technique
            {
                pass
                {
                    max_lights 1
                }
                pass
                {
                    start_light 1
                    scene_blend add
                }
            }
        })");
    scene.wear("Test/TwoPasses");
    const Picture divided = scene.draw();
    scene.keepPicture("two-passes");
    EXPECT_TRUE(isSame(divided, all));
}

TEST_F(ShaderSystemSharing, MovingLightsAndObjectsTakeTheirShadowsAlong) {
    scene.draw();
    scene.box->translate(2, 0, 1);
    scene.manager().getLight("lamp")->getParentSceneNode()->translate(-4, 1, 1);
    scene.manager().getLight("sun")->getParentSceneNode()->setDirection(
        Ogre::Vector3(0.5F, -1, -0.4F), Ogre::Node::TS_WORLD);
    const Picture moved = scene.draw();
    EXPECT_TRUE(isSame(moved, scene.drawLixels()));
}

TEST_F(ShaderSystemSharing, ViewportsHaveCamerasOfTheirOwn) {
    Ogre::Camera& second = *scene.manager().createCamera("second");
    second.setNearClipDistance(0.1F);
    second.setAspectRatio(160.0F / 240.0F);
    scene.stage.camera().setAspectRatio(160.0F / 240.0F);
    Ogre::SceneNode* const node =
        scene.manager().getRootSceneNode()->createChildSceneNode(Ogre::Vector3(-12, 5, -6));
    node->attachObject(&second);
    node->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
    Ogre::Viewport& left = scene.stage.viewport();
    left.setDimensions(0, 0, 0.5F, 1);
    Ogre::Viewport& right = *scene.stage.window().addViewport(&second, 1, 0.5F, 0, 0.5F, 1);
    const Ogre::String own = right.getMaterialScheme();
    right.setMaterialScheme(StartedShaderSystem::Scheme);
    scene.draw();
    const Picture both = scene.draw();
    scene.keepPicture("viewports");
    // With one viewport drawn and one light on at a time.
    left.setAutoUpdated(false);
    EXPECT_TRUE(isSame(halfOf(both, 1), halfOf(sumOfLights(), 1)));
    right.setAutoUpdated(false);
    left.setAutoUpdated(true);
    EXPECT_TRUE(isSame(halfOf(both, 0), halfOf(sumOfLights(), 0)));
    right.setAutoUpdated(true);
    right.setMaterialScheme(own);
    EXPECT_TRUE(isSame(both, scene.drawLixels()));
}

TEST_F(ShaderSystemSharing, CameraRelativeRenderingIsRightFarFromTheOrigin) {
    const Picture near = scene.draw();
    scene.manager().setCameraRelativeRendering(true);
    const Picture relative = scene.draw();
    EXPECT_TRUE(isSame(relative, near));
    EXPECT_TRUE(isSame(relative, scene.drawLixels()));
    // Positions are floats: steps of 1/32 here, so everything is where it can be told exactly.
    const Ogre::Vector3 far(262144, 0, -262144);
    for (const auto& child : scene.manager().getRootSceneNode()->getChildren())
        child->translate(far);
    const Picture farAway = scene.draw();
    scene.keepPicture("far-away");
    EXPECT_TRUE(isSame(farAway, scene.drawLixels()));
}

/// Both read by the programs that the first one's frame made, with fewer textures.
TEST_F(ShaderSystemSharing, SceneManagersHaveTexturesOfTheirOwn) {
    const Picture first = scene.draw();
    Ogre::SceneManager& other = *scene.stage.root().createSceneManager();
    other.setAmbientLight(Ogre::ColourValue::Black);
    other.setShadowFarDistance(100);
    other.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    other.setShadowTextureCasterMaterial(
        Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster"));
    other.setShadowTextureSettings(512, 1, Ogre::PF_FLOAT32_R);
    scene.shaderSystem.generator.addSceneManager(&other);
    const auto addBox = [&](const Ogre::Vector3& position, const Ogre::Vector3& size) {
        Ogre::Entity* const box = other.createEntity(Ogre::SceneManager::PT_CUBE);
        box->setMaterialName(ShaderSystemScene::Plain);
        Ogre::SceneNode* const node = other.getRootSceneNode()->createChildSceneNode(position);
        node->setScale(size / 100);
        node->attachObject(box);
    };
    addBox(Ogre::Vector3(0, -0.5F, 0), Ogre::Vector3(200, 1, 200));
    addBox(Ogre::Vector3(1, 2, 1), Ogre::Vector3(2, 4, 1));
    Ogre::Light& spot = *other.createLight("other");
    spot.setType(Ogre::Light::LT_SPOTLIGHT);
    spot.setSpotlightRange(Ogre::Degree(50), Ogre::Degree(60));
    spot.setAttenuation(100, 1, 0, 0);
    spot.setCustomShadowCameraSetup(XPSMShadowCameraSetup::create());
    Ogre::SceneNode* const light =
        other.getRootSceneNode()->createChildSceneNode(Ogre::Vector3(6, 9, -6));
    light->attachObject(&spot);
    light->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
    Ogre::Camera& camera = *other.createCamera("other");
    camera.setNearClipDistance(0.1F);
    camera.setAspectRatio(scene.stage.camera().getAspectRatio());
    Ogre::SceneNode* const viewer =
        other.getRootSceneNode()->createChildSceneNode(Ogre::Vector3(0, 8, 16));
    viewer->attachObject(&camera);
    viewer->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);

    const auto show = [&](Ogre::Camera& shown) {
        scene.stage.viewport().setCamera(&shown);
        return scene.draw();
    };
    const Picture second = show(camera);
    scene.keepPicture("second-scene-manager");
    spot.setCastShadows(false);
    EXPECT_TRUE(isOther(second, show(camera))) << "its shadow";
    spot.setCastShadows(true);
    EXPECT_TRUE(isSame(show(scene.stage.camera()), first));
    EXPECT_TRUE(isSame(show(camera), second));
    scene.stage.viewport().setCamera(&scene.stage.camera());
    scene.shaderSystem.generator.removeSceneManager(&other);
    scene.stage.root().destroySceneManager(&other);
    EXPECT_TRUE(isSame(scene.draw(), first));
}

} // namespace
} // namespace Lixel::Tests
