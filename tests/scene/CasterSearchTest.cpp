// Which casters a light's search finds: none that matters may be lost, whatever is left out.
#include "SceneTest.h"

#include "fit/core/FitState.h"
#include "fit/focus/ViewVolume.h"
#include "fit/technique/Uniform.h"
#include "scene/OgreMath.h"

#include <OgreManualObject.h>
#include <OgreSubEntity.h>

#include <random>

using Ogre::Vector3;

namespace Lixel::Tests {
namespace {

ShadowLight sunAlong(const Vec3& wsDirection) {
    return {.wsDirection = wsDirection};
}

ShadowFit fit(const Survey& survey, const ShadowLight& light, double shadowDistance,
              const BoxSet& casters) {
    ShadowProblem problem;
    problem.viewer = survey.viewer();
    problem.viewer.shadowDistance = shadowDistance;
    problem.light = light;
    problem.casters = &casters;
    problem.receivers = &survey.receivers();
    // The nearest caster shows in the depth range.
    problem.depthClamp = false;
    FitState state;
    return fitMap(problem, UniformOptions{}, state);
}

class CasterSearchTest : public SceneTest {
protected:
    const BoxSet& find(const ShadowLight& light, double shadowDistance = 0.0) {
        takeSurvey();
        return mSearch.find(mSurvey, light, shadowDistance);
    }
    bool finds(const Ogre::MovableObject& object, const ShadowLight& light,
               double shadowDistance = 0.0) {
        return holds(find(light, shadowDistance), mSurvey, object);
    }
    FitReason reason(const ShadowLight& light, double shadowDistance = 0.0) {
        return fit(mSurvey, light, shadowDistance, find(light, shadowDistance)).reason;
    }
    /// A receiver that casts nothing, 10 in front of the viewer and 2 below.
    Ogre::Entity* addGround() {
        Ogre::Entity* ground = addCube(Vector3(0, -2.5f, -10));
        ground->setCastShadows(false);
        return ground;
    }

