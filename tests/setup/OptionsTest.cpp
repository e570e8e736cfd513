// Wrong calls name their argument.

#include "TestStage.h"

#include <Lixel/setup/CascadesShadowCameraSetup.h>
#include <Lixel/setup/LiSPSMShadowCameraSetup.h>
#include <Lixel/setup/ObservedShadowCameraSetup.h>
#include <Lixel/setup/OptimalShadowCameraSetup.h>
#include <Lixel/setup/PSMShadowCameraSetup.h>
#include <Lixel/setup/PlaneOptimalShadowCameraSetup.h>
#include <Lixel/setup/PostProjectiveCubeShadowCameraSetup.h>
#include <Lixel/setup/TrapezoidalShadowCameraSetup.h>
#include <Lixel/setup/UniformShadowCameraSetup.h>
#include <Lixel/setup/XPSMShadowCameraSetup.h>

#include <OgreException.h>
#include <OgreMovablePlane.h>
#include <OgreShadowCameraSetupPSSM.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace Lixel::Tests {
namespace {

template <typename Call>
std::string refusal(Call call) {
    try {
        call();
    } catch (const Ogre::InvalidParametersException& exception) {
        return exception.getDescription();
    }
    return "accepted";
}

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr float Infinity = std::numeric_limits<float>::infinity();

TEST(Options, FilterRadius) {
    UniformShadowCameraSetup setup;
    EXPECT_EQ(setup.getFilterRadius(), 1.0F);
    setup.setFilterRadius(3);
    EXPECT_EQ(setup.getFilterRadius(), 3.0F);
    for (const float wrong : {-1.0F, 65.0F, NaN, Infinity})
        EXPECT_NE(refusal([&] { setup.setFilterRadius(wrong); }).find("texels"), std::string::npos);
    EXPECT_EQ(setup.getFilterRadius(), 3.0F);
}

TEST(Options, DepthBias) {
    XPSMShadowCameraSetup setup;
    EXPECT_EQ(setup.getDepthBias(), 0.0F);
    setup.setDepthBias(0.25F);
    EXPECT_EQ(setup.getDepthBias(), 0.25F);
    for (const float wrong : {-0.1F, NaN, Infinity})
        EXPECT_NE(refusal([&] { setup.setDepthBias(wrong); }).find("worldUnits"),
                  std::string::npos);
}

TEST(Options, MeshHulls) {
    UniformShadowCameraSetup setup;
    EXPECT_TRUE(setup.getMeshHulls());
    setup.setMeshHulls(false);
    EXPECT_FALSE(setup.getMeshHulls());
}

TEST(Options, VisiblePoints) {
    OptimalShadowCameraSetup setup;
    EXPECT_TRUE(setup.getVisiblePoints().empty());
    setup.setVisiblePoints({{Vec3(1.0, 2.0, 3.0), Vec3(0.0, 5.0, 0.0)}});
    ASSERT_EQ(setup.getVisiblePoints().size(), 1U);
    EXPECT_EQ(setup.getVisiblePoints()[0].wsNormal, Vec3::UnitY());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const VisiblePoint& wrong : {VisiblePoint{Vec3(nan, 0.0, 0.0), Vec3::UnitY()},
                                      VisiblePoint{Vec3::Zero(), Vec3::Zero()},
                                      VisiblePoint{Vec3::Zero(), Vec3(0.0, nan, 0.0)}})
        EXPECT_NE(refusal([&] { setup.setVisiblePoints({wrong}); }).find("wsPoints"),
                  std::string::npos);
    EXPECT_EQ(setup.getVisiblePoints().size(), 1U);
}

TEST(Options, Xpsm) {
    XPSMShadowCameraSetup setup;
    setup.setStrength(0);
    setup.setEpsilonW(1);
    setup.setGuarded(false);
    EXPECT_EQ(setup.getStrength(), 0.0F);
    EXPECT_EQ(setup.getEpsilonW(), 1.0F);
    EXPECT_FALSE(setup.getGuarded());
    for (const float wrong : {-1.0F, NaN, Infinity})
        EXPECT_NE(refusal([&] { setup.setStrength(wrong); }).find("strength"), std::string::npos);
    for (const float wrong : {-1.0F, 0.0F, 1.5F, NaN})
        EXPECT_NE(refusal([&] { setup.setEpsilonW(wrong); }).find("epsilonW"), std::string::npos);
}

