// Large meshes that reach out of the view, as receivers in parts, and what the viewer sees of them.
#include "SceneTest.h"

#include "fit/core/FitState.h"
#include "fit/problem/TexelInPixels.h"
#include "fit/technique/Optimal.h"

#include <OgreManualObject.h>
#include <OgreMaterialManager.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreTechnique.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

using Ogre::Vector3;

namespace Lixel::Tests {
namespace {

class MeshPartsTest : public SceneTest {
protected:
    static constexpr int Side = 80; // vertices
    static constexpr float Half = 100.0F;
    static constexpr std::size_t Most = 512;

    /// Hills, as one mesh; some of it stands upright in the viewer's way.
    /// @param known whether it is known to be a ground; else both its sides are drawn
    Ogre::Entity* addHills(bool known = false) {
        Ogre::ManualObject* const drawn = mManager->createManualObject();
        drawn->begin("BaseWhite", Ogre::RenderOperation::OT_TRIANGLE_LIST);
        for (int z = 0; z < Side; ++z)
            for (int x = 0; x < Side; ++x) {
                const float u = static_cast<float>(2 * x) / (Side - 1) - 1.0F;
                const float v = static_cast<float>(2 * z) / (Side - 1) - 1.0F;
                const Vector3 vertex(Half * u, 4.0F * std::sin(9 * u + 7 * v), Half * v);
                drawn->position(vertex);
                mVertices.push_back(vertex);
            }
        const auto triangle = [&](int a, int b, int c) {
            drawn->triangle(static_cast<Ogre::uint32>(a), static_cast<Ogre::uint32>(b),
                            static_cast<Ogre::uint32>(c));
            mTriangles.push_back({a, b, c});
        };
        for (int z = 0; z + 1 < Side; ++z)
            for (int x = 0; x + 1 < Side; ++x) {
                const int i = z * Side + x;
                triangle(i, i + Side, i + 1);
                triangle(i + 1, i + Side, i + Side + 1);
            }
        drawn->end();
        mMesh = drawn->convertToMesh("hills");
        mManager->destroyManualObject(drawn);
        Ogre::Entity* const entity = mManager->createEntity(mMesh);
        if (!known) entity->setMaterial(mBothSides);
        mNode = mRootNode->createChildSceneNode();
        mNode->attachObject(entity);
        return entity;
    }

    MeshPartsTest()
        : mBothSides(
              Ogre::MaterialManager::getSingleton().getByName("BaseWhite")->clone("both sides")) {
        mBothSides->setCullingMode(Ogre::CULL_NONE);
    }
    ~MeshPartsTest() override {
        mSurvey.meshes().setFrameTime(MeshShapes::DefaultFrameTime);
        if (mMesh) Ogre::MeshManager::getSingleton().remove(mMesh->getHandle());
        Ogre::MaterialManager::getSingleton().remove(mBothSides->getHandle());
    }

    /// Surveys until the mesh is read.
    const Survey& takeSurveyInParts(std::size_t most = Most) {
        for (int frame = 0; frame < 100; ++frame)
            if (!takeSurvey(most).visiblePoints().empty()) break;
        return mSurvey;
    }

    /// Sets what the last survey knows of a problem, whose light is set.
    void describe(ShadowProblem& problem) {
        problem.viewer = mSurvey.viewer();
        problem.receivers = &mSurvey.receivers();
        problem.receiverShapes = &mSurvey.receiverShapes();
        problem.visiblePoints = mSurvey.visiblePoints();
        problem.casters = &mSearch.find(mSurvey, problem.light, 0.0);
        problem.casterShapes = &mSearch.shapes();
    }

    /// A vertex, relative to the survey's origin.
    Vec3 placed(int vertex) const {
        const Vector3 ws = mNode->_getFullTransform() * mVertices[static_cast<std::size_t>(vertex)];
        return Vec3(ws.x, ws.y, ws.z) - mSurvey.wsOrigin();
    }

    /// How far a ray from the viewer goes until it meets a triangle, in lengths of its direction.
    double distanceAlong(const Vec3& direction) const {
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& [a, b, c] : mTriangles) {
            const Vec3 p = placed(a);
            Mat3 sides;
            sides << placed(b) - p, placed(c) - p, -direction;
            const Vec3 found = sides.colPivHouseholderQr().solve(-p);
            if (found.x() >= 0.0 && found.y() >= 0.0 && found.x() + found.y() <= 1.0 &&
                found.z() > 0.0)
                nearest = std::min(nearest, found.z());
        }
        return nearest;
    }

    std::vector<Vector3> mVertices;
    std::vector<std::array<int, 3>> mTriangles;
    Ogre::MeshPtr mMesh;
    Ogre::MaterialPtr mBothSides;
    Ogre::SceneNode* mNode = nullptr;
};

INSTANTIATE_TEST_SUITE_P(SceneManager, MeshPartsTest,
                         testing::Values(DefaultManager, OctreeManager, FlatManager),
                         [](const auto& test) { return test.param; });

} // namespace