    const ShadowLight mDown = sunAlong({0, -1, 0});
};

INSTANTIATE_TEST_SUITE_P(SceneManager, CasterSearchTest,
                         testing::Values(DefaultManager, OctreeManager, OtherManager, FlatManager),
                         [](const auto& test) { return test.param; });

TEST_P(CasterSearchTest, FindsTheCasterBehindTheViewer) {
    addGround();
    Ogre::Entity* behind = addCube(Vector3(0, 18, 10));
    EXPECT_TRUE(finds(*behind, sunAlong({0, -1, -1})));
}

TEST_P(CasterSearchTest, FindsTheCasterHoweverFarAway) {
    addGround();
    Ogre::Entity* far = addCube(Vector3(0, 50000, -10));
    EXPECT_TRUE(finds(*far, mDown));
}

TEST_P(CasterSearchTest, LeavesOutWhoseShadowFallsElsewhere) {
    addGround();
    Ogre::Entity* over = addCube(Vector3(0, 4, -10), 0.5f, false);
    const Ogre::Entity* beside = addCube(Vector3(4, 4, -10), 0.5f, false);
    const Ogre::Entity* below = addCube(Vector3(0, -9, -10), 0.5f, false);
    EXPECT_TRUE(finds(*over, mDown));
    EXPECT_FALSE(holds(mSearch.find(mSurvey, mDown, 0.0), mSurvey, *beside));
    EXPECT_FALSE(holds(mSearch.find(mSurvey, mDown, 0.0), mSurvey, *below));
}

TEST_P(CasterSearchTest, LeavesOutWhatShadowsOnlyBeyondTheShadowDistance) {
    Ogre::Entity* ground = addGround();
    ground->getParentSceneNode()->setScale(10, 1, 800);
    Ogre::Entity* near = addCube(Vector3(0, 2, -30));
    Ogre::Entity* far = addCube(Vector3(0, 2, -60));
    EXPECT_TRUE(finds(*near, mDown, 50));
    EXPECT_FALSE(finds(*far, mDown, 50));
    EXPECT_TRUE(finds(*far, mDown, 70));
    EXPECT_TRUE(finds(*far, mDown));
}

TEST_P(CasterSearchTest, OfASpotAreThoseInItsCone) {
    Ogre::Entity* ground = addGround();
    ground->getParentSceneNode()->setScale(40, 1, 40);
    const ShadowLight spot{.kind = LightKind::Spot,
                           .wsDirection = Vec3(0, -1, 0),
                           .wsPosition = Vec3(0, 10, -10),
                           .outerHalfAngle = 0.3,
                           .nearDistance = 0.5,
                           .range = 50};
    EXPECT_TRUE(finds(*addCube(Vector3(0, 5, -10)), spot));
    EXPECT_TRUE(finds(*addCube(Vector3(2.5f, 0, -10)), spot));
    EXPECT_FALSE(finds(*addCube(Vector3(8, 0, -10)), spot));
    EXPECT_FALSE(finds(*addCube(Vector3(0, 15, -10)), spot)) << "above the lamp";
    ShadowLight weak = spot;
    weak.range = 5;
    EXPECT_FALSE(finds(*addCube(Vector3(1, 4, -10)), weak)) << "the ground is out of its range";
}

TEST_P(CasterSearchTest, FindsInNodesFarFromTheirParents) {
    addGround();
    Ogre::SceneNode* parent = mRootNode->createChildSceneNode(Vector3(500, 0, 500));
    parent->attachObject(mManager->createEntity(cubeMesh(*mManager)));
    Ogre::SceneNode* empty = parent->createChildSceneNode(Vector3(500, 0, 500));
    Ogre::Entity* over = addCube(Vector3(-1000, 4, -1010), 0.5f, true, empty);
    ASSERT_FALSE(finds(*static_cast<Ogre::Entity*>(parent->getAttachedObjects().front()), mDown));
    EXPECT_TRUE(finds(*over, mDown));
    Ogre::Entity* under = addCube(Vector3(-1000, -2, -1010), 0.5f, true, empty);
    takeSurvey();
    EXPECT_TRUE(holds(mSurvey.receivers(), mSurvey, *under));
}

TEST_P(CasterSearchTest, AsksEachOfANodesObjects) {
    addGround();
    Ogre::SceneNode* node = mRootNode->createChildSceneNode();
    const auto place = [&](const Vector3& at) {
        Ogre::ManualObject* object = mManager->createManualObject();
        object->begin(flatMaterial(true)->getName());
        for (const Vector3& corner : {Vector3(-1, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0.5f)})
            object->position(at + corner);
        object->end();
        node->attachObject(object);
        return object;
    };
    Ogre::ManualObject* over = place(Vector3(0, 5, -10));
    Ogre::ManualObject* beside = place(Vector3(80, 5, -10));
    EXPECT_TRUE(finds(*over, mDown));
    EXPECT_FALSE(finds(*beside, mDown));
}

// What the fit is told where there is nothing to draw.

TEST_P(CasterSearchTest, KeepsReasonsApart) {
    EXPECT_EQ(reason(mDown), FitReason::NoReceivers);
    Ogre::Entity* ground = addGround();
    EXPECT_EQ(reason(mDown), FitReason::NothingShadowed);
    Ogre::Entity* beside = addCube(Vector3(4, 4, -10), 0.5f, false);
    EXPECT_EQ(reason(mDown), FitReason::NothingShadowed);
    beside->getParentSceneNode()->setPosition(0, 4, -10);
    EXPECT_EQ(reason(mDown), FitReason::None);
    EXPECT_EQ(reason(mDown, 5), FitReason::NothingShadowed) << "beyond the shadow distance";
    ground->setVisible(false);
    EXPECT_EQ(reason(mDown), FitReason::NoReceivers);
}

TEST_P(CasterSearchTest, CountsEveryCasterWithoutBounds) {
    addGround();
    for (const char* name : {"sky", "clouds"}) {
        Ogre::ManualObject* object = mManager->createManualObject(name);
        object->begin(flatMaterial(false)->getName());
        for (const Vector3& corner : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)})
            object->position(corner);
        object->end();
        object->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
        mRootNode->createChildSceneNode(Vector3(700, 0, 700))->attachObject(object);
    }
    addCube(Vector3(50, 0, -10));
    const BoxSet& casters = find(mDown);
    EXPECT_EQ(casters.unbounded(), 2U);
    EXPECT_TRUE(casters.boxes().empty());
    EXPECT_EQ(mSurvey.unboundedName(), "sky");
}

