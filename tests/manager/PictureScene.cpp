#include "PictureScene.h"
#include "setup/MeshPreparation.h"

#include <OgreFrameListener.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreMaterialManager.h>
#include <OgreMesh.h>
#include <OgreMovableObject.h>
#include <OgrePass.h>
#include <OgreRoot.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>
#include <OgreViewport.h>

#include <cstdlib>
#include <fstream>
#include <limits>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;

constexpr unsigned PictureWidth = 160;
constexpr unsigned PictureHeight = 120;

/// In seconds.
constexpr float PictureInterval = 0.05f;

/// OGRE's prefab meshes have sides of 100.
constexpr float PrefabSize = 100;

constexpr const char* MaterialGroup = "Lixel";

/// Of an application that has Lixel's materials.
void loadMaterials() {
    Ogre::ResourceGroupManager& groups = Ogre::ResourceGroupManager::getSingleton();
    if (groups.resourceGroupExists(MaterialGroup)) return;
    groups.createResourceGroup(MaterialGroup);
    for (const char* folder : {"/scripts", "/programs/glsl"})
        groups.addResourceLocation(std::string(LIXEL_MATERIALS_DIR) + folder, "FileSystem",
                                   MaterialGroup);
    groups.initialiseResourceGroup(MaterialGroup);
}

} // namespace

PictureScene::PictureScene(HeadlessOgre& ogre, const std::string& managerType,
                           const Vector3& origin)
    : mOgre(ogre), mManager(*ogre.root().createSceneManager(managerType)) {
    // The first scene of a process would have its shapes later than the others.
    setMeshReadingTime(std::numeric_limits<Ogre::Real>::infinity());
    loadMaterials();
    mPlace = mManager.getRootSceneNode()->createChildSceneNode(origin);
    mManager.setAmbientLight(Ogre::ColourValue(0.2f, 0.2f, 0.2f));
    addView();
    addSun();
    addThings();
}

PictureScene::~PictureScene() {
    for (const Ogre::TexturePtr& texture : mTextures)
        texture->getBuffer()->getRenderTarget()->removeAllViewports();
    mOgre.root().destroySceneManager(&mManager);
    for (const Ogre::TexturePtr& texture : mTextures)
        Ogre::TextureManager::getSingleton().remove(texture);
    for (const Ogre::MaterialPtr& material : mMaterials)
        Ogre::MaterialManager::getSingleton().remove(material);
}

void PictureScene::addView() {
    target = addTexture(mManager.getName() + " picture")->getBuffer()->getRenderTarget();
    camera = mManager.createCamera("viewer");
    camera->setNearClipDistance(0.1f);
    camera->setFarClipDistance(200);
    camera->setAspectRatio(static_cast<float>(PictureWidth) / static_cast<float>(PictureHeight));
    viewer = mPlace->createChildSceneNode(Vector3(0, 6, 16));
    viewer->lookAt(mPlace->getPosition(), Ogre::Node::TS_WORLD);
    viewer->attachObject(camera);
    target->addViewport(camera)->setBackgroundColour(Ogre::ColourValue(0.3f, 0.4f, 0.6f));
}

void PictureScene::addSun() {
    sun = mManager.createLight("sun");
    sun->setType(Ogre::Light::LT_DIRECTIONAL);
    sun->setDiffuseColour(0.7f, 0.7f, 0.6f);
    Ogre::SceneNode* node = mPlace->createChildSceneNode();
    node->attachObject(sun);
    node->setDirection(Vector3(-1, -1, 0.3f), Ogre::Node::TS_WORLD);
}

void PictureScene::addThings() {
    add(Shape::Cube, Vector3(0, -0.5f, 0), Vector3(60, 1, 60), Ogre::ColourValue(0.6f, 0.6f, 0.5f));
    // Around the viewer, too: what is out of view may cast shadows into it.
    for (int i = 0; i < 24; ++i) {
        const float angle = 0.8f * static_cast<float>(i);
        const float radius = 1.5f + static_cast<float>(i);
        const Vector3 at(radius * std::cos(angle), 0.8f, radius * std::sin(angle));
        Ogre::Entity* thing =
            add(i % 3 == 0 ? Shape::Ball : Shape::Cube, at, Vector3(1.2f, 1.6f, 0.9f),
                Ogre::ColourValue(0.03f * static_cast<float>(i), 0.5f, 0.4f));
        if (i % 4 == 1) moving.push_back(thing->getParentSceneNode());
    }
    // One that hangs below another.
    Ogre::Entity* child =
        add(Shape::Cube, Vector3::ZERO, Vector3(1, 1, 1), Ogre::ColourValue(0.9f, 0.1f, 0.1f));
    Ogre::SceneNode* node = child->getParentSceneNode();
    mPlace->removeChild(node);
    moving.front()->addChild(node);
    node->setPosition(0, PrefabSize, 0);
    node->setScale(0.6f, 0.6f, 0.6f);
}

