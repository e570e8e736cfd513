// What the survey finds on OGRE's scene graphs, against what OGRE draws.
#include "SceneTest.h"

#include "scene/OgreMath.h"

#include <OgreBone.h>
#include <OgreInstanceManager.h>
#include <OgreInstancedEntity.h>
#include <OgreManualObject.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreRenderQueue.h>
#include <OgreRenderQueueSortingGrouping.h>
#include <OgreSimpleRenderable.h>
#include <OgreSkeleton.h>
#include <OgreSkeletonInstance.h>
#include <OgreSkeletonManager.h>
#include <OgreStaticGeometry.h>
#include <OgreTagPoint.h>

using Ogre::Vector3;

namespace Lixel::Tests {
namespace {

class SurveyTest : public SceneTest {
protected:
    /// In view, casting and receiving unless told otherwise.
    Ogre::Entity* addInView(bool receives = true) {
        return addCube(Vector3(0, 0, -10), 0.5f, receives);
    }
    bool casts(const Ogre::MovableObject& object) {
        takeSurvey();
        return holds(allCasters(), mSurvey, object);
    }
    bool receives(const Ogre::MovableObject& object) {
        return holds(takeSurvey().receivers(), mSurvey, object);
    }
};

INSTANTIATE_TEST_SUITE_P(SceneManager, SurveyTest,
                         testing::Values(DefaultManager, OctreeManager, OtherManager, FlatManager),
                         [](const auto& test) { return test.param; });

TEST_P(SurveyTest, OfAnEmptySceneIsEmpty) {
    takeSurvey();
    EXPECT_TRUE(allCasters().empty());
    EXPECT_TRUE(mSurvey.receivers().empty());
    EXPECT_EQ(mSurvey.objectCount(), 0U);
}

TEST_P(SurveyTest, FindsACubeThatCastsAndReceives) {
    Ogre::Entity* cube = addInView();
    EXPECT_TRUE(casts(*cube));
    EXPECT_TRUE(receives(*cube));
    EXPECT_EQ(mSurvey.objectCount(), 1U);
}

TEST_P(SurveyTest, HonoursCastShadows) {
    Ogre::Entity* cube = addInView();
    cube->setCastShadows(false);
    EXPECT_FALSE(casts(*cube));
    EXPECT_TRUE(receives(*cube));
}

TEST_P(SurveyTest, HonoursTheMaterialsReceiveShadows) {
    Ogre::Entity* cube = addInView(false);
    EXPECT_TRUE(casts(*cube));
    EXPECT_FALSE(receives(*cube));
}

TEST_P(SurveyTest, KnowsOnlyReceiversInView) {
    const Ogre::Entity* behind = addCube(Vector3(0, 0, 10));
    const Ogre::Entity* beside = addCube(Vector3(12, 0, -10));
    const Ogre::Entity* beyond = addCube(Vector3(0, 0, -1005));
    const Ogre::Entity* onTheEdge = addCube(Vector3(10, 0, -10));
    for (const Ogre::Entity* cube : {behind, beside, beyond}) {
        EXPECT_TRUE(casts(*cube));
        EXPECT_FALSE(receives(*cube));
    }
    EXPECT_TRUE(receives(*onTheEdge));
}

TEST_P(SurveyTest, HonoursSetVisible) {
    Ogre::Entity* cube = addInView();
    cube->setVisible(false);
    EXPECT_FALSE(casts(*cube));
    EXPECT_FALSE(receives(*cube));
    EXPECT_EQ(mSurvey.objectCount(), 0U);
}

TEST_P(SurveyTest, HonoursVisibilityFlagsOfObjectManagerAndViewport) {
    Ogre::Entity* cube = addInView();
    cube->setVisibilityFlags(0b0110);
    EXPECT_TRUE(casts(*cube));
    mManager->setVisibilityMask(0b1001);
    EXPECT_FALSE(casts(*cube));
    mManager->setVisibilityMask(0b0010);
    EXPECT_TRUE(casts(*cube));
    mViewport->setVisibilityMask(0b0100);
    EXPECT_FALSE(casts(*cube)) << "each mask lets it pass, both together do not";
    EXPECT_FALSE(receives(*cube));
    mManager->setVisibilityMask(0b0110);
    EXPECT_TRUE(casts(*cube));
    EXPECT_TRUE(receives(*cube));
}

TEST_P(SurveyTest, HonoursTheRenderingDistance) {
    Ogre::Entity* cube = addInView();
    // OGRE adds the bounding sphere's radius, here √3/2.
    cube->setRenderingDistance(9.2f);
    EXPECT_TRUE(casts(*cube));
    cube->setRenderingDistance(9.1f);
    EXPECT_FALSE(casts(*cube));
    EXPECT_FALSE(receives(*cube));
    mCamera->setUseRenderingDistance(false);
    EXPECT_TRUE(receives(*cube));
}

TEST_P(SurveyTest, ScalesTheSphereOfTheRenderingDistance) {
    Ogre::Entity* cube = addCube(Vector3(0, 0, -10), 2.0f);
    cube->getParentSceneNode()->setScale(1, -4, 2);
    cube->setRenderingDistance(6.6f); // and 2 √3
    EXPECT_TRUE(casts(*cube));
    cube->setRenderingDistance(6.5f);
    EXPECT_FALSE(casts(*cube));
}

TEST_P(SurveyTest, TakesTheDistanceOfReceiversFromTheViewersLodCamera) {
    Ogre::Entity* cube = addInView();
    cube->setRenderingDistance(20);
    Ogre::Camera* far = mManager->createCamera("level of detail");
    mRootNode->createChildSceneNode(Vector3(0, 0, 500))->attachObject(far);
    mCamera->setLodCamera(far);
    EXPECT_FALSE(receives(*cube));
    // OGRE makes the viewer itself the shadow camera's level of detail camera.
    EXPECT_TRUE(casts(*cube));
}

TEST_P(SurveyTest, IgnoresObjectsWithoutExtent) {
    Ogre::ManualObject* nothing = mManager->createManualObject();
    mRootNode->attachObject(nothing);
    ASSERT_TRUE(nothing->getBoundingBox().isNull());
    takeSurvey();
    EXPECT_TRUE(allCasters().empty());
    EXPECT_TRUE(mSurvey.receivers().empty());
    EXPECT_EQ(allCasters().invalid() + mSurvey.receivers().invalid(), 0U);
}

TEST_P(SurveyTest, CountsObjectsWithoutBoundsAndNamesOne) {
    Ogre::ManualObject* sky = mManager->createManualObject("sky");
    sky->begin(flatMaterial(true)->getName());
    sky->position(0, 0, 0);
    sky->position(1, 0, 0);
    sky->position(0, 1, 0);
    sky->end();
    sky->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
    mRootNode->createChildSceneNode()->attachObject(sky);
    takeSurvey();
    EXPECT_EQ(allCasters().unbounded(), 1U);
    EXPECT_EQ(mSurvey.receivers().unbounded(), 1U);
    EXPECT_EQ(mSurvey.unboundedName(), "sky");
    // As skies should be: they neither cast nor receive.
    sky->setCastShadows(false);
    sky->setRenderQueueGroup(Ogre::RENDER_QUEUE_SKIES_EARLY);
    takeSurvey();
    EXPECT_EQ(allCasters().unbounded() + mSurvey.receivers().unbounded(), 0U);
    EXPECT_EQ(mSurvey.unboundedName(), "");
}

TEST_P(SurveyTest, HonoursRenderQueueGroupsWithoutShadows) {
    Ogre::Entity* cube = addInView();
    cube->setRenderQueueGroup(Ogre::RENDER_QUEUE_8);
    EXPECT_TRUE(receives(*cube));
    mManager->getRenderQueue()->getQueueGroup(Ogre::RENDER_QUEUE_8)->setShadowsEnabled(false);
    EXPECT_FALSE(receives(*cube));
    EXPECT_TRUE(casts(*cube)) << "OGRE draws the casters of all groups";
    mManager->getRenderQueue()->getQueueGroup(Ogre::RENDER_QUEUE_8)->setShadowsEnabled(true);
    EXPECT_TRUE(receives(*cube));
}

TEST_P(SurveyTest, WithoutSelfShadowingNoCasterReceives) {
    Ogre::Entity* caster = addInView();
    Ogre::Entity* receiver = addCube(Vector3(0, -3, -10));
    receiver->setCastShadows(false);
    mManager->setShadowTextureSelfShadow(false);
    EXPECT_FALSE(receives(*caster));
    EXPECT_TRUE(receives(*receiver));
    mManager->setShadowTextureSelfShadow(true);
    EXPECT_TRUE(receives(*caster));
}

TEST_P(SurveyTest, IntegratedTechniquesKnowNoSelfShadowing) {
    Ogre::Entity* caster = addInView();
    mManager->setShadowTextureSelfShadow(false);
    EXPECT_FALSE(receives(*caster));
    mManager->setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    EXPECT_TRUE(receives(*caster));
}

TEST_P(SurveyTest, IgnoresCamerasAndLights) {
    mRootNode->attachObject(mManager->createLight());
    mRootNode->createChildSceneNode()->attachObject(mManager->createLight());
    mRootNode->attachObject(mManager->createCamera("another"));
    takeSurvey();
    EXPECT_EQ(mSurvey.objectCount(), 0U);
    EXPECT_TRUE(allCasters().empty());
    EXPECT_TRUE(mSurvey.receivers().empty());
}

TEST_P(SurveyTest, ForgetsWhatIsTakenOutOfTheScene) {
    Ogre::Entity* cube = addInView();
    EXPECT_TRUE(casts(*cube));
    mRootNode->removeChild(cube->getParentSceneNode());
    takeSurvey();
    EXPECT_TRUE(allCasters().empty());
}

// Kinds of objects.

TEST_P(SurveyTest, FindsManualObjects) {
    Ogre::ManualObject* triangle = mManager->createManualObject();
    triangle->begin(flatMaterial(true)->getName());
    triangle->position(-1, 0, -10);
    triangle->position(1, 0, -10);
    triangle->position(0, 2, -12);
    triangle->end();
    mRootNode->createChildSceneNode(Vector3(0, 1, 0))->attachObject(triangle);
    EXPECT_TRUE(casts(*triangle));
    EXPECT_TRUE(receives(*triangle));
    ASSERT_EQ(allCasters().boxes().size(), 1U);
    EXPECT_TRUE(allCasters().boxes()[0].centre.isApprox(Vec3(0, 2, -11)));
    EXPECT_TRUE(allCasters().boxes()[0].halfExtents.isApprox(Vec3(1, 1, 1)));
    // OGRE asks the part, not the object, and a manual object's says that it casts nothing.
    mManager->setShadowTextureSelfShadow(false);
    EXPECT_TRUE(casts(*triangle));
    EXPECT_TRUE(receives(*triangle));
}

/// What applications derive themselves, without a factory: terrain tiles, for instance.
class CustomObject : public Ogre::SimpleRenderable {
public:
    CustomObject() {
        setBoundingBox(Ogre::AxisAlignedBox(-1, -1, -1, 1, 1, 1));
        setMaterial(flatMaterial(true));
    }
    Ogre::Real getBoundingRadius() const override { return 2; }
    Ogre::Real getSquaredViewDepth(const Ogre::Camera*) const override { return 0; }
};

TEST_P(SurveyTest, FindsObjectsWithoutAFactory) {
    CustomObject object;
    Ogre::SceneNode* node = mRootNode->createChildSceneNode(Vector3(0, 0, -10));
    node->attachObject(&object);
    EXPECT_TRUE(casts(object));
    EXPECT_TRUE(receives(object));
    EXPECT_EQ(mSurvey.objectCount(), 1U);
    node->detachAllObjects();
}

TEST_P(SurveyTest, FindsStaticGeometry) {
    Ogre::StaticGeometry* geometry = mManager->createStaticGeometry("geometry");
    geometry->setRegionDimensions(Vector3(100));
    geometry->setCastShadows(true);
    Ogre::Entity* cube = addCube(Vector3::ZERO);
    for (int i = 0; i < 10; ++i)
        geometry->addEntity(cube, Vector3(static_cast<float>(i), 0, -20));
    mRootNode->removeChild(cube->getParentSceneNode());
    geometry->build();
    takeSurvey();
    ASSERT_GE(allCasters().boxes().size(), 1U);
    EXPECT_EQ(mSurvey.receivers().boxes().size(), allCasters().boxes().size());
    Ogre::AxisAlignedBox all;
    for (const Aabb& box : allCasters().boxes())
        all.merge(worldBox(box, mSurvey.wsOrigin()));
    EXPECT_TRUE(all.contains(Ogre::AxisAlignedBox(-0.5f, -0.5f, -20.5f, 9.5f, 0.5f, -19.5f)));
    geometry->setCastShadows(false);
    takeSurvey();
    EXPECT_TRUE(allCasters().empty());
    EXPECT_FALSE(mSurvey.receivers().empty());
}

TEST_P(SurveyTest, FindsHardwareInstances) {
    Ogre::InstanceManager* instances = mManager->createInstanceManager(
        "instances", addCube(Vector3::ZERO)->getMesh()->getName(), Ogre::RGN_DEFAULT,
        Ogre::InstanceManager::HWInstancingBasic, 80);
    mManager->destroyAllMovableObjectsByType("Entity");
    for (const float x : {-3.0f, 3.0f})
        mRootNode->createChildSceneNode(Vector3(x, 0, -10))
            ->attachObject(
                mManager->createInstancedEntity(flatMaterial(true)->getName(), "instances"));
    // A batch gathers its bounds where a frame begins.
    mRoot.getRenderSystem()->_setViewport(mViewport);
    instances->_updateDirtyBatches();
    takeSurvey();
    // The batch, which draws them, and not each instance.
    ASSERT_EQ(allCasters().boxes().size(), 1U);
    const Ogre::AxisAlignedBox batch = worldBox(allCasters().boxes()[0], mSurvey.wsOrigin());
    EXPECT_TRUE(batch.contains(Ogre::AxisAlignedBox(-3.5f, -0.5f, -10.5f, 3.5f, 0.5f, -9.5f)))
        << batch;
    EXPECT_EQ(mSurvey.receivers().boxes().size(), 1U);
    instances->setSetting(Ogre::InstanceManager::CAST_SHADOWS, false);
    takeSurvey();
    EXPECT_TRUE(allCasters().empty());
    mManager->destroyInstanceManager("instances");
}

class SkeletonSurveyTest : public SurveyTest {
protected:
    /// A cube with one bone, and a cube on it 2 units to the right.
    void addArmed(bool armReceives) {
        auto& skeletons = Ogre::SkeletonManager::getSingleton();
        auto& meshes = Ogre::MeshManager::getSingleton();
        Ogre::SkeletonPtr skeleton = skeletons.getByName("armed", Ogre::RGN_DEFAULT);
        if (!skeleton) {
            skeleton = skeletons.create("armed", Ogre::RGN_DEFAULT, true);
            skeleton->load(); // or OGRE would not free its bones
            skeleton->createBone("hand")->setPosition(2, 0, 0);
            skeleton->setBindingPose();
        }
        mArm = addCube(Vector3::ZERO, 0.5f, armReceives);
        if (!meshes.resourceExists("armed", Ogre::RGN_DEFAULT))
            mArm->getMesh()->clone("armed")->_notifySkeleton(skeleton);
        mArm->detachFromParent();
        mBody = mManager->createEntity("armed");
        mBody->setMaterial(flatMaterial(false));
        mRootNode->createChildSceneNode(Vector3(0, 0, -10))->attachObject(mBody);
        mBody->attachObjectToBone("hand", mArm);
    }