TEST_P(CasterSearchTest, FindsAllWhereAReceiverHasNoBounds) {
    Ogre::ManualObject* sea = mManager->createManualObject("sea");
    sea->begin(flatMaterial(true)->getName());
    for (const Vector3& corner : {Vector3(0, -5, 0), Vector3(1, -5, 0), Vector3(0, -5, 1)})
        sea->position(corner);
    sea->end();
    sea->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
    sea->setCastShadows(false);
    mRootNode->createChildSceneNode()->attachObject(sea);
    EXPECT_TRUE(finds(*addCube(Vector3(300, 0, -10)), mDown));
}

TEST_P(CasterSearchTest, FindsNothingForLightsWithoutAMap) {
    addGround();
    addCube(Vector3(0, 4, -10));
    addCube(Vector3(0, 6, -10));
    constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
    for (const ShadowLight& light :
         {sunAlong({0, 0, 0}), sunAlong({NaN, 0, 1}),
          ShadowLight{.kind = LightKind::Spot, .wsPosition = Vec3(0, NaN, 0)}})
        EXPECT_TRUE(find(light).empty());
}

TEST_P(CasterSearchTest, FindsForAPointLightWhatIsBetweenItAndTheReceivers) {
    addCube(Vector3(0, -3, -10))->setCastShadows(false);
    const Ogre::Entity* const between = addCube(Vector3(2, 0, -8), 0.5f, false);
    const Ogre::Entity* const above = addCube(Vector3(0, 9, -10), 0.5f, false);
    const Ogre::Entity* const beside = addCube(Vector3(20, 0, -10), 0.5f, false);
    ShadowLight lamp{.kind = LightKind::Point, .wsPosition = Vec3(4, 4, -6)};
    EXPECT_TRUE(finds(*between, lamp));
    EXPECT_FALSE(finds(*above, lamp));
    EXPECT_FALSE(finds(*beside, lamp));
    // A spot of more than half the space is searched for as a point light is.
    lamp.kind = LightKind::Spot;
    lamp.outerHalfAngle = 2.0;
    EXPECT_TRUE(finds(*between, lamp));
    EXPECT_FALSE(finds(*above, lamp));
    // Out of the light's range there are no receivers.
    lamp.range = 3.0;
    EXPECT_FALSE(finds(*beside, lamp));
}

TEST_P(CasterSearchTest, HoldsFarFromTheWorldsOrigin) {
    const Vector3 far(1048576, -1048576, 1048576);
    mCameraNode->setPosition(far);
    addCube(far + Vector3(0, -3, -10))->setCastShadows(false);
    Ogre::Entity* over = addCube(far + Vector3(0, 4, -10), 0.5f, false);
    Ogre::Entity* beside = addCube(far + Vector3(8, 4, -10), 0.5f, false);
    EXPECT_TRUE(finds(*over, mDown));
    EXPECT_FALSE(finds(*beside, mDown));
}

