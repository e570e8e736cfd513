// Whatever an application changes between two frames, the next survey knows: one that has seen the
// scene before says what one that has not says, and both say what is.
#include "SceneTest.h"

#include <OgreManualObject.h>
#include <OgreMaterialManager.h>
#include <OgreRenderQueue.h>
#include <OgreRenderQueueSortingGrouping.h>
#include <OgreTechnique.h>

using Ogre::Vector3;

namespace Lixel::Tests {
namespace {

/// What a survey and a search say of the cube.
struct Role {
    bool casts;
    bool receives;
    bool operator==(const Role&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Role& role) {
    return out << (role.casts ? "casts" : "does not cast")
               << (role.receives ? " and receives" : " and does not receive");
}

constexpr Role Both{true, true};
constexpr Role Nothing{false, false};

/// A cube on a node of a node, in view over a ground, among others.
class SurveyChangeTest : public SceneTest {
protected:
    SurveyChangeTest() {
        addCube(Vector3(0, -5, -10), 4)->setCastShadows(false);
        mParent = mRootNode->createChildSceneNode(Vector3(0, 0, -10));
        mCube = addCube(Vector3(0, 0, 0), 0.5f, true, mParent);
        mNode = mCube->getParentSceneNode();
        for (int i = 0; i < 20; ++i)
            addCube(Vector3(40.0f + static_cast<float>(2 * i), 0, -10));
        for (int i = 0; i < 3; ++i)
            expect(Both);
    }

    static Ogre::ManualObject* drawTriangle(Ogre::ManualObject* object, const Vector3& at) {
        object->clear();
        object->begin(flatMaterial(true)->getName());
        for (const Vector3& corner : {Vector3(-1, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0.5f)})
            object->position(at + corner);
        object->end();
        return object;
    }

    void expect(Role role) {
        takeSurvey();
        EXPECT_EQ(roleIn(mSurvey, mSearch), role);
        Survey fresh;
        fresh.take(*mCamera, *mViewport);
        CasterSearch search;
        EXPECT_EQ(roleIn(fresh, search), role);
    }

    Role roleIn(const Survey& survey, CasterSearch& search) {
        return {holds(search.find(survey, {.wsDirection = Vec3(0, -1, 0)}, 0.0), survey, *mCube),
                holds(survey.receivers(), survey, *mCube)};
    }

