#include "LanguageScene.h"

#include "FreshOgre.h"

#include <Lixel/material/ShadowMaterials.h>
#include <Lixel/setup/CascadesShadowCameraSetup.h>
#include <Lixel/setup/MeshPreparation.h>
#include <Lixel/setup/ShadowCameraSetups.h>

#include <OgreImage.h>

#include <cstdlib>
#include <fstream>

namespace Lixel::Tests {
namespace {

using Colour = Ogre::ColourValue;

constexpr Ogre::uint32 Side = 320;

class LanguageScene {
public:
    LanguageScene(const FreshOgre::Options& options, const Way& way) : mOgre(options) {
        if (way.folder != nullptr)
            Ogre::ResourceGroupManager::getSingleton().addResourceLocation(way.folder,
                                                                           "FileSystem");
        mOgre.readScripts();
        mScene = mOgre.root().createSceneManager();
        mWorld = mScene->getRootSceneNode()->createChildSceneNode();
        mWorld->setScale(Ogre::Vector3(way.unit));
        mScene->setAmbientLight(Colour(0.25F, 0.25F, 0.3F));
        mScene->setFog(Ogre::FOG_LINEAR, Colour(0.5F, 0.6F, 0.7F), 0, 5 * way.unit, 60 * way.unit);
        castShadows(way);
        addBodies(way.surface);
        if (way.hasFence) addFence(way.surface, way.fenceFirst);
        if (way.folder == nullptr)
            addSun(way.maps);
        else
            addLamp();
        Ogre::Camera* const viewer = mScene->createCamera("");
        viewer->setNearClipDistance(0.1F * way.unit);
        viewer->setFarClipDistance(200 * way.unit);
        viewer->setAspectRatio(1);
        place(viewer, {3, 5, 10})->lookAt({0, way.unit, 0}, Ogre::Node::TS_WORLD);
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
        for (const char* const name : {way.caster, way.receiver})
            if (name != nullptr && way.kept != nullptr) keepTechnique(name, way.kept);
        setShadowMaterials(*mScene, way.receiver != nullptr ? way.receiver : "", way.caster);
    }

    static void keepTechnique(const std::string& material, const std::string& kept) {
        const auto changed = Ogre::MaterialManager::getSingleton().getByName(material);
        for (unsigned short i = changed->getNumTechniques(); i-- > 0;)
            if (changed->getTechnique(i)->getName() != kept) changed->removeTechnique(i);
        changed->load();
    }

    /// A spot light, whose shadow camera is OGRE's own.
    void addLamp() {
        Ogre::Light* const lamp = mScene->createLight();
        lamp->setType(Ogre::Light::LT_SPOTLIGHT);
        lamp->setSpotlightRange(Ogre::Degree(60), Ogre::Degree(80));
        place(lamp, {9, 12, 5})->lookAt({0, 0, 0}, Ogre::Node::TS_WORLD);
    }

    void addSun(std::size_t maps) {
        Ogre::Light* const sun = mScene->createLight();
        sun->setType(Ogre::Light::LT_DIRECTIONAL);
        place(sun, {0, 0, 0})->setDirection({-2, -3, -1}, Ogre::Node::TS_WORLD);
        if (maps > 1)
            sun->setCustomShadowCameraSetup(CascadesShadowCameraSetup::create());
        else
            sun->setCustomShadowCameraSetup(OptimalShadowCameraSetup::create());
    }

    void addBodies(const std::string& surface) {
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
    }

    void addFence(const std::string& surface, bool fenceFirst) {
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
        Ogre::SceneNode* const node = mWorld->createChildSceneNode(position);
        node->attachObject(object);
        return node;
    }

    FreshOgre mOgre;
    Ogre::SceneManager* mScene = nullptr;
    Ogre::SceneNode* mWorld = nullptr;
};

} // namespace

std::vector<std::uint8_t> pictureIn(const std::string& language, const RenderPath& path,
                                    const Way& way) {
    FreshOgre::Options options;
    options.language = language;
    options.renderSystem = path.plugin;
    options.separateShaders = path.separateShaders;
    options.side = Side;
    std::vector<std::uint8_t> picture = LanguageScene(options, way).draw();
    if (const char* const folder = std::getenv("LIXEL_PICTURES")) {
        const std::string file =
            std::string(folder) + "/" + way.name + "-" + language + "-" + path.name + ".ppm";
        std::ofstream(file, std::ios::binary) << "P6 " << Side << ' ' << Side << " 255\n"
                                              << std::string(picture.begin(), picture.end());
    }
    return picture;
}

double share(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    std::size_t differing = 0;
    for (std::size_t pixel = 0; pixel < a.size(); pixel += 3) {
        bool differs = false;
        for (std::size_t i = pixel; i < pixel + 3; ++i)
            differs = differs || a[i] != b[i];
        differing += differs ? 1 : 0;
    }
    return 3.0 * static_cast<double>(differing) / static_cast<double>(a.size());
}

} // namespace Lixel::Tests