Ogre::Entity* PictureScene::add(Shape shape, const Vector3& position, const Vector3& size,
                                const Ogre::ColourValue& colour) {
    Ogre::Entity* entity = mManager.createEntity(
        "thing" + std::to_string(mThings.size()),
        shape == Shape::Cube ? Ogre::SceneManager::PT_CUBE : Ogre::SceneManager::PT_SPHERE);
    entity->setMaterial(surface(colour));
    Ogre::SceneNode* node = mPlace->createChildSceneNode(position);
    node->setScale(size / PrefabSize);
    node->attachObject(entity);
    mThings.emplace_back(entity, colour);
    return entity;
}

void PictureScene::castShadows(Ogre::ShadowTechnique technique, const std::string& receiver) {
    Ogre::MaterialManager& materials = Ogre::MaterialManager::getSingleton();
    mManager.setShadowTechnique(technique);
    mManager.setShadowFarDistance(60);
    mManager.setShadowColour(Ogre::ColourValue(0.5f, 0.5f, 0.5f));
    if ((technique & Ogre::SHADOWDETAILTYPE_STENCIL) != 0) {
        // Since 13.4 that is for the application to say.
        for (const auto& [entity, colour] : mThings)
            entity->getMesh()->setAutoBuildEdgeLists(true);
        return;
    }
    mManager.setShadowTextureCasterMaterial(materials.getByName("Lixel/Caster", MaterialGroup));
    if (!receiver.empty())
        mManager.setShadowTextureReceiverMaterial(materials.getByName(receiver, MaterialGroup));
    mManager.setShadowTextureSelfShadow(true);
    mManager.setShadowTextureSettings(256, 1, Ogre::PF_FLOAT32_R);
}

void PictureScene::wear(const std::string& material) {
    mSurface = material;
    for (const auto& [entity, colour] : mThings)
        entity->setMaterial(surface(colour));
}

Ogre::MaterialPtr PictureScene::surface(const Ogre::ColourValue& colour) {
    Ogre::MaterialPtr material =
        Ogre::MaterialManager::getSingleton()
            .getByName(mSurface, MaterialGroup)
            ->clone(mManager.getName() + " surface " + std::to_string(mMaterials.size()));
    material->setAmbient(colour);
    material->setDiffuse(colour);
    material->load();
    mMaterials.push_back(material);
    return material;
}

const Ogre::TexturePtr& PictureScene::addTexture(const std::string& name) {
    mTextures.push_back(Ogre::TextureManager::getSingleton().createManual(
        name, Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, PictureWidth, PictureHeight, 0,
        Ogre::PF_BYTE_RGBA, Ogre::TU_RENDERTARGET));
    mTextures.back()->getBuffer()->getRenderTarget()->setAutoUpdated(false);
    return mTextures.back();
}

void PictureScene::moveAll() {
    for (Ogre::SceneNode* node : moving) {
        node->translate(0.4f, 0, 0.1f);
        node->yaw(Ogre::Degree(20));
    }
    viewer->translate(0.3f, 0.1f, 0);
}

void PictureScene::keep(const Picture& picture, const std::string& name) {
    const char* folder = std::getenv("LIXEL_PICTURES");
    if (folder == nullptr) return;
    std::ofstream file(std::string(folder) + "/" + name + ".ppm", std::ios::binary);
    file << "P6 " << PictureWidth << ' ' << PictureHeight << " 255\n";
    for (std::size_t i = 0; i < picture.size(); i += 4)
        file.write(reinterpret_cast<const char*>(picture.data() + i), 3);
}

Picture PictureScene::draw() {
    moveAll();
    Ogre::FrameEvent event{PictureInterval, PictureInterval};
    mOgre.root()._fireFrameStarted(event);
    // The picture is the first: what it shows of the others is drawn before.
    for (auto texture = mTextures.rbegin(); texture != mTextures.rend(); ++texture)
        (*texture)->getBuffer()->getRenderTarget()->update();
    mOgre.root()._fireFrameRenderingQueued(event);
    mOgre.root()._fireFrameEnded(event);
    Picture picture(std::size_t{4} * PictureWidth * PictureHeight);
    const Ogre::PixelBox box(PictureWidth, PictureHeight, 1, Ogre::PF_BYTE_RGBA, picture.data());
    target->copyContentsToMemory(Ogre::Box(0, 0, PictureWidth, PictureHeight), box);
    return picture;
}

} // namespace Lixel::Tests
