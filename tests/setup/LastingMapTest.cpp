// Maps that last while the viewer moves: what they save, and that they are never too coarse or too
// small.

#include "TestStage.h"

#include <Lixel/scene/OgreMath.h>
#include <Lixel/setup/MapPlan.h>
#include <Lixel/setup/ShadowCameraSetups.h>

#include <random>

namespace Lixel::Tests {
namespace {

/// Counts what is done with maps.
class PlanCounter : public ShadowMapObserver {
public:
    PlanCounter() { addShadowMapObserver(*this); }
    ~PlanCounter() override { removeShadowMapObserver(*this); }
    void shadowMapFitted(const ShadowMap& map) override {
        ++maps;
        drawn += map.decision.plan == MapPlan::Draw ? 1 : 0;
        fit = map.fit;
        wsOrigin = map.wsOrigin;
    }

    int maps = 0;
    int drawn = 0;
    ShadowFit fit;
    Vec3 wsOrigin = Vec3::Zero();
};

class LastingMapTest : public testing::TestWithParam<std::string> {
protected:
    LastingMapTest() {
        // A field all around, so that what is seen bounds the map.
        std::mt19937 engine(5);
        std::uniform_real_distribution<float> place(-45, 45);
        for (int i = 0; i < 150; ++i) {
            const Ogre::Vector3 position(place(engine), 1, place(engine));
            // Not where the tests look.
            if (position.squaredDistance({0, 1, 0}) > 100 &&
                position.squaredDistance({40, 1, 30}) > 100)
                scene.addCube(position, {1, 2, 1});
        }
        setBound(0.2F);
    }
    void setBound(float share) {
        const Ogre::ShadowCameraSetupPtr setup = Samples::findShadowSetup(GetParam())->create();
        dynamic_cast<FittedShadowCameraSetup&>(*setup).setLastingMaps(share);
        scene.stage.setShadowSetup(setup);
    }
    Ogre::SceneNode& viewer() { return *scene.stage.camera().getParentSceneNode(); }

