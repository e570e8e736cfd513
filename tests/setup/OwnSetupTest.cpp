// A setup of an application's own, from what is installed alone: the README's.

#include "TestStage.h"

#include <Lixel/setup/ShadowCameraSetups.h>
#include <Lixel/setup/ShadowMapObserver.h>

#include <OgreException.h>

#include <gtest/gtest.h>

#include <array>

namespace Lixel::Tests {
namespace {

struct NoonOptions {
    double height = 0.7;
};

constexpr std::array NoonDeclared{
    option<&NoonOptions::height>("height", between(0.0, 1.0), "", "sine of the sun's elevation"),
};

/// For the ground while the sun is high, else for what is seen.
class NoonSetup : public FittedShadowCameraSetup {
public:
    NoonSetup() : FittedShadowCameraSetup("Noon", NoonDeclared, &mOptions) {}

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override {
        const double sine = -problem.light.wsDirection.normalized().y();
        return sine > mOptions.height ? fitMap(problem, PlaneOptimalOptions(), state)
                                      : fitMap(problem, OptimalOptions(), state);
    }

private:
    NoonOptions mOptions;
};

/// The last map's fit.
struct LastFit : ShadowMapObserver {
    LastFit() { addShadowMapObserver(*this); }
    ~LastFit() override { removeShadowMapObserver(*this); }
    void shadowMapFitted(const ShadowMap& map) override { fit = map.fit; }
    ShadowFit fit;
};

ShadowFit fitOf(BoxOnGround& scene, const Ogre::ShadowCameraSetupPtr& setup) {
    scene.stage.light().setCustomShadowCameraSetup(setup);
    LastFit last;
    scene.stage.drawFrame();
    return last.fit;
}

TEST(OwnSetup, PicksATechniqueByTheProblem) {
    BoxOnGround scene;
    const Mat4 optimal = fitOf(scene, OptimalShadowCameraSetup::create()).clipFromWorld;
    const Mat4 plane = fitOf(scene, PlaneOptimalShadowCameraSetup::create()).clipFromWorld;
    ASSERT_NE(optimal, plane);
    const auto evening = std::make_shared<NoonSetup>();
    EXPECT_TRUE(evening->setParameter("height", "1"));
    EXPECT_EQ(fitOf(scene, evening).clipFromWorld, optimal);
    const auto noon = std::make_shared<NoonSetup>();
    EXPECT_TRUE(noon->setParameter("height", "0"));
    EXPECT_EQ(fitOf(scene, noon).clipFromWorld, plane);
}

TEST(OwnSetup, HasOptionsAsTextBesideTheCommonOnes) {
    NoonSetup own;
    EXPECT_EQ(own.getParameter("height"), "0.7");
    EXPECT_TRUE(own.setParameter("filter_radius", "2"));
    EXPECT_EQ(own.getFilterRadius(), 2.0F);
    EXPECT_THROW(own.setParameter("height", "1.5"), Ogre::InvalidParametersException);
    EXPECT_EQ(own.getParameters().size(), 1 + CommonOptions::declared().size());
}

} // namespace
} // namespace Lixel::Tests
