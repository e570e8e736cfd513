// The surfaces of receivers that the viewer stands in or near, read from OGRE's meshes.
#include "SceneTest.h"

#include <OgreEntity.h>
#include <OgreManualObject.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;

class SurfaceCloudsTest : public SceneTest {};

INSTANTIATE_TEST_SUITE_P(SceneManager, SurfaceCloudsTest,
                         testing::Values(DefaultManager, OctreeManager),
                         [](const auto& test) { return test.param; });

/// How far a point is from the surface of the cube of that half extent about the origin.
double distanceToCube(const Vec3& p, double halfExtent) {
    return std::abs(p.cwiseAbs().maxCoeff() - halfExtent);
}

} // namespace

TEST_P(SurfaceCloudsTest, AreOfWhatTheViewerStandsInOrNear) {
    Ogre::Entity* around = addCube(Vector3::ZERO, 20.0f);
    addCube(Vector3(0, 0, -15), 0.5f); // far away for its size
    takeSurvey();
    ASSERT_EQ(mSurvey.receivers().size(), 2U);
    ASSERT_EQ(mSurvey.surfaces().size(), 1U);
    const KnownSurface& surface = mSurvey.surfaces().front();
    const Box box = mSurvey.receivers().box(surface.receiver);
    EXPECT_NEAR(box.halfExtents.x(), 20.0, 1e-3);
    ASSERT_EQ(surface.cloud->surfels.size(), SurfaceClouds::Discs);
    for (const Surfel& disc : surface.cloud->surfels)
        EXPECT_LT(distanceToCube(surface.wsFromCloud * disc.centre, 20.0), 1e-4);

    // Turned, moved, scaled and seen from elsewhere: the discs go with the body.
    around->getParentSceneNode()->setPosition(3, 4, -5);
    around->getParentSceneNode()->yaw(Ogre::Degree(30));
    mCameraNode->setPosition(2, 3, 1);
    takeSurvey();
    ASSERT_EQ(mSurvey.surfaces().size(), 1U);
    const KnownSurface& moved = mSurvey.surfaces().front();
    const Ogre::Affine3 cubeFromWorld = around->getParentSceneNode()->_getFullTransform().inverse();
    for (const Surfel& disc : moved.cloud->surfels) {
        const Vec3 ws = moved.wsFromCloud * disc.centre + mSurvey.wsOrigin();
        const Vector3 own =
            cubeFromWorld * Vector3(static_cast<float>(ws.x()), static_cast<float>(ws.y()),
                                    static_cast<float>(ws.z()));
        EXPECT_LT(distanceToCube(Vec3(own.x, own.y, own.z), 0.5), 1e-4);
    }
}

TEST_P(SurfaceCloudsTest, AreNotOfFlatBodies) {
    Ogre::Entity* ground = addCube(Vector3(0, -2, 0), 1.0f);
    ground->getParentSceneNode()->setScale(200, 1, 200);
    takeSurvey();
    EXPECT_EQ(mSurvey.receivers().size(), 1U);
    EXPECT_TRUE(mSurvey.surfaces().empty());
}

TEST_P(SurfaceCloudsTest, AreNotOfWhatDoesNotReceive) {
    addCube(Vector3::ZERO, 20.0f, false);
    takeSurvey();
    EXPECT_TRUE(mSurvey.surfaces().empty());
}

TEST_P(SurfaceCloudsTest, AreReadOncePerMesh) {
    addCube(Vector3::ZERO, 20.0f);
    addCube(Vector3(1, 0, 0), 20.0f);
    takeSurvey();
    ASSERT_EQ(mSurvey.surfaces().size(), 2U);
    const SurfaceCloud* const cloud = mSurvey.surfaces()[0].cloud;
    EXPECT_EQ(mSurvey.surfaces()[1].cloud, cloud);
    takeSurvey();
    EXPECT_EQ(mSurvey.surfaces()[0].cloud, cloud);
    EXPECT_LT(mSurvey.surfaces()[0].receiver, mSurvey.surfaces()[1].receiver);
}

TEST_P(SurfaceCloudsTest, OfANewMeshAtAnOldAddressAreItsOwn) {
    // One mesh after another of the same name, and likely at the same address.
    for (const float size : {10.0f, 30.0f, 15.0f}) {
        Ogre::ManualObject* drawn = mManager->createManualObject();
        drawn->begin(flatMaterial(true), Ogre::RenderOperation::OT_TRIANGLE_STRIP);
        // A slope that fills a fat box.
        drawn->position(-size, -size, -size);
        drawn->position(size, -size, -size);
        drawn->position(-size, size, size);
        drawn->position(size, size, size);
        drawn->end();
        const Ogre::MeshPtr mesh = drawn->convertToMesh("slope");
        Ogre::Entity* slope = mManager->createEntity(mesh);
        Ogre::SceneNode* node = mRootNode->createChildSceneNode();
        node->attachObject(slope);
        takeSurvey();
        ASSERT_EQ(mSurvey.surfaces().size(), 1U);
        for (const Surfel& disc : mSurvey.surfaces()[0].cloud->surfels) {
            EXPECT_NEAR(disc.centre.y(), disc.centre.z(), 1e-4);
            EXPECT_LE(disc.centre.cwiseAbs().maxCoeff(), static_cast<double>(size) + 1e-4);
        }
        EXPECT_GT(mSurvey.surfaces()[0].cloud->surfels.front().radius,
                  static_cast<double>(size) / 20.0);
        node->detachAllObjects();
        mManager->destroyEntity(slope);
        mManager->destroySceneNode(node);
        mManager->destroyManualObject(drawn);
        Ogre::MeshManager::getSingleton().remove(mesh->getHandle());
    }
}

} // namespace Lixel::Tests
