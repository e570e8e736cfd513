// The shapes of meshes, read from OGRE's buffers: surfaces of what the viewer stands in or near,
// and hulls of what fills its box badly.
#include "SceneTest.h"

#include <OgreEntity.h>
#include <OgreManualObject.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreSkeleton.h>
#include <OgreSkeletonManager.h>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;

class SurfaceCloudsTest : public SceneTest {};

INSTANTIATE_TEST_SUITE_P(SceneManager, SurfaceCloudsTest,
                         testing::Values(DefaultManager, OctreeManager, FlatManager),
                         [](const auto& test) { return test.param; });

/// How far a point is from the surface of the cube of that half extent about the origin.
double distanceToCube(const Vec3& p, double halfExtent) {
    return std::abs(p.cwiseAbs().maxCoeff() - halfExtent);
}

class HullsTest : public SceneTest {
protected:
    /// A plank aslant, 20 units ahead.
    Ogre::Entity* addPlank(Ogre::Entity* plank = nullptr) {
        if (plank == nullptr) plank = addCube(Vector3(0, 0, -20), 0.5f);
        plank->setMaterialName("BaseWhite"); // which has no programs
        Ogre::SceneNode* const node = plank->getParentSceneNode();
        node->setPosition(0, 0, -20);
        node->setScale(8, 0.4f, 0.4f);
        node->setOrientation(Ogre::Quaternion(Ogre::Degree(40), Vector3(1, 2, 3).normalisedCopy()));
        return plank;
    }

    /// A mesh of that name, the unit cube.
    Ogre::MeshPtr makeCube(const std::string& name, bool dynamic = false) {
        Ogre::ManualObject* drawn = mManager->createManualObject();
        drawn->setDynamic(dynamic);
        drawn->begin(flatMaterial(true), Ogre::RenderOperation::OT_TRIANGLE_LIST);
        for (int i = 0; i < 8; ++i)
            drawn->position((i & 1) != 0 ? 0.5f : -0.5f, (i & 2) != 0 ? 0.5f : -0.5f,
                            (i & 4) != 0 ? 0.5f : -0.5f);
        for (const auto& quad : {std::array{0U, 2U, 3U, 1U},
                                 {4U, 5U, 7U, 6U},
                                 {0U, 1U, 5U, 4U},
                                 {2U, 6U, 7U, 3U},
                                 {0U, 4U, 6U, 2U},
                                 {1U, 3U, 7U, 5U}})
            drawn->quad(quad[0], quad[1], quad[2], quad[3]);
        drawn->end();
        mMeshes.push_back(drawn->convertToMesh(name));
        mManager->destroyManualObject(drawn);
        return mMeshes.back();
    }

    /// A plank of that mesh.
    Ogre::Entity* addPlankOf(const Ogre::MeshPtr& mesh) {
        Ogre::Entity* const cube = mManager->createEntity(mesh);
        mRootNode->createChildSceneNode()->attachObject(cube);
        return addPlank(cube);
    }

    ~HullsTest() override {
        for (const Ogre::MeshPtr& mesh : mMeshes)
            Ogre::MeshManager::getSingleton().remove(mesh->getHandle());
    }

    /// The hull of the one receiver, which must be the one caster too.
    const BodyHull* hull() {
        takeSurvey();
        EXPECT_EQ(mSurvey.receivers().size(), 1U);
        EXPECT_EQ(allCasters().size(), 1U);
        Transform3 ofCaster;
        const BodyHull* const caster = mSearch.shapes().hullOf(0, ofCaster);
        const BodyHull* const receiver = mSurvey.receiverShapes().hullOf(0, mWsFromBody);
        EXPECT_EQ(caster, receiver);
        if (caster != nullptr) {
            EXPECT_TRUE(ofCaster.isApprox(mWsFromBody));
        }
        return receiver;
    }

    Transform3 mWsFromBody;

private:
    std::vector<Ogre::MeshPtr> mMeshes;
};

INSTANTIATE_TEST_SUITE_P(SceneManager, HullsTest,
                         testing::Values(DefaultManager, OctreeManager, FlatManager),
                         [](const auto& test) { return test.param; });

} // namespace