    BoxOnGround scene;
};

INSTANTIATE_TEST_SUITE_P(Techniques, LastingMapTest, testing::Values("Uniform", "XPSM", "Optimal"),
                         [](const auto& test) { return test.param; });

TEST_P(LastingMapTest, ServesManyFramesOfAWalk) {
    // A second of a walk at 1.4 m/s, sideways.
    PlanCounter plans;
    scene.stage.drawFrame();
    for (int frame = 0; frame < 60; ++frame) {
        viewer().translate(1.4F / 60, 0, 0);
        scene.stage.drawFrame();
    }
    EXPECT_EQ(plans.maps, 61);
    EXPECT_LT(plans.drawn, 20);
    EXPECT_GT(plans.drawn, 0);
}

TEST_P(LastingMapTest, IsDrawnOnce) {
    for (int i = 0; i < 10; ++i) {
        // A camera cut, and then hardly a move.
        viewer().translate(i % 2 == 0 ? 30.0F : -30.0F, 0, 0);
        PlanCounter plans;
        for (int frame = 0; frame < 4; ++frame) {
            scene.stage.drawFrame();
            EXPECT_EQ(plans.drawn, 1) << i << ", " << frame;
            viewer().translate(1e-4F, 0, 0);
        }
    }
}

TEST_P(LastingMapTest, ServesSomeFramesOfATurn) {
    scene.stage.drawFrame();
    PlanCounter plans;
    for (int frame = 0; frame < 60; ++frame) {
        viewer().yaw(Ogre::Degree(0.5F), Ogre::Node::TS_WORLD);
        scene.stage.drawFrame();
    }
    EXPECT_LT(plans.drawn, 40);
}

TEST_P(LastingMapTest, HasEveryShadowInEveryFrame) {
    double worst = 0.0;
    double sum = 0.0;
    setBound(0.2F);
    for (int frame = 0; frame < 30; ++frame) {
        viewer().translate(0.05F, 0, -0.08F);
        viewer().yaw(Ogre::Degree(0.4F), Ogre::Node::TS_WORLD);
        const double error = scene.nextFrameError().error;
        worst = std::max(worst, error);
        sum += error;
    }
    setBound(0);
    double fresh = 0.0;
    for (int frame = 0; frame < 30; ++frame) {
        viewer().yaw(Ogre::Degree(-0.4F), Ogre::Node::TS_WORLD);
        viewer().translate(-0.05F, 0, 0.08F);
        fresh += scene.nextFrameError().error;
    }
    // The bound is of texels' sides; errors grow alike.
    EXPECT_LT(sum, 1.35 * fresh) << worst;
}

TEST_P(LastingMapTest, ShadowsStandStillWhileAMapIsKept) {
    scene.stage.drawFrame();
    PlanCounter plans;
    int still = 0;
    for (int frame = 0; frame < 20; ++frame) {
        viewer().translate(0.002F, 0, 0);
        const ShadowFit before = plans.fit;
        const int drawn = plans.drawn;
        scene.stage.drawFrame();
        if (plans.drawn > drawn || frame == 0) continue;
        EXPECT_EQ(plans.fit.clipFromWorld, before.clipFromWorld);
        ++still;
    }
    EXPECT_GT(still, 10);
}

TEST_P(LastingMapTest, KeepsItsTexelsWhileTheViewTurns) {
    // A point of the ground that stays in view.
    constexpr int MapSize = 512;
    const Vec3 point = toDouble(InShadow);
    PlanCounter plans;
    const auto texel = [&] {
        const Vec4 clip = plans.fit.clipFromWorld * (point - plans.wsOrigin).homogeneous();
        return Vec2(clip.head<2>() / clip.w() * (MapSize / 2.0));
    };
    scene.stage.setShadowMapSize(MapSize);
    scene.stage.drawFrame();
    int moved = 0;
    int fittedAnew = 0;
    for (int frame = 0; frame < 40; ++frame) {
        const Vec2 before = texel();
        viewer().yaw(Ogre::Degree(0.5F), Ogre::Node::TS_WORLD);
        scene.stage.drawFrame();
        const Vec2 by = texel() - before;
        if ((by - by.array().round().matrix()).norm() > 1e-3)
            ++fittedAnew;
        else if (by.norm() > 0.5)
            ++moved;
    }
    EXPECT_LE(fittedAnew, 8);
    EXPECT_GT(moved, fittedAnew);
}

TEST_P(LastingMapTest, FollowsWhatMovesInIt) {
    for (int frame = 0; frame < 6; ++frame) {
        viewer().translate(0.001F, 0, 0);
        scene.stage.drawFrame();
    }
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
    scene.box->setVisible(false);
    EXPECT_GT(scene.visibilityAt(InShadow), 128);
    scene.box->setVisible(true);
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
    scene.stage.light().getParentSceneNode()->yaw(Ogre::Degree(180), Ogre::Node::TS_WORLD);
    EXPECT_GT(scene.visibilityAt(InShadow), 128);
    scene.stage.light().getParentSceneNode()->yaw(Ogre::Degree(180), Ogre::Node::TS_WORLD);
    EXPECT_LT(scene.visibilityAt(InShadow), 128);
}

TEST_P(LastingMapTest, IsFittedAnewAfterACut) {
    scene.stage.drawFrame();
    const PlanCounter plans;
    viewer().setPosition(40, 5, 40);
    viewer().lookAt(Ogre::Vector3(40, 0, 20), Ogre::Node::TS_WORLD);
    scene.addCube({40, 1, 30}, {2, 2, 2});
    scene.stage.drawFrame();
    EXPECT_EQ(plans.drawn, 1);
    EXPECT_LT(scene.visibilityAt({38, 0, 30}), 128);
}

TEST(LastingMaps, RefuseWrongBounds) {
    const auto setup = XPSMShadowCameraSetup::create();
    EXPECT_THROW(setup->setLastingMaps(-0.1F), Ogre::InvalidParametersException);
    EXPECT_THROW(setup->setLastingMaps(NaN), Ogre::InvalidParametersException);
    EXPECT_THROW(setup->setParameter("lasting_maps", "2"), Ogre::InvalidParametersException);
    setup->setParameter("lasting_maps", "0.1");
    EXPECT_FLOAT_EQ(setup->getLastingMaps(), 0.1F);
}

} // namespace
} // namespace Lixel::Tests