TEST_P(MeshPartsTest, AreReceiversThatHoldAllInView) {
    addHills();
    mNode->setOrientation(Ogre::Quaternion(Ogre::Degree(20), Vector3(1, 3, 0).normalisedCopy()));
    mCameraNode->setPosition(3, 12, 5);
    takeSurveyInParts();
    const BoxSet& receivers = mSurvey.receivers();
    EXPECT_GT(receivers.size(), 16U);
    EXPECT_LE(receivers.size(), Most);
    EXPECT_EQ(mSurvey.receiverObjects().size(), 1U);
    const Mat4 clipFromWorld = mSurvey.viewer().clipFromView * mSurvey.viewer().viewFromWorld;
    int seen = 0;
    for (int i = 0; i < Side * Side; ++i) {
        const Vec3 ws = placed(i);
        const Vec4 clip = clipFromWorld * ws.homogeneous();
        if (!(clip.head<3>().cwiseAbs().maxCoeff() < clip.w())) continue;
        ++seen;
        EXPECT_TRUE(std::ranges::any_of(
            receivers.boxes(),
            [&](const Aabb& box) {
                return ((ws - box.centre).cwiseAbs() - box.halfExtents).maxCoeff() < 1e-4;
            }))
            << "vertex " << i;
    }
    EXPECT_GT(seen, 100);
    // Nothing but their boxes is known of parts, and what they are of.
    Transform3 wsFromBody;
    SelfShadowFree body;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        EXPECT_EQ(mSurvey.receiverShapes().hullOf(i, wsFromBody), nullptr);
        EXPECT_FALSE(mSurvey.receiverShapes().isSelfShadowFree(i, body));
        EXPECT_EQ(mSurvey.receiverShapes().identityOf(i), mSurvey.receiverObjects().front());
    }
}

TEST_P(MeshPartsTest, AreSeenWhereTheirTrianglesAre) {
    addHills();
    mCameraNode->setPosition(3, 12, 5);
    mCameraNode->pitch(Ogre::Degree(-40));
    takeSurveyInParts(2048);
    ASSERT_EQ(mSurvey.visiblePoints().size(), ViewRays::Rounds * ViewRays::Count);
    std::size_t met = 0;
    std::size_t near = 0;
    for (const VisiblePoint& point : mSurvey.visiblePoints()) {
        if (point.wsNormal.isZero(0.0)) continue;
        ++met;
        EXPECT_NEAR(point.wsNormal.norm(), 1.0, 1e-9);
        EXPECT_GT(point.wsNormal.y(), 0.3);
        if (std::abs(distanceAlong(point.ws) - 1.0) < 0.03) ++near;
    }
    EXPECT_GT(met, mSurvey.visiblePoints().size() / 2);
    EXPECT_GT(static_cast<double>(near), 0.95 * static_cast<double>(met));
}

TEST_P(MeshPartsTest, LeaveMapsSteadyWhileTheViewerTurns) {
    // As the contract of a fit has it: ln m changes by 0.02 at most where the viewer turns by 1e-4.
    addHills();
    mCameraNode->setPosition(3, 9, 5);
    takeSurveyInParts();
    ShadowProblem problem;
    // Lower than the hills are steep, so that they shadow each other.
    problem.light.wsDirection = Vec3(1.0, -0.3, 0.4);
    FitState state;
    ShadowFit before;
    ShadowViewer viewerBefore;
    std::size_t jumps = 0;
    double greatest = 0.0;
    int measured = 0;
    for (int step = 0; step < 600; ++step) {
        mCameraNode->setOrientation(
            Ogre::Quaternion(Ogre::Radian(1e-4F * static_cast<float>(step)), Vector3::UNIT_Y) *
            Ogre::Quaternion(Ogre::Degree(-15), Vector3::UNIT_X));
        takeSurvey(Most);
        ASSERT_GT(mSurvey.receivers().size(), 1U);
        describe(problem);
        const ShadowFit fit = fitMap(problem, OptimalOptions{}, state);
        ASSERT_TRUE(fit.hasMap());
        // The first frame has no frame before; an axis that turns for a smaller map is forgiven.
        if (step > 0 && state.memory.orientationJumps == jumps)
            for (int i = 0; i < Side * Side; i += 7) {
                const auto texel = [&](const ShadowFit& one, const ShadowViewer& viewer) {
                    return texelInPixels(one, Vec2(1024.0, 1024.0), viewer, Vec2(640.0, 480.0),
                                         placed(i), Vec3::UnitY());
                };
                const Vec4 clip = fit.clipFromWorld * placed(i).homogeneous();
                const auto now = texel(fit, problem.viewer);
                const auto last = texel(before, viewerBefore);
                if (!now || !last || !(clip.head<2>().cwiseAbs().maxCoeff() < clip.w())) continue;
                greatest = std::max(greatest, std::abs(std::log(*now / *last)));
                ++measured;
            }
        jumps = state.memory.orientationJumps;
        before = fit;
        viewerBefore = problem.viewer;
    }
    EXPECT_GT(measured, 600 * 50);
    EXPECT_LE(greatest, 0.02);
    EXPECT_LE(jumps, 3U);
}

