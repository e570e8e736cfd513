// Wrong calls name their argument.

#include "TestStage.h"

#include <Lixel/setup/SetupList.h>
#include <Lixel/setup/ShadowCameraSetups.h>

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

TEST(Options, FilterRadius) {
    UniformShadowCameraSetup setup;
    EXPECT_EQ(setup.getFilterRadius(), 1.0F);
    setup.setFilterRadius(3);
    EXPECT_EQ(setup.getFilterRadius(), 3.0F);
    for (const float wrong : {-1.0F, 65.0F, NaN, Infinity})
        EXPECT_NE(refusal([&] { setup.setFilterRadius(wrong); }).find("filter_radius"),
                  std::string::npos);
    EXPECT_EQ(setup.getFilterRadius(), 3.0F);
}

TEST(Options, DepthBias) {
    XPSMShadowCameraSetup setup;
    EXPECT_EQ(setup.getDepthBias(), 0.0F);
    setup.setDepthBias(0.25F);
    EXPECT_EQ(setup.getDepthBias(), 0.25F);
    for (const float wrong : {-0.1F, NaN, Infinity})
        EXPECT_NE(refusal([&] { setup.setDepthBias(wrong); }).find("depth_bias"),
                  std::string::npos);
}

TEST(Options, MeshHulls) {
    UniformShadowCameraSetup setup;
    EXPECT_TRUE(setup.getMeshHulls());
    setup.setMeshHulls(false);
    EXPECT_FALSE(setup.getMeshHulls());
}

TEST(Options, MeshParts) {
    UniformShadowCameraSetup setup;
    EXPECT_EQ(setup.getMeshParts(), 0);
    setup.setMeshParts(1024);
    EXPECT_EQ(setup.getMeshParts(), 1024);
    for (const int wrong : {-1, 65537})
        EXPECT_NE(refusal([&] { setup.setMeshParts(wrong); }).find("mesh_parts"),
                  std::string::npos);
    EXPECT_EQ(setup.getMeshParts(), 1024);
    EXPECT_EQ(setup.getParameter("mesh_parts"), "1024");
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

    const std::vector<Ogre::Vector3> positions{{1, 2, 3}, {4, 5, 6}};
    setup.setVisiblePoints(positions, {{0, 5, 0}, {2, 0, 0}});
    ASSERT_EQ(setup.getVisiblePoints().size(), 2U);
    EXPECT_EQ(setup.getVisiblePoints()[1].ws, Vec3(4.0, 5.0, 6.0));
    EXPECT_EQ(setup.getVisiblePoints()[1].wsNormal, Vec3::UnitX());
    EXPECT_NE(refusal([&] { setup.setVisiblePoints(positions, {}); }).find("wsNormals"),
              std::string::npos);
}

/// A value that is none of an option's.
std::vector<std::string> wrongValues(const Option& option) {
    std::vector<std::string> wrong{"", "many", "1 2 3 4 5 x", "nan"};
    if (option.type == OptionType::Count || option.type == OptionType::Number) {
        const OptionRange& range = option.range;
        for (const double value : {range.least - 1.0, range.greatest + 1.0})
            wrong.push_back(std::to_string(value));
        if (range.isLeastOpen) wrong.push_back(std::to_string(range.least));
        if (range.isGreatestOpen) wrong.push_back(std::to_string(range.greatest));
        wrong.emplace_back("1 2");
    }
    if (option.type == OptionType::Count) wrong.emplace_back("64.5");
    if (option.type == OptionType::Plane) wrong.insert(wrong.end(), {"0 0 0 1", "0 1 0"});
    if (option.type == OptionType::Ascending)
        wrong.insert(wrong.end(), {"0", "-1 2", "5 3", "2 2", "1 inf"});
    // No numbers at all are right where any number of them is.
    if (option.type == OptionType::Ascending) wrong.erase(wrong.begin());
    return wrong;
}

/// Another right value than the default.
std::string otherValue(const Option& option, const std::string& value) {
    switch (option.type) {
    case OptionType::Flag:
        return value == "true" ? "false" : "true";
    case OptionType::Count:
        return std::to_string(std::stoi(value) + 1);
    case OptionType::Number:
        return option.range.contains(std::stod(value) + 0.125)
                   ? std::to_string(std::stod(value) + 0.125)
                   : "0.5";
    case OptionType::Plane:
        return "0 0 2 -1.5";
    case OptionType::Ascending:
        return "1 2.5 40";
    }
    return {};
}

/// Each kind of setup, by name and as what it is.
class EveryKind : public testing::TestWithParam<SetupKind> {};

