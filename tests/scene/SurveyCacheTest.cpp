// One survey for all lights of a preparation, and never one of another moment, as seen from within
// OGRE's own frames.
#include "SceneTest.h"

#include "scene/SurveyCache.h"

#include <OgreRenderWindow.h>

#include <vector>

using Ogre::Vector3;

namespace Lixel::Tests {
namespace {

struct Seen {
    const Ogre::Camera* viewer;
    std::vector<Aabb> casters;
    Vec3 wsOrigin;
    double microseconds;
};

class SurveyCacheTest : public SceneTest {
protected:
    std::vector<Seen> mSeen;
    double mDistance = 0.0;
    Ogre::ShadowCameraSetupPtr mProbe = std::make_shared<ProbeSetup>(
        [this](const Ogre::Camera& viewer, const Ogre::Viewport& viewport) {
            const TimedSurvey& timed = surveyFor(viewer, viewport, mDistance);
            Seen seen{&viewer, {}, timed.survey.wsOrigin(), timed.microseconds};
            for (const Aabb& box : mSearch.findAll(timed.survey).boxes())
                seen.casters.push_back(box);
            mSeen.push_back(std::move(seen));
        });
    Ogre::RenderTarget& window() { return *mViewport->getTarget(); }
};

INSTANTIATE_TEST_SUITE_P(SceneManager, SurveyCacheTest,
                         testing::Values(DefaultManager, OctreeManager, FlatManager),
                         [](const auto& test) { return test.param; });

TEST_P(SurveyCacheTest, IsOfThisFrame) {
    addSun(mProbe);
    Ogre::SceneNode* parent = mRootNode->createChildSceneNode();
    Ogre::Entity* cube = addCube(Vector3(0, 0, -10), 0.5f, true, parent);
    mRoot.renderOneFrame();
    parent->translate(5, 0, 0);
    cube->getParentSceneNode()->translate(0, 1, 0);
    mCameraNode->setPosition(0, 0, 2);
    mRoot.renderOneFrame();
    ASSERT_EQ(mSeen.size(), 2U);
    ASSERT_EQ(mSeen[0].casters.size(), 1U);
    EXPECT_EQ(mSeen[0].casters[0].centre, Vec3(0, 0, -10));
    ASSERT_EQ(mSeen[1].casters.size(), 1U);
    EXPECT_EQ(mSeen[1].wsOrigin, Vec3(0, 0, 2));
    EXPECT_EQ(mSeen[1].casters[0].centre, Vec3(5, 1, -12));
}

TEST_P(SurveyCacheTest, SeesAnObjectInTheFrameInWhichItArrives) {
    addSun(mProbe);
    mRoot.renderOneFrame();
    Ogre::Entity* cube = addCube(Vector3(0, 0, -10));
    mRoot.renderOneFrame();
    mManager->destroyEntity(cube);
    mRoot.renderOneFrame();
    ASSERT_EQ(mSeen.size(), 3U);
    EXPECT_EQ(mSeen[0].casters.size(), 0U);
    EXPECT_EQ(mSeen[1].casters.size(), 1U);
    EXPECT_EQ(mSeen[2].casters.size(), 0U);
}

TEST_P(SurveyCacheTest, SeesWhatWasChangedBetweenTwoLights) {
    Ogre::Entity* const cube = addCube(Vector3(0, 0, -10));
    addCube(Vector3(2, 0, -10));
    // As a listener may, when the first light's map has been drawn.
    auto changing = std::make_shared<ProbeSetup>(
        [this, cube](const Ogre::Camera& viewer, const Ogre::Viewport& viewport) {
            const TimedSurvey& timed = surveyFor(viewer, viewport, mDistance);
            EXPECT_EQ(mSearch.findAll(timed.survey).size(), cube->getCastShadows() ? 2U : 1U);
            cube->setCastShadows(!cube->getCastShadows());
        });
    for (int light = 0; light < 3; ++light)
        addSun(changing);
    for (int frame = 0; frame < 2; ++frame)
        mRoot.renderOneFrame();
}

TEST_P(SurveyCacheTest, TwoLightsShareOneSurvey) {
    addSun(mProbe);
    addSun(mProbe, Vector3(1, -1, 0));
    addCube(Vector3(0, 0, -10));
    for (int frame = 0; frame < 3; ++frame) {
        mSeen.clear();
        mRoot.renderOneFrame();
        ASSERT_EQ(mSeen.size(), 2U);
        EXPECT_GT(mSeen[0].microseconds, 0.0);
        EXPECT_EQ(mSeen[1].microseconds, 0.0);
        EXPECT_EQ(mSeen[1].casters.size(), 1U);
    }
}

TEST_P(SurveyCacheTest, ALightOfFartherShadowsHasItTakenAgain) {
    addCube(Vector3(0, 0, -10));
    addCube(Vector3(0, 0, -30));
    mManager->_updateSceneGraph(mCamera);
    const auto seen = [&](double distance) {
        return surveyFor(*mCamera, *mViewport, distance).survey.receivers().boxes().size();
    };
    const auto isNew = [&](double distance) {
        return surveyFor(*mCamera, *mViewport, distance).microseconds > 0.0;
    };
    EXPECT_EQ(seen(20), 1U);
    EXPECT_FALSE(isNew(20));
    EXPECT_FALSE(isNew(15));
    EXPECT_EQ(seen(40), 2U);
    EXPECT_FALSE(isNew(20)) << "a survey that reaches farther does for both";
    EXPECT_TRUE(isNew(0)) << "0 is as far as the viewer sees";
    EXPECT_FALSE(isNew(40));
    EXPECT_EQ(seen(40), 2U);
}

TEST_P(SurveyCacheTest, TwoCamerasOfOneFrameDoNot) {
    addSun(mProbe);
    addCube(Vector3(0, 0, -10));
    Ogre::Camera* second = mManager->createCamera("second");
    mRootNode->createChildSceneNode(Vector3(0, 0, 30))->attachObject(second);
    window().addViewport(second, 1, 0.5f, 0, 0.5f, 1);
    mRoot.renderOneFrame();
    ASSERT_EQ(mSeen.size(), 2U);
    EXPECT_EQ(mSeen[0].viewer, mCamera);
    EXPECT_EQ(mSeen[1].viewer, second);
    for (const Seen& seen : mSeen)
        EXPECT_GT(seen.microseconds, 0.0);
    EXPECT_EQ(mSeen[1].casters.at(0).centre, Vec3(0, 0, -40));
}

TEST_P(SurveyCacheTest, TwoViewportsOfOneCameraDoNot) {
    addSun(mProbe);
    Ogre::Entity* cube = addCube(Vector3(0, 0, -10));
    cube->setVisibilityFlags(1);
    Ogre::Viewport* second = window().addViewport(mCamera, 1, 0.5f, 0, 0.5f, 1);
    second->setVisibilityMask(2);
    mRoot.renderOneFrame();
    ASSERT_EQ(mSeen.size(), 2U);
    EXPECT_EQ(mSeen[0].casters.size(), 1U);
    EXPECT_EQ(mSeen[1].casters.size(), 0U);
}

TEST_P(SurveyCacheTest, TwoRendersOfOneFrameNumberDoNot) {
    addSun(mProbe);
    Ogre::Entity* cube = addCube(Vector3(0, 0, -10));
    const unsigned long frame = mRoot.getNextFrameNumber();
    window().update();
    cube->getParentSceneNode()->translate(4, 0, 0);
    window().update();
    ASSERT_EQ(mRoot.getNextFrameNumber(), frame);
    ASSERT_EQ(mSeen.size(), 2U);
    EXPECT_EQ(mSeen[0].casters.at(0).centre, Vec3(0, 0, -10));
    EXPECT_EQ(mSeen[1].casters.at(0).centre, Vec3(4, 0, -10));
}

TEST_P(SurveyCacheTest, TwoSceneManagersDoNot) {
    addSun(mProbe);
    addCube(Vector3(0, 0, -10));
    mRoot.renderOneFrame();
    Ogre::SceneManager* other = mRoot.createSceneManager(GetParam());
    Ogre::Camera* camera = other->createCamera("viewer");
    other->getRootSceneNode()->attachObject(camera);
    // Without objects, on the same viewport and in the same frame.
    EXPECT_TRUE(surveyFor(*camera, *mViewport, 0.0).survey.receivers().empty());
    EXPECT_EQ(surveyFor(*mCamera, *mViewport, 0.0).survey.receivers().boxes().size(), 1U);
    // The survey goes with its scene manager, and one at the same address gets its own.
    mRoot.destroySceneManager(other);
    other = mRoot.createSceneManager(GetParam());
    camera = other->createCamera("viewer");
    other->getRootSceneNode()->attachObject(camera);
    EXPECT_GT(surveyFor(*camera, *mViewport, 0.0).microseconds, 0.0);
    mRoot.destroySceneManager(other);
}

} // namespace
} // namespace Lixel::Tests