TEST_P(MeshPartsTest, AreForViewRaysAloneOfAGround) {
    addHills(true);
    mCameraNode->setPosition(3, 9, 5);
    mCameraNode->pitch(Ogre::Degree(-15));
    takeSurveyInParts(2048);
    ASSERT_EQ(mSurvey.receivers().size(), 1U);
    EXPECT_EQ(mSurvey.receiverObjects().size(), 1U);
    SelfShadowFree body;
    EXPECT_TRUE(mSurvey.receiverShapes().isSelfShadowFree(0, body));
    std::size_t met = 0;
    std::size_t near = 0;
    for (const VisiblePoint& point : mSurvey.visiblePoints()) {
        if (point.wsNormal.isZero(0.0)) continue;
        ++met;
        if (std::abs(distanceAlong(point.ws) - 1.0) < 0.05) ++near;
    }
    EXPECT_GT(met, mSurvey.visiblePoints().size() / 3);
    EXPECT_GT(static_cast<double>(near), 0.9 * static_cast<double>(met));
    // It shadows nothing of itself under a high sun.
    ShadowProblem problem;
    for (const double height : {0.3, 3.0}) {
        problem.light.wsDirection = Vec3(1.0, -height, 0.4);
        describe(problem);
        FitState state;
        const ShadowFit fit = fitMap(problem, OptimalOptions{}, state);
        EXPECT_EQ(fit.hasMap(), height < 1.0);
        EXPECT_EQ(fit.reason == FitReason::NothingShadowed, height > 1.0);
    }
}

TEST_P(MeshPartsTest, AreNotOfAGroundTooLargeToHaveBounds) {
    addHills(true);
    mCameraNode->setPosition(3, 9, 5);
    takeSurveyInParts();
    ASSERT_EQ(mSurvey.receivers().size(), 1U);
    mNode->setScale(Vector3(1e17F));
    takeSurveyInParts();
    EXPECT_EQ(mSurvey.receivers().unbounded(), 1U);
    EXPECT_EQ(mSurvey.receivers().size(), 0U);
    EXPECT_EQ(mSurvey.receiverShapes().identityOf(0), nullptr);
    EXPECT_TRUE(mSurvey.receiverObjects().empty());
}

TEST_P(MeshPartsTest, AreHiddenByOtherBodies) {
    addHills();
    mCameraNode->setPosition(3, 12, 5);
    mCameraNode->pitch(Ogre::Degree(-40));
    takeSurveyInParts();
    addCube(Vector3(3, 8, 1), 2.0F);
    takeSurveyInParts();
    const Aabb cube{Vec3(0.0, -4.0, -4.0), Vec3::Constant(2.0)};
    EXPECT_GT(std::ranges::count_if(
                  mSurvey.visiblePoints(),
                  [&](const VisiblePoint& point) {
                      return ((point.ws - cube.centre).cwiseAbs() - cube.halfExtents).maxCoeff() <
                             1e-4;
                  }),
              10);
    EXPECT_EQ(mSurvey.receiverObjects().size(), 2U);
}

TEST_P(MeshPartsTest, AreNotOfWhatIsAskedForAsAWhole) {
    addHills();
    mCameraNode->setPosition(3, 12, 5);
    takeSurvey();
    EXPECT_EQ(mSurvey.receivers().size(), 1U);
    EXPECT_TRUE(mSurvey.visiblePoints().empty());
    EXPECT_EQ(mSurvey.receiverObjects().size(), 1U);
}

TEST_P(MeshPartsTest, AreNotOfWhatIsInViewAsAWhole) {
    addHills();
    mCameraNode->setPosition(0, 200, 0);
    mCameraNode->pitch(Ogre::Degree(-90));
    takeSurveyInParts();
    EXPECT_EQ(mSurvey.receivers().size(), 1U);
}

TEST_P(MeshPartsTest, AreNotOfConvexBodiesNorOfDistantOnes) {
    addHills();
    mCameraNode->setPosition(0, 10, 600);
    addCube(Vector3(20, 10, 580), 19.0F);
    takeSurveyInParts();
    EXPECT_EQ(mSurvey.receivers().size(), 2U);
}

TEST_P(MeshPartsTest, AreReadALittleEachFrameOrPrepared) {
    addHills();
    mCameraNode->setPosition(3, 12, 5);
    mSurvey.meshes().setFrameTime(20.0);
    takeSurvey(Most);
    EXPECT_EQ(mSurvey.receivers().size(), 1U) << "as a whole, until it is read";
    const std::uint64_t unrest = mSurvey.meshes().unrest();
    takeSurvey(Most);
    EXPECT_NE(mSurvey.meshes().unrest(), unrest);
    mSurvey.meshes().prepare(mMesh, Most);
    takeSurvey(Most);
    EXPECT_GT(mSurvey.receivers().size(), 1U);
    const std::size_t receivers = mSurvey.receivers().size();
    const std::size_t read = mSurvey.meshes().bytesRead();
    takeSurvey(Most / 2);
    EXPECT_EQ(mSurvey.meshes().bytesRead(), read) << "as many as the other asked for";
    EXPECT_EQ(mSurvey.receivers().size(), receivers);
}

} // namespace Lixel::Tests
