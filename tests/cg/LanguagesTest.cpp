// Lixel's own programs in each of their languages: one scene, the same picture.
#include "DrawingOgre.h"
#include "FreshOgre.h"

#include <Lixel/material/ShadowMaterials.h>
#include <Lixel/setup/CascadesShadowCameraSetup.h>
#include <Lixel/setup/MeshPreparation.h>
#include <Lixel/setup/ShadowCameraSetups.h>

#include <OgreImage.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

namespace Lixel::Tests {
namespace {

using Colour = Ogre::ColourValue;

constexpr Ogre::uint32 Side = 320;
/// Of the pictures' pixels: what rounding in another order may move across a shadow's edge.
constexpr double GreatestShare = 1e-4;
/// A difference of two colours that is no difference.
constexpr int Rounding = 2;

struct Way {
    const char* name;
    Ogre::ShadowTechnique technique;
    const char* receiver; ///< null under an integrated technique
    const char* surface;
    std::size_t maps;
    bool fenceFirst = false; ///< whether the fence is drawn before all else
};

const Way Ways[] = {
    {"Additive", Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear", "Lixel/Surface", 1},
    {"Integrated", Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, nullptr,
     "Lixel/Surface/Integrated", 1},
    {"Cascades", Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, nullptr,
     "Lixel/Surface/Integrated/Maps3", 3},
    {"Modulative", Ogre::SHADOWTYPE_TEXTURE_MODULATIVE, "Lixel/Receiver/Modulative/Bilinear",
     "Lixel/Surface", 1}};

/// A ground, two bodies and a fence with holes, in the sun, with fog.
class LanguageScene {
public:
    LanguageScene(const FreshOgre::Options& options, const Way& way) : mOgre(options) {
        mOgre.readScripts();
        mScene = mOgre.root().createSceneManager();
        mScene->setAmbientLight(Colour(0.25F, 0.25F, 0.3F));
        mScene->setFog(Ogre::FOG_LINEAR, Colour(0.5F, 0.6F, 0.7F), 0, 5, 60);
        castShadows(way);
        addBodies(way.surface, way.fenceFirst);
        addLight(way.maps);
        Ogre::Camera* const viewer = mScene->createCamera("");
        viewer->setNearClipDistance(0.1F);
        viewer->setFarClipDistance(200);
        viewer->setAspectRatio(1);
        place(viewer, {3, 5, 10})->lookAt({0, 1, 0}, Ogre::Node::TS_WORLD);
        mOgre.window().addViewport(viewer)->setBackgroundColour(Colour(0.4F, 0.5F, 0.6F));
    }

    std::vector<std::uint8_t> draw() {
        mOgre.root().renderOneFrame();
        mOgre.root().renderOneFrame();
        return mOgre.picture();
    }

private:
    void castShadows(const Way& way) {
        mScene->setShadowTextureSelfShadow(true);
        mScene->setShadowTexturePixelFormat(Ogre::PF_FLOAT32_R);
        mScene->setShadowTextureSize(512);
        mScene->setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, way.maps);
        mScene->setShadowTextureCount(way.maps);
        mScene->setShadowColour(Colour(0.4F, 0.4F, 0.5F));
        mScene->setShadowTechnique(way.technique);
        if (way.receiver != nullptr)
            setShadowMaterials(*mScene, way.receiver);
        else
            setShadowMaterials(*mScene);
    }

    void addLight(std::size_t maps) {
        Ogre::Light* const sun = mScene->createLight();
        sun->setType(Ogre::Light::LT_DIRECTIONAL);
        place(sun, {0, 0, 0})->setDirection({-2, -3, -1}, Ogre::Node::TS_WORLD);
        if (maps > 1)
            sun->setCustomShadowCameraSetup(CascadesShadowCameraSetup::create());
        else
            sun->setCustomShadowCameraSetup(OptimalShadowCameraSetup::create());
    }

    void addBodies(const std::string& surface, bool fenceFirst) {
        Ogre::Entity* const ground = mScene->createEntity(Ogre::SceneManager::PT_CUBE);
        ground->setMaterial(coloured(surface, "ground", Colour(0.6F, 0.7F, 0.5F)));
        place(ground, {0, -0.5F, 0})->setScale(0.6F, 0.01F, 0.6F);
        Ogre::Entity* const cube = mScene->createEntity(Ogre::SceneManager::PT_CUBE);
        cube->setMaterial(coloured(surface, "cube", Colour(0.8F, 0.4F, 0.3F)));
        Ogre::SceneNode* const node = place(cube, {-2, 1, 2});
        node->setScale(0.02F, 0.02F, 0.02F);
        node->yaw(Ogre::Degree(30));
        Ogre::Entity* const ball = mScene->createEntity(Ogre::SceneManager::PT_SPHERE);
        ball->setMaterial(coloured(surface, "ball", Colour(0.3F, 0.5F, 0.9F)));
        place(ball, {3, 1.5F, 0})->setScale(0.03F, 0.03F, 0.03F);

        const Ogre::MaterialPtr fence = coloured(surface, "fence", Colour(0.9F, 0.9F, 0.9F));
        makeStripes();
        for (Ogre::Pass* pass : fence->getTechnique(0)->getPasses()) {
            pass->setAlphaRejectSettings(Ogre::CMPF_GREATER_EQUAL, 128);
            pass->setCullingMode(Ogre::CULL_NONE);
            pass->getTextureUnitState("DiffuseMap")->setTextureName("stripes");
        }
        Ogre::Entity* const panel = mScene->createEntity(Ogre::SceneManager::PT_PLANE);
        panel->setMaterial(fence);
        panel->setRenderQueueGroupAndPriority(Ogre::RENDER_QUEUE_MAIN, fenceFirst ? 50 : 150);
        place(panel, {0, 2, -4})->setScale(0.04F, 0.02F, 1);
    }

    static void makeStripes() {
        const auto texture = Ogre::TextureManager::getSingleton().createManual(
            "stripes", Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, 16, 16, 0, Ogre::PF_BYTE_RGBA);
        Ogre::Image image(Ogre::PF_BYTE_RGBA, 16, 16);
        for (unsigned x = 0; x < 16; ++x)
            for (unsigned y = 0; y < 16; ++y)
                image.setColourAt(Colour(1, 0.8F, 0.5F, x % 8 < 4 ? 1.0F : 0.0F), x, y, 0);
        texture->getBuffer()->blitFromMemory(image.getPixelBox());
    }

    static Ogre::MaterialPtr coloured(const std::string& surface, const std::string& name,
                                      const Colour& colour) {
        const auto parent = Ogre::MaterialManager::getSingleton().getByName(surface);
        const Ogre::MaterialPtr own = parent->clone(name);
        own->setDiffuse(colour);
        own->setAmbient(colour);
        own->setSpecular(Colour(0.3F, 0.3F, 0.3F));
        own->setShininess(20);
        own->load();
        return own;
    }

    Ogre::SceneNode* place(Ogre::MovableObject* object, const Ogre::Vector3& position) {
        // Maps fit alike from the first frame on.
        if (auto* const entity = dynamic_cast<Ogre::Entity*>(object))
            prepareMesh(entity->getMesh());
        Ogre::SceneNode* const node = mScene->getRootSceneNode()->createChildSceneNode(position);
        node->attachObject(object);
        return node;
    }

    FreshOgre mOgre;
    Ogre::SceneManager* mScene = nullptr;
};

std::vector<std::uint8_t> pictureIn(const std::string& language, const RenderPath& path,
                                    const Way& way) {
    FreshOgre::Options options;
    options.language = language;
    options.renderSystem = path.plugin;
    options.separateShaders = path.separateShaders;
    options.side = Side;
    std::vector<std::uint8_t> picture = LanguageScene(options, way).draw();
    // To be looked at: LIXEL_PICTURES=FOLDER lixel_language_tests
    if (const char* const folder = std::getenv("LIXEL_PICTURES")) {
        const std::string file =
            std::string(folder) + "/" + way.name + "-" + language + "-" + path.name + ".ppm";
        std::ofstream(file, std::ios::binary) << "P6 " << Side << ' ' << Side << " 255\n"
                                              << std::string(picture.begin(), picture.end());
    }
    return picture;
}

/// The share of pixels that differ in any channel.
double share(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    std::size_t differing = 0;
    for (std::size_t pixel = 0; pixel < a.size(); pixel += 3) {
        bool differs = false;
        for (std::size_t i = pixel; i < pixel + 3; ++i)
            differs = differs || std::abs(a[i] - b[i]) > Rounding;
        differing += differs ? 1 : 0;
    }
    return 3.0 * static_cast<double>(differing) / static_cast<double>(a.size());
}

class Languages : public testing::TestWithParam<Way> {};

TEST_P(Languages, DrawTheSamePicture) {
    const Way& way = GetParam();
    const auto glsl = pictureIn("glsl", GL3Plus, way);
    EXPECT_LE(share(glsl, pictureIn("hlsl", GL3Plus, way)), GreatestShare);
    EXPECT_LE(share(glsl, pictureIn("cg", GL3PlusSeparate, way)), GreatestShare);
    EXPECT_LE(share(glsl, pictureIn("cg", LegacyGL, way)), GreatestShare);
}

TEST(LanguagesScene, HasShadows) {
    Way lit = Ways[0];
    lit.technique = Ogre::SHADOWTYPE_NONE;
    EXPECT_GT(share(pictureIn("glsl", GL3Plus, Ways[0]), pictureIn("glsl", GL3Plus, lit)), 0.02);
}

// A modulative receiver darkens holes too: it gets no texture.
TEST(LanguagesScene, HolesHideNoShadowsBehindThem) {
    Way way = Ways[3];
    const auto last = pictureIn("glsl", GL3Plus, way);
    way.fenceFirst = true;
    EXPECT_EQ(share(last, pictureIn("glsl", GL3Plus, way)), 0.0);
}

INSTANTIATE_TEST_SUITE_P(ShadowTechniques, Languages, testing::ValuesIn(Ways),
                         [](const auto& way) { return std::string(way.param.name); });

} // namespace
} // namespace Lixel::Tests