TEST_P(HullsTest, AreOfWhatFillsItsBoxBadly) {
    mCameraNode->setPosition(1, 2, 3);
    const Ogre::Entity* const plank = addPlank();
    const BodyHull* const found = hull();
    ASSERT_NE(found, nullptr);
    // All corners of the plank are the hull's, where they are in the world.
    const Ogre::Affine3& full = plank->getParentSceneNode()->_getFullTransform();
    for (int i = 0; i < 8; ++i) {
        const Vector3 corner =
            full * Vector3((i & 1) != 0 ? 0.5f : -0.5f, (i & 2) != 0 ? 0.5f : -0.5f,
                           (i & 4) != 0 ? 0.5f : -0.5f);
        const Vec3 relative = Vec3(corner.x, corner.y, corner.z) - mSurvey.wsOrigin();
        double nearest = 1e30;
        for (const Vec3& vertex : found->vertices)
            nearest = std::min(nearest, (mWsFromBody * vertex - relative).norm());
        EXPECT_LT(nearest, 1e-4);
    }
}

TEST_P(HullsTest, AreNotOfWhatFillsItsBox) {
    addCube(Vector3(0, 0, -20), 3.0f);
    EXPECT_EQ(hull(), nullptr);
}

TEST_P(HullsTest, AreOfMeshesThatApplicationsMake) {
    addPlankOf(makeCube("own"));
    EXPECT_NE(hull(), nullptr);
}

TEST_P(HullsTest, AreNotOfWhatAVertexProgramMayMove) {
    addPlank()->setMaterial(flatMaterial(true));
    EXPECT_EQ(hull(), nullptr);
}

/// Its next shape may go beyond this one's.
TEST_P(HullsTest, AreNotOfMeshesThatAreRewritten) {
    addPlankOf(makeCube("rewritten", true));
    EXPECT_EQ(hull(), nullptr);
}

/// A vertex program that moves vertices has bounds that hold what it makes.
TEST_P(HullsTest, AreNotOfMeshesWithLargerBoundsThanTheirVertices) {
    const Ogre::MeshPtr mesh = makeCube("waving");
    mesh->_setBounds(Ogre::AxisAlignedBox(-0.5f, -0.5f, -0.5f, 0.5f, 0.6f, 0.5f));
    addPlankOf(mesh);
    EXPECT_EQ(hull(), nullptr);
}

TEST_P(HullsTest, AreNotOfMeshesThatGotOtherBounds) {
    const Ogre::MeshPtr mesh = makeCube("grown");
    addPlankOf(mesh);
    EXPECT_NE(hull(), nullptr);
    mesh->_setBounds(Ogre::AxisAlignedBox(-0.5f, -0.5f, -0.5f, 0.5f, 0.6f, 0.5f));
    EXPECT_EQ(hull(), nullptr);
}

/// A level of detail that was made by hand may be of any shape.
TEST_P(HullsTest, AreNotOfMeshesWithManualLevelsOfDetail) {
    const Ogre::MeshPtr mesh = makeCube("near");
    addPlankOf(mesh);
    EXPECT_NE(hull(), nullptr);
    mesh->_setLodInfo(2);
    Ogre::MeshLodUsage far;
    far.userValue = 100;
    far.value = 100;
    far.manualName = "far";
    mesh->_setLodUsage(1, far);
    EXPECT_EQ(hull(), nullptr);
}

TEST_P(HullsTest, AreNotOfWhatHasASkeleton) {
    Ogre::SkeletonPtr skeleton =
        Ogre::SkeletonManager::getSingleton().create("bones", Ogre::RGN_DEFAULT, true);
    skeleton->createBone();
    skeleton->setBindingPose();
    const Ogre::MeshPtr mesh = makeCube("boned");
    mesh->_notifySkeleton(skeleton);
    const Ogre::Entity* const plank = addPlankOf(mesh);
    ASSERT_TRUE(plank->hasSkeleton());
    EXPECT_EQ(hull(), nullptr);
    Ogre::SkeletonManager::getSingleton().remove(skeleton->getHandle());
}

TEST_P(HullsTest, AreNotOfWhatMorphs) {
    const Ogre::MeshPtr mesh = makeCube("morphing");
    mesh->createAnimation("swell", 1);
    const Ogre::Entity* const plank = addPlankOf(mesh);
    ASSERT_TRUE(plank->hasVertexAnimation());
    EXPECT_EQ(hull(), nullptr);
}

TEST_P(SurfaceCloudsTest, AreOfWhatTheViewerStandsInOrNear) {
    Ogre::Entity* around = addCube(Vector3::ZERO, 20.0f);
    addCube(Vector3(0, 0, -15), 0.5f); // far away for its size
    takeSurvey();
    ASSERT_EQ(mSurvey.receivers().size(), 2U);
    ASSERT_EQ(mSurvey.surfaces().size(), 1U);
    const KnownSurface& surface = mSurvey.surfaces().front();
    const Aabb box = mSurvey.receivers().box(surface.receiver);
    EXPECT_NEAR(box.halfExtents.x(), 20.0, 1e-3);
    ASSERT_EQ(surface.cloud->surfels.size(), MeshShapes::Discs);
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