// A ground without thickness, seen and lit at grazing angles: nothing has a volume.
TEST_P(CasterSearchTest, FindsOnAFlatGroundUnderGrazingLight) {
    Ogre::Entity* ground = addGround();
    ground->getParentSceneNode()->setPosition(0, -2, 0);
    ground->getParentSceneNode()->setScale(500, 0, 500);
    Ogre::Entity* cube = addCube(Vector3(0, -1.5f, -10));
    EXPECT_TRUE(finds(*cube, sunAlong({1, -1e-6, 0})));
    EXPECT_TRUE(finds(*cube, sunAlong({1, 0, 0})));
    EXPECT_TRUE(finds(*cube, sunAlong({0, 0, -1})));
}

/// Random nested scenes that change from round to round.
class RandomSceneTest : public CasterSearchTest {
protected:
    RandomSceneTest() {
        // Octants about as large as the cubes, and cubes beyond the octree.
        const Ogre::AxisAlignedBox size(-16, -16, -16, 16, 16, 16);
        mManager->setOption("Size", &size);
    }
    float number(float from, float to) {
        return std::uniform_real_distribution<float>(from, to)(mEngine);
    }
    Vector3 place() {
        const float reach = index(6) == 0 ? 60.0f : 12.0f;
        return {number(-reach, reach), number(-5, 5), number(-reach, reach)};
    }
    int index(std::size_t size) {
        return std::uniform_int_distribution<int>(0, static_cast<int>(size) - 1)(mEngine);
    }
    void addRandomCube() {
        Ogre::SceneNode* parent =
            mCubes.empty() || index(3) != 0
                ? mRootNode
                : mCubes[static_cast<std::size_t>(index(mCubes.size()))]->getParentSceneNode();
        Ogre::Entity* cube = addCube(place(), number(0.2f, 2), index(3) != 0, parent);
        cube->setCastShadows(index(4) != 0);
        mCubes.push_back(cube);
    }
    void change() {
        for (int i = 0; i < 12; ++i) {
            Ogre::Entity* cube = mCubes[static_cast<std::size_t>(index(mCubes.size()))];
            switch (index(5)) {
            case 0:
                cube->setVisible(!cube->getVisible());
                break;
            case 1:
                cube->setCastShadows(!cube->getCastShadows());
                break;
            case 2:
                cube->setMaterial(flatMaterial(index(2) == 0));
                break;
            case 3:
                cube->getParentSceneNode()->setScale(number(-4, 4), number(0.1f, 4), 1);
                break;
            default:
                cube->getParentSceneNode()->setPosition(place());
                break;
            }
        }
        mCameraNode->setPosition(place());
        mCameraNode->setOrientation(
            Ogre::Quaternion(Ogre::Degree(number(0, 360)), Vector3::UNIT_Y));
    }
    ShadowLight light() {
        const Vec3 direction(number(-1, 1), number(-1, 0.2f), number(-1, 1));
        if (index(2) == 0) return sunAlong(direction);
        return {.kind = LightKind::Spot,
                .wsDirection = direction,
                .wsPosition = toDouble(place()) - mSurvey.wsOrigin(),
                .outerHalfAngle = number(0.1f, 1.3f),
                .nearDistance = 0.5,
                .range = index(2) == 0 ? 40.0 : std::numeric_limits<double>::infinity()};
    }
    /// Every drawn object in the scene graph, asked one by one.
    void askAll(Ogre::SceneNode& node, const ConvexVolume& view, BoxSet& casters,
                BoxSet& receivers) {
        for (Ogre::MovableObject* object : node.getAttachedObjects()) {
            const auto* entity = dynamic_cast<Ogre::Entity*>(object);
            if (entity == nullptr || !entity->getVisible()) continue;
            const Aabb box = relativeBox(entity->getWorldBoundingBox(), mSurvey.wsOrigin());
            if (entity->getCastShadows()) casters.add(box);
            if (entity->getSubEntity(0)->getMaterial() == flatMaterial(true) &&
                view.classify(box) != ConvexVolume::Side::Outside)
                receivers.add(box);
        }
        for (Ogre::Node* child : node.getChildren())
            askAll(static_cast<Ogre::SceneNode&>(*child), view, casters, receivers);
    }