    Ogre::SceneNode* mParent = nullptr;
    Ogre::SceneNode* mNode = nullptr;
    Ogre::Entity* mCube = nullptr;
};

INSTANTIATE_TEST_SUITE_P(SceneManager, SurveyChangeTest,
                         testing::Values(DefaultManager, OctreeManager, OtherManager, FlatManager),
                         [](const auto& test) { return test.param; });

TEST_P(SurveyChangeTest, MovedNode) {
    mNode->setPosition(0, 30, 0); // above the view, over the ground
    expect({true, false});
    mNode->setPosition(30, 0, 0);
    expect(Nothing);
    mNode->setPosition(0, 1, 0);
    expect(Both);
}

TEST_P(SurveyChangeTest, MovedParent) {
    mParent->translate(0, 0, 60);
    expect(Nothing);
    mParent->translate(0, 40, -60);
    expect({true, false});
    mParent->translate(0, -40, 0);
    expect(Both);
}

TEST_P(SurveyChangeTest, TurnedAndScaledParent) {
    mNode->setPosition(0, 0, -20);
    expect(Both);
    mParent->yaw(Ogre::Degree(180));
    expect(Nothing);
    mParent->setScale(1, 1, -0.1f);
    expect(Both);
}

TEST_P(SurveyChangeTest, ScaledNode) {
    mNode->setPosition(12, 0, 0);
    expect(Nothing);
    mNode->setScale(20, 1, 1);
    expect(Both);
}

TEST_P(SurveyChangeTest, MovedAndTurnedViewer) {
    mCameraNode->yaw(Ogre::Degree(180));
    expect(Nothing);
    mCameraNode->setPosition(0, 0, -60);
    expect(Both);
}

TEST_P(SurveyChangeTest, ViewersFieldOfViewAndFarPlane) {
    mNode->setPosition(4, 0, 0);
    expect(Both);
    mCamera->setFOVy(Ogre::Degree(10));
    expect(Nothing);
    mCamera->setFOVy(Ogre::Degree(90));
    mCamera->setFarClipDistance(5);
    expect(Nothing);
    mCamera->setFarClipDistance(0);
    expect(Both);
}

TEST_P(SurveyChangeTest, VisibilityAndItsFlags) {
    mCube->setVisible(false);
    expect(Nothing);
    mCube->setVisible(true);
    expect(Both);
    mNode->setVisible(false);
    expect(Nothing);
    mNode->setVisible(true);
    mCube->setVisibilityFlags(2);
    mViewport->setVisibilityMask(1);
    expect(Nothing);
    mCube->setVisibilityFlags(1);
    expect(Both);
    mManager->setVisibilityMask(2);
    expect(Nothing);
}

TEST_P(SurveyChangeTest, CastShadows) {
    mCube->setCastShadows(false);
    expect({false, true});
    mCube->setCastShadows(true);
    expect(Both);
}

TEST_P(SurveyChangeTest, MaterialAndItsFlag) {
    mCube->setMaterial(flatMaterial(false));
    expect({true, false});
    Ogre::MaterialPtr material = flatMaterial(true)->clone("changing");
    mCube->setMaterial(material);
    expect(Both);
    material->setReceiveShadows(false);
    expect({true, false});
    material->setReceiveShadows(true);
    expect(Both);
    mCube->setMaterial(flatMaterial(true));
    Ogre::MaterialManager::getSingleton().remove(material);
}

TEST_P(SurveyChangeTest, RenderQueueGroup) {
    Ogre::RenderQueueGroup* group = mManager->getRenderQueue()->getQueueGroup(60);
    group->setShadowsEnabled(false);
    expect(Both);
    mCube->setRenderQueueGroup(60);
    expect({true, false});
    group->setShadowsEnabled(true);
    expect(Both);
}

TEST_P(SurveyChangeTest, SelfShadowing) {
    mManager->setShadowTextureSelfShadow(false);
    expect({true, false});
    mCube->setCastShadows(false);
    expect({false, true});
}

TEST_P(SurveyChangeTest, RenderingDistance) {
    mCube->setRenderingDistance(5);
    expect(Nothing);
    mCube->setRenderingDistance(15);
    expect(Both);
}

TEST_P(SurveyChangeTest, DetachedAndAttachedObject) {
    mNode->detachObject(mCube);
    expect(Nothing);
    mParent->attachObject(mCube);
    expect(Both);
    mParent->detachObject(mCube);
    mRootNode->createChildSceneNode(Vector3(0, 0, 30))->attachObject(mCube);
    expect(Nothing);
}

TEST_P(SurveyChangeTest, RemovedAndReparentedNode) {
    mParent->removeChild(mNode);
    expect(Nothing);
    mParent->addChild(mNode);
    expect(Both);
    mRootNode->removeChild(mParent);
    expect(Nothing);
    mParent->removeChild(mNode);
    mNode->setPosition(0, 0, -10);
    mRootNode->addChild(mNode);
    expect(Both);
    mRootNode->addChild(mParent);
    expect(Both);
}

TEST_P(SurveyChangeTest, DestroyedAndCreatedObjectsAndNodes) {
    for (int i = 0; i < 4; ++i) {
        mNode->detachAllObjects();
        mManager->destroyEntity(mCube);
        mParent->removeAndDestroyChild(mNode);
        takeSurvey();
        EXPECT_EQ(mSurvey.receivers().boxes().size(), 1U) << "the ground";
        // Not seldom at the very addresses of the ones before.
        mCube = addCube(Vector3(0, 0, i % 2 == 0 ? 40.0f : 0.0f), 0.5f, i != 3, mParent);
        mNode = mCube->getParentSceneNode();
        expect(i % 2 == 0 ? Nothing : Role{true, i != 3});
    }
}

TEST_P(SurveyChangeTest, AllDestroyed) {
    mManager->clearScene();
    takeSurvey();
    EXPECT_TRUE(mSurvey.receivers().empty());
    EXPECT_TRUE(mSearch.find(mSurvey, {.wsDirection = Vec3(0, -1, 0)}, 0.0).empty());
    EXPECT_TRUE(allCasters().empty());
}

TEST_P(SurveyChangeTest, ObjectsOwnBounds) {
    Ogre::ManualObject* object = mManager->createManualObject();
    drawTriangle(object, Vector3(0, 0, 40));
    mParent->attachObject(object);
    takeSurvey();
    EXPECT_FALSE(holds(mSurvey.receivers(), mSurvey, *object));
    drawTriangle(object, Vector3(0, 2, 0));
    takeSurvey();
    EXPECT_TRUE(holds(mSurvey.receivers(), mSurvey, *object));
    EXPECT_TRUE(
        holds(mSearch.find(mSurvey, {.wsDirection = Vec3(0, -1, 0)}, 0.0), mSurvey, *object));
}

TEST_P(SurveyChangeTest, AnotherSceneManagersObjectsAreItsOwn) {
    Ogre::SceneManager* other = mRoot.createSceneManager(GetParam());
    Ogre::Camera* camera = other->createCamera("viewer");
    other->getRootSceneNode()->createChildSceneNode()->attachObject(camera);
    other->_updateSceneGraph(camera);
    // The same survey and search, there and back again.
    mSurvey.take(*camera, *mViewport);
    EXPECT_TRUE(mSurvey.receivers().empty());
    EXPECT_TRUE(mSearch.find(mSurvey, {.wsDirection = Vec3(0, -1, 0)}, 0.0).empty());
    expect(Both);
    mSurvey.take(*camera, *mViewport);
    mRoot.destroySceneManager(other);
    expect(Both);
}

class OctreeChangeTest : public SurveyChangeTest {};

INSTANTIATE_TEST_SUITE_P(SceneManager, OctreeChangeTest, testing::Values(OctreeManager),
                         [](const auto& test) { return test.param; });

TEST_P(OctreeChangeTest, SizeAndDepth) {
    const Ogre::AxisAlignedBox small(-3, -3, -3, 3, 3, 3);
    ASSERT_TRUE(mManager->setOption("Size", &small));
    expect(Both);
    mNode->setPosition(0, 200, 0);
    expect({true, false});
    const int depth = 3;
    ASSERT_TRUE(mManager->setOption("Depth", &depth));
    expect({true, false});
    const Ogre::AxisAlignedBox large(-1e5f, -1e5f, -1e5f, 1e5f, 1e5f, 1e5f);
    ASSERT_TRUE(mManager->setOption("Size", &large));
    mNode->setPosition(0, 0, 0);
    expect(Both);
}

} // namespace
} // namespace Lixel::Tests
