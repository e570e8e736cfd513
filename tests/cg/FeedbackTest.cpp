// The option feedback as a script says it, on each of OGRE's OpenGL render systems.
#include "DrawingOgre.h"
#include "FreshOgre.h"

#include <Lixel/setup/VisiblePointFeedback.h>

#include <OgreScriptCompiler.h>

#include <gtest/gtest.h>

namespace Lixel::Tests {
namespace {

class FeedbackByScript : public testing::TestWithParam<RenderPath> {};

TEST_P(FeedbackByScript, HasThePointsOfTheCubeThatIsDrawn) {
    FreshOgre::Options options;
    options.renderSystem = GetParam().plugin;
    options.separateShaders = GetParam().separateShaders;
    FreshOgre ogre(options);
    ogre.readScripts();
    std::string script = "import * from \"Lixel.shadow\"\n"
                         "shadow_camera_setup My/Seen : Lixel/Small\n{\n    feedback on\n}\n";
    Ogre::DataStreamPtr stream =
        std::make_shared<Ogre::MemoryDataStream>("seen.shadow", script.data(), script.size());
    Ogre::ScriptCompilerManager::getSingleton().parseScript(stream, Ogre::RGN_DEFAULT);
    ogre.drawCube("My/Seen", "Lixel/Surface/Integrated");
    for (int i = 0; i < 2; ++i)
        ogre.root().renderOneFrame();

    Ogre::SceneManager& manager = *ogre.root().getSceneManagers().begin()->second;
    const Ogre::Camera& camera = *manager.getCamera("");
    EXPECT_EQ(feedbackStatistics(camera).state, FeedbackState::Used)
        << toString(feedbackStatistics(camera).state);
    // OGRE's cube has sides of 100, and its front is 250 ahead. A depth of 24 bits tells 0.004
    // there.
    const std::vector<VisiblePoint> points = feedbackPoints(camera);
    EXPECT_GT(points.size(), 20U);
    for (const VisiblePoint& point : points) {
        EXPECT_NEAR(point.ws.z(), 50.0, 0.02);
        EXPECT_LT(point.ws.head<2>().cwiseAbs().maxCoeff(), 50.0);
        EXPECT_GT(point.wsNormal.z(), 0.99);
    }
}

INSTANTIATE_TEST_SUITE_P(RenderSystems, FeedbackByScript,
                         testing::Values(GL3Plus, GL3PlusSeparate, LegacyGL),
                         [](const auto& path) { return std::string(path.param.name); });

} // namespace
} // namespace Lixel::Tests
