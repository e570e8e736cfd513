#include "SceneTest.h"

#include <OgreFrameListener.h>
#include <OgreRenderWindow.h>

#include <memory>

namespace Lixel::Tests {
namespace {

/// Owns OGRE, and takes it down before static objects go.
class Process : public testing::Environment {
public:
    HeadlessOgre& ogre() {
        if (!mOgre) mOgre = std::make_unique<HeadlessOgre>();
        return *mOgre;
    }
    void TearDown() override { mOgre.reset(); }

private:
    std::unique_ptr<HeadlessOgre> mOgre;
};

// GoogleTest owns it, and has to know it before the tests start.
Process& process = *static_cast<Process*>(testing::AddGlobalTestEnvironment(new Process));

} // namespace

HeadlessOgre& ogre() {
    return process.ogre();
}

SceneTest::SceneTest() {
    mManager = mRoot.createSceneManager(GetParam());
    mManager->setShadowTextureSelfShadow(true);
    mRootNode = mManager->getRootSceneNode();
    mCamera = mManager->createCamera("viewer");
    mCamera->setFOVy(Ogre::Degree(90));
    mCamera->setAspectRatio(1);
    mCamera->setNearClipDistance(0.1f);
    mCamera->setFarClipDistance(1000);
    mCameraNode = mRootNode->createChildSceneNode();
    mCameraNode->attachObject(mCamera);
    mViewport = ogre().window().addViewport(mCamera);
}

SceneTest::~SceneTest() {
    ogre().window().removeAllViewports();
    mRoot.destroySceneManager(mManager);
}

Ogre::Entity* SceneTest::addCube(const Ogre::Vector3& position, float halfExtent, bool receives,
                                 Ogre::SceneNode* parent) {
    Ogre::Entity* cube = mManager->createEntity(cubeMesh(*mManager));
    cube->setMaterial(flatMaterial(receives));
    Ogre::SceneNode* node =
        (parent != nullptr ? parent : mRootNode)->createChildSceneNode(position);
    node->setScale(Ogre::Vector3(2 * halfExtent));
    node->attachObject(cube);
    return cube;
}

const Survey& SceneTest::takeSurvey(std::size_t parts) {
    Ogre::FrameEvent event{};
    mRoot._fireFrameRenderingQueued(
        event); // the one before has ended: this one's number is another
    mManager->_updateSceneGraph(mCamera);
    mSurvey.take(*mCamera, *mViewport, 0.0, 0.0, parts);
    return mSurvey;
}

Ogre::Light* SceneTest::addSun(const Ogre::ShadowCameraSetupPtr& setup,
                               const Ogre::Vector3& direction) {
    mManager->setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    mManager->setShadowTextureCasterMaterial(flatMaterial(true));
    mManager->setShadowFarDistance(200);
    Ogre::Light* sun = mManager->createLight();
    sun->setType(Ogre::Light::LT_DIRECTIONAL);
    Ogre::SceneNode* node = mRootNode->createChildSceneNode();
    node->attachObject(sun);
    node->setDirection(direction, Ogre::Node::TS_WORLD);
    sun->setCustomShadowCameraSetup(setup);
    const std::size_t lights = mManager->getMovableObjects("Light").size();
    mManager->setShadowTextureSettings(64, static_cast<unsigned short>(lights), Ogre::PF_FLOAT32_R);
    return sun;
}

Ogre::AxisAlignedBox worldBox(const Aabb& box, const Vec3& wsOrigin) {
    const Vec3 lower = wsOrigin + box.centre - box.halfExtents;
    const Vec3 upper = wsOrigin + box.centre + box.halfExtents;
    const auto real = [](double x) { return static_cast<Ogre::Real>(x); };
    return {real(lower.x()), real(lower.y()), real(lower.z()),
            real(upper.x()), real(upper.y()), real(upper.z())};
}

bool holds(const BoxSet& set, const Survey& survey, const Ogre::MovableObject& object) {
    for (const Aabb& box : set.boxes())
        if (worldBox(box, survey.wsOrigin()) == object.getWorldBoundingBox(true)) return true;
    return false;
}

} // namespace Lixel::Tests