INSTANTIATE_TEST_SUITE_P(Options, EveryKind,
                         testing::ValuesIn(setupKinds().begin(), setupKinds().end()),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST_P(EveryKind, TakesAllOfItsOptionsAsText) {
    const auto setup = GetParam().create();
    std::vector<Option> options(GetParam().options.begin(), GetParam().options.end());
    for (const Option& option : CommonOptions::declared())
        options.push_back(option);
    ASSERT_EQ(setup->getParameters().size(), options.size());
    for (const Option& option : options) {
        const std::string keyword(option.keyword);
        const std::string before = setup->getParameter(keyword);
        EXPECT_TRUE(setup->setParameter(keyword, before)) << keyword;
        const std::string other = otherValue(option, before);
        EXPECT_TRUE(setup->setParameter(keyword, other));
        const std::string after = setup->getParameter(keyword);
        EXPECT_NE(after, before) << keyword;
        for (const std::string& wrong : wrongValues(option)) {
            const std::string said = refusal([&] { setup->setParameter(keyword, wrong); });
            EXPECT_EQ(said.find(keyword + ": '" + wrong + "' is not "), 0U) << said;
            EXPECT_NE(said.find(describeValues(option)), std::string::npos) << said;
            EXPECT_EQ(setup->getParameter(keyword), after);
        }
    }
    const std::string said = refusal([&] { setup->setParameter("noSuchOption", "1"); });
    EXPECT_NE(said.find("'noSuchOption' of " + std::string(GetParam().name)), std::string::npos);
    EXPECT_NE(said.find("filter_radius"), std::string::npos) << said;
    EXPECT_EQ(setup->getParameter("noSuchOption"), "");
    // Through OGRE's own class.
    Ogre::StringInterface& plain = *setup;
    EXPECT_TRUE(plain.setParameter("filter_radius", "3"));
    EXPECT_EQ(plain.getParameter("filter_radius"), "3");
    EXPECT_FALSE(plain.setParameter("noSuchOption", "1"));
}

TEST_P(EveryKind, IsFoundByItsName) {
    EXPECT_EQ(findSetupKind(GetParam().name)->title, GetParam().title);
    EXPECT_EQ(findSetupKind("Nobody"), nullptr);
    EXPECT_FALSE(GetParam().paper.empty());
}

TEST(Options, AreTyped) {
    const auto setup = XPSMShadowCameraSetup::create({.strength = 0.5});
    EXPECT_EQ(setup->getOptions().strength, 0.5);
    EXPECT_EQ(setup->getOptions().epsilonW, 0.7);
    EXPECT_EQ(setup->getParameter("strength"), "0.5");
    setup->setParameter("epsilon_w", "1");
    EXPECT_EQ(setup->getOptions().epsilonW, 1.0);
    setup->setOptions({.guarded = false});
    EXPECT_EQ(setup->getParameter("strength"), "2");
    EXPECT_EQ(setup->getParameter("guarded"), "false");
}

TEST(Options, AreCheckedAsAWhole) {
    const auto setup = XPSMShadowCameraSetup::create({.strength = 0.5});
    for (const double wrong : {0.0, -1.0, 1.5, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_NE(refusal([&] {
                      setup->setOptions({.strength = 1.0, .epsilonW = wrong});
                  }).find("epsilon_w"),
                  std::string::npos);
    EXPECT_EQ(setup->getOptions().strength, 0.5);
    EXPECT_NE(refusal([] {
                  OptimalShadowCameraSetup::create({.evaluations = 7});
              }).find("evaluations: '7' is not a whole number, at least 8 and at most 4096"),
              std::string::npos);
}

/// What is made by name can be cast to its class.
TEST(Options, SetupsByNameAreOfTheirClass) {
    EXPECT_NE(std::dynamic_pointer_cast<XPSMShadowCameraSetup>(findSetupKind("XPSM")->create()),
              nullptr);
    EXPECT_NE(std::dynamic_pointer_cast<PlaneOptimalShadowCameraSetup>(
                  findSetupKind("PlaneOptimal")->create()),
              nullptr);
}

TEST(Options, PlaneOptimal) {
    PlaneOptimalShadowCameraSetup setup;
    EXPECT_EQ(setup.getPlane(), Ogre::Plane(Ogre::Vector3::UNIT_Y, 0));
    const Ogre::Plane table(Ogre::Vector3::UNIT_Z, 3); // z = 3
    setup.setPlane(table);
    EXPECT_EQ(setup.getPlane(), table);
    EXPECT_EQ(setup.getParameter("plane"), "0 0 1 -3");
    for (const Ogre::Vector3& wrong :
         {Ogre::Vector3::ZERO, Ogre::Vector3(NaN, 0, 0), Ogre::Vector3(Infinity, 0, 0)}) {
        Ogre::Plane plane = table;
        plane.normal = wrong;
        EXPECT_NE(refusal([&] { setup.setPlane(plane); }).find("plane"), std::string::npos);
    }
    Ogre::Plane endless = table;
    endless.d = Infinity;
    EXPECT_NE(refusal([&] { setup.setPlane(endless); }).find("plane"), std::string::npos);
    EXPECT_EQ(setup.getPlane(), table);
    const Ogre::MovablePlane floor(Ogre::Vector3::UNIT_X, 2);
    setup.setMovablePlane(&floor);
    EXPECT_EQ(setup.getPlane(), static_cast<const Ogre::Plane&>(floor));
    setup.setMovablePlane(nullptr);
    EXPECT_EQ(setup.getPlane(), table);
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

TEST(Options, CascadesInPlaceOfPssm) {
    const BoxOnGround scene; // without Root there is no PSSM
    const auto pssm = std::make_shared<Ogre::PSSMShadowCameraSetup>();
    pssm->setSplitPoints({0.5F, 8, 20, 90});
    pssm->setSplitPadding(3);
    for (const auto& made :
         {CascadesShadowCameraSetup::create(pssm), CascadesShadowCameraSetup::create(pssm.get()),
          CascadesShadowCameraSetup::create(pssm, UniformShadowCameraSetup::create())}) {
        EXPECT_EQ(made->getOptions().vsSplitDepths, std::vector({8.0, 20.0}));
        EXPECT_EQ(made->getOptions().splitPadding, 3.0);
    }
    const auto refusalOf = [](const std::shared_ptr<Ogre::PSSMShadowCameraSetup>& wrong) {
        return refusal([&] { CascadesShadowCameraSetup::create(wrong); });
    };
    EXPECT_NE(refusalOf(nullptr).find("pssm: there is none in a null pointer"), std::string::npos);
#if OGRE_VERSION_MAJOR < 13 // Since 13 nothing can take away the points that it begins with.
    struct Unset : Ogre::PSSMShadowCameraSetup {
        Unset() { mSplitPoints.clear(); }
    };
    EXPECT_NE(refusalOf(std::make_shared<Unset>()).find("pssm: it has no slices yet"),
              std::string::npos);
#endif
    for (const Ogre::PSSMShadowCameraSetup::SplitPointList& wrong :
         std::vector<Ogre::PSSMShadowCameraSetup::SplitPointList>{
             {0, 8, 20}, {9, 8, 20}, {1, 8, 8}, {1, NaN, 20}, {1, 8, Infinity}}) {
        pssm->setSplitPoints(wrong);
        EXPECT_NE(refusalOf(pssm).find("pssm: split_depths"), std::string::npos) << wrong.back();
    }
    pssm->calculateSplitPoints(3, 1, 90);
    for (const float wrong : {NaN, Infinity, -1.0F}) {
        pssm->setSplitPadding(wrong);
        EXPECT_NE(refusalOf(pssm).find("pssm: split_padding"), std::string::npos) << wrong;
    }
    pssm->setSplitPadding(0);
    EXPECT_NE(refusal([&] {
                  CascadesShadowCameraSetup::create(pssm, Ogre::DefaultShadowCameraSetup::create());
              }).find("technique"),
              std::string::npos);
}

TEST(Options, Cascades) {
    CascadesShadowCameraSetup setup(UniformShadowCameraSetup::create());
    setup.setOptions({.uniformity = 0.5, .followReceivers = false});
    setup.setSplitDepths({3, 20});
    EXPECT_EQ(setup.getOptions().vsSplitDepths, std::vector({3.0, 20.0}));
    EXPECT_EQ(setup.getOptions().uniformity, 0.5);
    for (const std::vector<Ogre::Real>& wrong :
         std::vector<std::vector<Ogre::Real>>{{0}, {-1, 2}, {5, 3}, {2, 2}, {NaN}, {1, Infinity}})
        EXPECT_NE(refusal([&] { setup.setSplitDepths(wrong); }).find("split_depths"),
                  std::string::npos);
    EXPECT_EQ(setup.getOptions().vsSplitDepths, std::vector({3.0, 20.0}));
    for (const Ogre::ShadowCameraSetupPtr& wrong :
         {Ogre::ShadowCameraSetupPtr(), Ogre::DefaultShadowCameraSetup::create(),
          Ogre::ShadowCameraSetupPtr(CascadesShadowCameraSetup::create())})
        EXPECT_NE(refusal([&] { CascadesShadowCameraSetup::create(wrong); }).find("technique"),
                  std::string::npos);
    setup.setParameter("split_depths", "1 2");
    setup.setParameter("split_depths", "none");
    EXPECT_TRUE(setup.getOptions().vsSplitDepths.empty());
}

TEST(Options, NothingToObserve) {
    for (const float bias : {NaN, Infinity, -1.0F})
        EXPECT_NE(refusal([&] {
                      ObservedShadowCameraSetup::create(Ogre::DefaultShadowCameraSetup::create(),
                                                        bias);
                  }).find("depthBias"),
                  std::string::npos)
            << bias;
    EXPECT_NE(refusal([] { ObservedShadowCameraSetup::create({}); }).find("inner"),
              std::string::npos);
}

} // namespace
} // namespace Lixel::Tests