TEST(Options, Optimal) {
    OptimalShadowCameraSetup setup;
    setup.setSamples(1);
    setup.setEvaluations(4096);
    EXPECT_EQ(setup.getSamples(), 1);
    EXPECT_EQ(setup.getEvaluations(), 4096);
    for (const int wrong : {-1, 0, 4097})
        EXPECT_NE(refusal([&] { setup.setSamples(wrong); }).find("samples"), std::string::npos);
    for (const int wrong : {-1, 0, 7, 4097})
        EXPECT_NE(refusal([&] { setup.setEvaluations(wrong); }).find("evaluations"),
                  std::string::npos);
}

TEST(Options, LiSPSM) {
    LiSPSMShadowCameraSetup setup;
    EXPECT_EQ(setup.getDistanceFactor(), 1.0F);
    setup.setDistanceFactor(0.5F);
    EXPECT_EQ(setup.getDistanceFactor(), 0.5F);
    for (const float wrong : {-1.0F, 0.0F, NaN, Infinity})
        EXPECT_NE(refusal([&] { setup.setDistanceFactor(wrong); }).find("factor"),
                  std::string::npos);
    EXPECT_EQ(setup.getDistanceFactor(), 0.5F);
}

TEST(Options, Trapezoidal) {
    TrapezoidalShadowCameraSetup setup;
    EXPECT_EQ(setup.getFocusDistance(), 0.25F);
    EXPECT_EQ(setup.getFocusShare(), 0.8F);
    setup.setFocusDistance(0.1F);
    setup.setFocusShare(0.5F);
    EXPECT_EQ(setup.getFocusDistance(), 0.1F);
    EXPECT_EQ(setup.getFocusShare(), 0.5F);
    for (const float wrong : {-1.0F, 0.0F, 1.0F, NaN, Infinity}) {
        EXPECT_NE(refusal([&] { setup.setFocusDistance(wrong); }).find("fraction"),
                  std::string::npos);
        EXPECT_NE(refusal([&] { setup.setFocusShare(wrong); }).find("share"), std::string::npos);
    }
}

TEST(Options, Psm) {
    PSMShadowCameraSetup setup;
    EXPECT_EQ(setup.getSlideBack(), 0.25F);
    setup.setSlideBack(0);
    EXPECT_EQ(setup.getSlideBack(), 0.0F);
    for (const float wrong : {-1.0F, NaN, Infinity})
        EXPECT_NE(refusal([&] { setup.setSlideBack(wrong); }).find("slideBack"), std::string::npos);
}

TEST(Options, PlaneOptimal) {
    PlaneOptimalShadowCameraSetup setup;
    EXPECT_FALSE(setup.getExact());
    setup.setExact(true);
    EXPECT_TRUE(setup.getExact());
    EXPECT_EQ(setup.getPlane(), Ogre::Plane(Ogre::Vector3::UNIT_Y, 0));
    const Ogre::Plane table(Ogre::Vector3::UNIT_Z, 3);
    setup.setPlane(table);
    EXPECT_EQ(setup.getPlane(), table);
    for (const Ogre::Vector3& wrong :
         {Ogre::Vector3::ZERO, Ogre::Vector3(NaN, 0, 0), Ogre::Vector3(Infinity, 0, 0)}) {
        Ogre::Plane plane = table;
        plane.normal = wrong;
        EXPECT_NE(refusal([&] { setup.setPlane(plane); }).find("plane"), std::string::npos);
    }
    Ogre::Plane endless = table;
    endless.d = Infinity;
    EXPECT_NE(refusal([&] { setup.setPlane(endless); }).find("plane"), std::string::npos);
    EXPECT_NE(refusal([&] {
                  setup.setPlane(static_cast<const Ogre::MovablePlane*>(nullptr));
              }).find("plane"),
              std::string::npos);
    EXPECT_EQ(setup.getPlane(), table);
    const Ogre::MovablePlane floor(Ogre::Vector3::UNIT_X, 2);
    setup.setPlane(&floor);
    EXPECT_EQ(setup.getPlane(), static_cast<const Ogre::Plane&>(floor));
}

TEST(Options, Stable) {
    UniformShadowCameraSetup setup;
    EXPECT_FALSE(setup.getStable());
    setup.setStable(true);
    EXPECT_TRUE(setup.getStable());
}

