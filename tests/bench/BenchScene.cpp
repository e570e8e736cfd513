#include "BenchScene.h"

#include "manager/LixelSceneManager.h"

#include <OgreCamera.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreTextureManager.h>
#include <OgreViewport.h>

#include <cmath>
#include <random>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;

constexpr unsigned Width = 640;
constexpr unsigned Height = 360;
constexpr Ogre::uint16 MapSize = 1024;
constexpr float ShadowDistance = 300;

} // namespace

const char* toString(BenchView view) {
    return view == BenchView::Inside ? "inside" : "outwards";
}

BenchScene::BenchScene(HeadlessOgre& ogre, const std::string& managerType, std::size_t objects)
    : mRoot(ogre.root()),
      mManager(*mRoot.createSceneManager(managerType)),
      mReach(10 * std::sqrt(static_cast<float>(objects))) {
    for (const BenchView view : BenchViews)
        addViewer(view);
    addSun();
    // Its camera's node among the root's first children: OGRE destroys a wrong one if it is not
    // among the first 65 536.
    shadowMap();
    addEntities(objects);
    mManager.addRenderQueueListener(&mSkip);
}

BenchScene::~BenchScene() {
    for (const Viewer& viewer : mViewers)
        viewer.target().removeAllViewports();
    mRoot.destroySceneManager(&mManager);
    for (const Viewer& viewer : mViewers)
        Ogre::TextureManager::getSingleton().remove(viewer.texture);
}

void BenchScene::addViewer(BenchView view) {
    Viewer viewer{};
    const std::string name = mManager.getName() + toString(view);
    viewer.texture = Ogre::TextureManager::getSingleton().createManual(
        name, Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, Width, Height, 0, Ogre::PF_BYTE_RGBA,
        Ogre::TU_RENDERTARGET);
    viewer.camera = mManager.createCamera(name);
    viewer.camera->setNearClipDistance(0.1f);
    viewer.camera->setFarClipDistance(2000);
    viewer.camera->setFOVy(Ogre::Degree(60));
    viewer.camera->setAspectRatio(static_cast<float>(Width) / static_cast<float>(Height));
    const bool isInside = view == BenchView::Inside;
    viewer.heading = isInside ? 0.0f : 170.0f;
    viewer.node = mManager.getRootSceneNode()->createChildSceneNode(
        Vector3(0, 5, isInside ? 0 : 0.48f * mReach));
    viewer.node->attachObject(viewer.camera);
    viewer.target().setAutoUpdated(false);
    viewer.target().addViewport(viewer.camera)->setOverlaysEnabled(false);
    mViewers.push_back(viewer);
}

void BenchScene::addSun() {
    mManager.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    mManager.setShadowTextureSettings(MapSize, 1, Ogre::PF_FLOAT32_R);
    mManager.setShadowTextureCasterMaterial(flatMaterial(true));
    mManager.setShadowTextureSelfShadow(true);
    mManager.setShadowFarDistance(ShadowDistance);
    mSun = mManager.createLight();
    mSun->setType(Ogre::Light::LT_DIRECTIONAL);
    Ogre::SceneNode* node = mManager.getRootSceneNode()->createChildSceneNode();
    node->attachObject(mSun);
    node->setDirection(Vector3(1, -1, 0.3f), Ogre::Node::TS_WORLD);
}

void BenchScene::addEntities(std::size_t objects) {
    const std::vector<std::string>& meshes = benchMeshes(mManager);
    std::mt19937 engine(1);
    std::uniform_real_distribution<float> place(-mReach / 2, mReach / 2);
    std::uniform_real_distribution<float> size(0.5f, 6);
    mNodes.reserve(objects);
    for (std::size_t i = 0; i < objects; ++i) {
        // The first is the ground.
        const Vector3 at = i == 0 ? Vector3(0, -1, 0) : Vector3(place(engine), 0, place(engine));
        const Vector3 scale = i == 0 ? Vector3(2 * mReach, 1, 2 * mReach)
                                     : Vector3(size(engine), size(engine), size(engine));
        Ogre::SceneNode* node = mManager.getRootSceneNode()->createChildSceneNode(at);
        node->setScale(scale);
        node->attachObject(mManager.createEntity(meshes[i % meshes.size()]));
        mNodes.push_back(node);
    }
}

void BenchScene::use(BenchView view, const Ogre::ShadowCameraSetupPtr& setup) {
    mView = view;
    viewer().target().getViewport(0)->setShadowsEnabled(setup != nullptr);
    if (setup)
        mSun->setCustomShadowCameraSetup(setup);
    else
        mSun->resetCustomShadowCameraSetup();
}

double BenchScene::shadowDistance() {
    return static_cast<double>(ShadowDistance);
}

void BenchScene::setDrawing(bool draws) {
    mSkip.skips = !draws;
    for (const Viewer& viewer : mViewers)
        viewer.target().getViewport(0)->setClearEveryFrame(draws);
}

void BenchScene::setChangesAnnounced(bool announced) {
    if (auto* const own = dynamic_cast<LixelSceneManager*>(&mManager))
        own->setChangesAnnounced(announced);
}

void BenchScene::turn(int frame) {
    viewer().node->setOrientation(Ogre::Quaternion(
        Ogre::Degree(viewer().heading + 0.2f * static_cast<float>(frame % 50)), Vector3::UNIT_Y));
}

void BenchScene::move(std::size_t count, int frame) {
    if (count == 0) return;
    const float step = frame % 2 == 0 ? 0.1f : -0.1f;
    const std::size_t stride = std::max<std::size_t>(1, (mNodes.size() - 1) / count);
    for (std::size_t i = 0; i < count; ++i) {
        Ogre::SceneNode* node = mNodes[1 + (i * stride) % (mNodes.size() - 1)];
        node->setPosition(node->getPosition() + Vector3(step, 0, 0));
    }
}

void BenchScene::draw() {
    viewer().target().update();
}

void BenchScene::clear() {
    mNodes.clear();
    mManager.clearScene();
}

std::size_t BenchScene::viewDrawCalls() const {
    return viewer().target().getStatistics().batchCount;
}

std::size_t BenchScene::mapDrawCalls() {
    return shadowMap()->getBuffer()->getRenderTarget()->getStatistics().batchCount;
}

} // namespace Lixel::Tests