    Ogre::Entity* mBody = nullptr;
    Ogre::Entity* mArm = nullptr;
};

INSTANTIATE_TEST_SUITE_P(SceneManager, SkeletonSurveyTest,
                         testing::Values(DefaultManager, OctreeManager, FlatManager),
                         [](const auto& test) { return test.param; });

TEST_P(SkeletonSurveyTest, CountsObjectsOnBonesIntoTheirEntitysBox) {
    addArmed(false);
    takeSurvey();
    ASSERT_EQ(allCasters().boxes().size(), 1U);
    const Ogre::AxisAlignedBox box = worldBox(allCasters().boxes()[0], mSurvey.wsOrigin());
    EXPECT_TRUE(box.contains(Ogre::AxisAlignedBox(-0.5f, -0.5f, -10.5f, 2.5f, 0.5f, -9.5f))) << box;
    EXPECT_TRUE(mSurvey.receivers().empty());
}

TEST_P(SkeletonSurveyTest, ReceivesWhereAnObjectOnABoneDoes) {
    addArmed(true);
    takeSurvey();
    EXPECT_EQ(mSurvey.receivers().boxes().size(), 1U);
    mManager->setShadowTextureSelfShadow(false);
    takeSurvey();
    EXPECT_TRUE(mSurvey.receivers().empty());
    mArm->setCastShadows(false);
    takeSurvey();
    EXPECT_EQ(mSurvey.receivers().boxes().size(), 1U);
    mArm->setVisible(false);
    takeSurvey();
    EXPECT_TRUE(mSurvey.receivers().empty());
}

// Where the boxes are.

TEST_P(SurveyTest, ComposesNestedTransforms) {
    Ogre::SceneNode* turned = mRootNode->createChildSceneNode(Vector3(0, 0, -20));
    turned->yaw(Ogre::Degree(90));
    Ogre::SceneNode* scaled = turned->createChildSceneNode(Vector3(0, 1, 0));
    scaled->setScale(2, 2, 2);
    Ogre::Entity* cube = addCube(Vector3(3, 0, 0), 0.5f, true, scaled);
    takeSurvey();
    // x turned onto -z and doubled.
    ASSERT_EQ(allCasters().boxes().size(), 1U);
    EXPECT_TRUE(allCasters().boxes()[0].centre.isApprox(Vec3(0, 1, -26), 1e-6));
    EXPECT_TRUE(allCasters().boxes()[0].halfExtents.isApprox(Vec3::Ones(), 1e-6));
    turned->setPosition(0, 0, -10);
    EXPECT_TRUE(casts(*cube));
    EXPECT_TRUE(allCasters().boxes()[0].centre.isApprox(Vec3(0, 1, -16), 1e-6));
}

TEST_P(SurveyTest, KeepsExtentsPositiveUnderMirrors) {
    Ogre::Entity* cube = addInView();
    cube->getParentSceneNode()->setScale(-2, 3, -1);
    EXPECT_TRUE(casts(*cube));
    EXPECT_TRUE(receives(*cube));
    EXPECT_TRUE(allCasters().box(0).halfExtents.isApprox(Vec3(1, 1.5, 0.5)));
    EXPECT_EQ(allCasters().invalid(), 0U);
}

TEST_P(SurveyTest, IsExactFarFromTheWorldsOrigin) {
    // 2^20: a float has steps of 1/8 here, and every number below is one.
    const Vector3 far(1048576, -1048576, 1048576);
    mCameraNode->setPosition(far + Vector3(0.125f, 0, 0));
    addCube(far + Vector3(3, 0.375f, -10.25f));
    takeSurvey();
    EXPECT_EQ(mSurvey.wsOrigin(), toDouble(far) + Vec3(0.125, 0, 0));
    ASSERT_EQ(allCasters().boxes().size(), 1U);
    const Aabb& box = allCasters().boxes()[0];
    EXPECT_EQ(box.centre.x(), 2.875);
    EXPECT_EQ(box.centre.z(), -10.25);
    EXPECT_EQ(box.halfExtents.x(), 0.5);
    // The ends of the box round to even there: 0.375 ± 0.5 are both between two floats.
    EXPECT_NEAR(box.centre.y(), 0.375, 0.0625);
    EXPECT_EQ(mSurvey.receivers().boxes().size(), 1U);
}

TEST_P(SurveyTest, IsRelativeToAMirroredViewersEye) {
    addCube(Vector3(0, -2, -10));
    mCameraNode->setPosition(1, 3, 2);
    mCamera->enableReflection(Ogre::Plane(Vector3::UNIT_Y, 0));
    takeSurvey();
    EXPECT_TRUE(mSurvey.wsOrigin().isApprox(Vec3(1, -3, 2), 1e-6));
    EXPECT_TRUE(allCasters().box(0).centre.isApprox(Vec3(-1, 1, -12), 1e-6));
    EXPECT_EQ(mSurvey.receivers().boxes().size(), 1U);
    mCamera->disableReflection();
}

TEST_P(SurveyTest, SeesWithTheViewersOwnMatricesWhileItsCullingIsAnothers) {
    addInView();
    Ogre::Camera* other = mManager->createCamera("culls");
    Ogre::SceneNode* node = mRootNode->createChildSceneNode(Vector3(0, 0, -20));
    node->attachObject(other);
    node->yaw(Ogre::Degree(180));
    mCamera->setCullingFrustum(other);
    takeSurvey();
    EXPECT_TRUE(mSurvey.wsOrigin().isZero());
    EXPECT_TRUE(mSurvey.viewer().viewFromWorld.isApprox(Mat4::Identity()));
    mCamera->setCullingFrustum(nullptr);
}

TEST_P(SurveyTest, IsTakenAgainFromNothing) {
    Ogre::Entity* cube = addInView();
    takeSurvey();
    takeSurvey();
    EXPECT_EQ(allCasters().boxes().size(), 1U);
    EXPECT_EQ(mSurvey.objectCount(), 1U);
    mManager->destroyEntity(cube);
    takeSurvey();
    EXPECT_TRUE(allCasters().empty());
}

} // namespace
} // namespace Lixel::Tests