TEST(Options, PostProjectiveCube) {
    PostProjectiveCubeShadowCameraSetup setup;
    EXPECT_EQ(setup.getSlideBack(), 0.25F);
    setup.setSlideBack(1);
    EXPECT_EQ(setup.getSlideBack(), 1.0F);
    for (const float wrong : {-1.0F, NaN, Infinity})
        EXPECT_NE(refusal([&] { setup.setSlideBack(wrong); }).find("slideBack"), std::string::npos);
}

/// OGRE's has the ends of all slices in it, and its near plane first.
TEST(Options, CascadesTakeAllSplitPointsOfOgresPssm) {
    struct Ends : ShadowMapObserver {
        Ends() { addShadowMapObserver(*this); }
        void shadowMapFitted(const ShadowMap& map) override {
            vsEnds.resize(std::max(vsEnds.size(), map.iteration + 1));
            vsEnds[map.iteration] = map.part.vsEnd;
        }
        std::vector<double> vsEnds;
    };
    BoxOnGround scene;
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    manager.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    manager.setShadowTextureReceiverMaterial(Ogre::MaterialPtr());
    manager.setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, 3);
    manager.setShadowTextureCount(3);
    for (const float near : {0.1F, 0.003F}) {
        scene.stage.camera().setNearClipDistance(near);
        Ogre::PSSMShadowCameraSetup pssm;
        pssm.calculateSplitPoints(3, near, 80);
        const Ogre::PSSMShadowCameraSetup::SplitPointList& points = pssm.getSplitPoints();
        ASSERT_EQ(points.size(), 4U);
        const auto setup = CascadesShadowCameraSetup::create(UniformShadowCameraSetup::create());
        setup->setSplitDepths(points);
        scene.stage.light().setCustomShadowCameraSetup(setup);
        Ends ends;
        scene.stage.drawFrame();
        ASSERT_EQ(ends.vsEnds.size(), 3U);
        EXPECT_NEAR(ends.vsEnds[0], static_cast<double>(points[1]), 1e-4);
        EXPECT_NEAR(ends.vsEnds[1], static_cast<double>(points[2]), 1e-4);
    }
}

TEST(Options, Cascades) {
    CascadesShadowCameraSetup setup(UniformShadowCameraSetup::create());
    EXPECT_EQ(setup.getUniformity(), 0.0F);
    EXPECT_TRUE(setup.getFollowReceivers());
    EXPECT_TRUE(setup.getSplitDepths().empty());
    setup.setUniformity(0.5F);
    setup.setFollowReceivers(false);
    setup.setSplitDepths({3, 20});
    EXPECT_EQ(setup.getSplitPadding(), 0.0F);
    setup.setSplitPadding(2);
    EXPECT_EQ(setup.getSplitPadding(), 2.0F);
    for (const float wrong : {-1.0F, NaN, Infinity})
        EXPECT_NE(refusal([&] { setup.setSplitPadding(wrong); }).find("worldUnits"),
                  std::string::npos);
    EXPECT_EQ(setup.getSplitPadding(), 2.0F);
    EXPECT_EQ(setup.getUniformity(), 0.5F);
    EXPECT_FALSE(setup.getFollowReceivers());
    EXPECT_EQ(setup.getSplitDepths(), std::vector<Ogre::Real>({3, 20}));
    for (const float wrong : {-0.1F, 1.1F, NaN})
        EXPECT_NE(refusal([&] { setup.setUniformity(wrong); }).find("uniformity"),
                  std::string::npos);
    for (const std::vector<Ogre::Real>& wrong :
         std::vector<std::vector<Ogre::Real>>{{0}, {-1, 2}, {5, 3}, {2, 2}, {NaN}, {1, Infinity}})
        EXPECT_NE(refusal([&] { setup.setSplitDepths(wrong); }).find("depths"), std::string::npos);
    EXPECT_EQ(setup.getSplitDepths(), std::vector<Ogre::Real>({3, 20}));
    for (const Ogre::ShadowCameraSetupPtr& wrong :
         {Ogre::ShadowCameraSetupPtr(), Ogre::DefaultShadowCameraSetup::create(),
          Ogre::ShadowCameraSetupPtr(CascadesShadowCameraSetup::create())})
        EXPECT_NE(refusal([&] { CascadesShadowCameraSetup::create(wrong); }).find("technique"),
                  std::string::npos);
}

TEST(Options, NothingToObserve) {
    EXPECT_NE(refusal([] { ObservedShadowCameraSetup::create({}); }).find("inner"),
              std::string::npos);
}

} // namespace
} // namespace Lixel::Tests
