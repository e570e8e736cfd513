// The stage on which samples are shown, and what is borrowed from it.

#include "common/Stage.h"
#include "common/MapCapture.h"

#include <Lixel/headless/Headless.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <Ogre.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace Lixel::Samples {
namespace {

Ogre::uint32 shadowMapWidth(Stage& stage) {
    const auto& maps = stage.sceneManager().getShadowTextureConfigList();
    return maps.size() == 1 ? maps.front().width : 0;
}

TEST(MapCapture, ThatCapturedNothingChangesNoMaps) {
    Stage stage({.headless = true, .width = 32, .height = 32});
    ASSERT_EQ(shadowMapWidth(stage), 1024U);
    { const MapCapture capture(stage); }
    EXPECT_EQ(shadowMapWidth(stage), 1024U);
}

TEST(MapCapture, LeavesOneMapOfTheSizeCapturedLast) {
    Stage stage({.headless = true, .width = 32, .height = 32});
    stage.show(*findSampleScene("duel"));
    {
        MapCapture capture(stage);
        capture.capture(*findEmulatedSetup("Cascades-2"), 256, 100.0, Eigen::Vector3d::Zero());
    }
    EXPECT_EQ(shadowMapWidth(stage), 256U);
}

// The following test is run under Xvfb.

TEST(StageWithDisplay, ThatCannotBeOpenedEndsGlfw) {
    ASSERT_TRUE(Lixel::Headless::isDisplayUsable()) << "run this test under xvfb-run -a";
    EXPECT_THROW(Stage({.headless = false,
                        .width = 32,
                        .height = 32,
                        .title = "Lixel test",
                        .logFile = "",
                        .sceneManagerType = "no such scene manager"}),
                 std::runtime_error);
    glfwGetError(nullptr);
    glfwGetTime();
    EXPECT_EQ(glfwGetError(nullptr), GLFW_NOT_INITIALIZED) << "its window was closed, too";
}

} // namespace
} // namespace Lixel::Samples