    std::mt19937 mEngine{7};
    std::vector<Ogre::Entity*> mCubes;
};

INSTANTIATE_TEST_SUITE_P(SceneManager, RandomSceneTest,
                         testing::Values(DefaultManager, OctreeManager, OtherManager, FlatManager),
                         [](const auto& test) { return test.param; });

void sortBoxes(std::vector<Aabb>& boxes) {
    const auto key = [](const Aabb& box) {
        return std::tuple(box.centre.x(), box.centre.y(), box.centre.z(), box.halfExtents.x());
    };
    std::sort(boxes.begin(), boxes.end(),
              [&](const Aabb& a, const Aabb& b) { return key(a) < key(b); });
}

bool contains(const BoxSet& set, const Aabb& box) {
    return std::ranges::any_of(set.boxes(), [&](const Aabb& other) {
        return other.centre == box.centre && other.halfExtents == box.halfExtents;
    });
}

void expectSame(const BoxSet& found, const BoxSet& expected) {
    std::vector<Aabb> a;
    std::ranges::copy(found.boxes(), std::back_inserter(a));
    std::vector<Aabb> b;
    std::ranges::copy(expected.boxes(), std::back_inserter(b));
    ASSERT_EQ(a.size(), b.size());
    sortBoxes(a);
    sortBoxes(b);
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].centre, b[i].centre);
        EXPECT_EQ(a[i].halfExtents, b[i].halfExtents);
    }
}

// In the octree and the default scene manager, whose bounds of nodes decide, as in the one without.
TEST_P(RandomSceneTest, FitsSayTheSameAsWithAllCasters) {
    for (int i = 0; i < 120; ++i)
        addRandomCube();
    std::size_t maps = 0;
    std::size_t all = 0;
    std::size_t found = 0;
    CasterSearch search;
    for (int round = 0; round < 60; ++round) {
        SCOPED_TRACE(round);
        change();
        const double distance = index(2) == 0 ? 0.0 : static_cast<double>(number(5, 80));
        takeSurvey();
        BoxSet casters;
        BoxSet receivers;
        askAll(*mRootNode, viewVolume(mSurvey.viewer()), casters, receivers);
        expectSame(mSurvey.receivers(), receivers);
        expectSame(allCasters(), casters);
        for (int lamp = 0; lamp < 4; ++lamp) {
            const ShadowLight lit = light();
            const BoxSet& some = search.find(mSurvey, lit, distance);
            const ShadowFit expected = fit(mSurvey, lit, distance, casters);
            const ShadowFit actual = fit(mSurvey, lit, distance, some);
            // Without a receiver in view there is none in shadow: either is said.
            if (expected.reason == FitReason::NoReceivers)
                ASSERT_FALSE(actual.hasMap());
            else
                ASSERT_EQ(actual.reason, expected.reason);
            all += casters.boxes().size();
            found += some.boxes().size();
            // Who is left out would make no map if it were alone in the scene either.
            for (const Aabb& box : casters.boxes()) {
                if (contains(some, box)) continue;
                BoxSet alone;
                alone.add(box);
                EXPECT_FALSE(fit(mSurvey, lit, distance, alone).hasMap());
            }
            if (!expected.hasMap()) continue;
            ++maps;
            EXPECT_TRUE(actual.clipFromWorld.isApprox(expected.clipFromWorld, 1e-6));
            EXPECT_NEAR(actual.lsNear, expected.lsNear, 1e-9 * std::abs(expected.lsNear));
        }
    }
    // The rounds are worth something, and so is the search.
    EXPECT_GT(maps, 100U);
    EXPECT_LT(4 * found, all);
}

} // namespace
} // namespace Lixel::Tests
