// What a frame before showed, read back: the points are those that rays meet, no shadow is lost for
// them, and nobody is hurt by their coming and going.

#include "TestStage.h"

#include "common/MapCapture.h"
#include "common/OracleView.h"
#include "common/Scenes.h"

#include <Lixel/manager/LixelSceneManager.h>
#include <Lixel/setup/Detach.h>
#include <Lixel/setup/ShadowCameraSetups.h>
#include <Lixel/setup/VisiblePointFeedback.h>

namespace Lixel::Tests {
namespace {

/// The stage with feedback for its viewer, or another one.
class FeedbackStage : public BoxOnGround {
public:
    explicit FeedbackStage(const std::string& managerType = "", bool isOn = true)
        : BoxOnGround(managerType) {
        useSetup(isOn);
    }

    void useSetup(bool isOn) {
        const auto setup = XPSMShadowCameraSetup::create();
        setup->setFeedback(isOn);
        stage.setShadowSetup(setup);
    }
    void draw(int frames) {
        for (int i = 0; i < frames; ++i)
            stage.drawFrame();
    }
    FeedbackStatistics statistics() { return feedbackStatistics(stage.camera()); }

    void lookFrom(const Ogre::Vector3& position, const Ogre::Vector3& target) {
        stage.camera().getParentSceneNode()->setPosition(position);
        stage.camera().getParentSceneNode()->lookAt(target, Ogre::Node::TS_WORLD);
    }
};

/// How many frames a reading takes at most.
constexpr int FramesUntilReady = 3;

/// The feedback's points against the pixels that rays find there.
void expectTruePoints(FeedbackStage& scene, const Ogre::Camera& camera, int width, int height) {
    const Samples::ShadowOracle oracle(Samples::collectTriangles(scene.stage.sceneManager()));
    const Samples::OracleView view = Samples::oracleView(camera, width, height, 0.0);
    const Samples::VisiblePoints truth = oracle.visiblePoints(view);
    const std::vector<VisiblePoint> points = feedbackPoints(camera);
    const FeedbackStatistics statistics = feedbackStatistics(camera);
    ASSERT_EQ(points.size(), statistics.points);
    ASSERT_GT(points.size(), statistics.columns * statistics.rows * 8 / 10);
    const Mat4 vsFromWs = view.vsFromWs;
    const Mat4 clipFromWs = view.clipFromVs * vsFromWs;
    std::size_t isBox = 0;
    std::size_t isTurned = 0;
    for (const VisiblePoint& point : points) {
        const Vec4 clip = clipFromWs * Vec4(point.ws.x(), point.ws.y(), point.ws.z(), 1.0);
        const double x = (clip.x() / clip.w() + 1.0) / 2.0 * width;
        const double y = (1.0 - clip.y() / clip.w()) / 2.0 * height;
        // A pixel's centre. (Its own depth says how wrong that is: not at all across the view.)
        ASSERT_NEAR(x - std::floor(x), 0.5, 1e-3);
        ASSERT_NEAR(y - std::floor(y), 0.5, 1e-3);
        const auto& there = truth.at(static_cast<int>(x), static_cast<int>(y));
        ASSERT_TRUE(there.has_value());
        // A depth of 24 bits tells z^2 / near / 2^24. It is rounded by half of that when it is
        // stored, and by up to one near 1 in each of four steps: at vertices, and in a + b x + c y.
        // The ground's vertices, 100 away, are floats.
        const double z = clip.w();
        const double near = static_cast<double>(camera.getNearClipDistance());
        const double error = 1.5 * 4.5 * z * z / near / 16777216.0 + 1e-5;
        EXPECT_LT((point.ws - there->position).norm(), error) << point.ws.transpose();
        isBox += point.ws.y() > 0.1 ? 1 : 0;
        isTurned += point.wsNormal.dot(there->normal) < std::cos(0.3) ? 1 : 0;
    }
    EXPECT_GT(isBox, 3U) << "the box is seen too";
    EXPECT_LE(isTurned, points.size() / 100) << "at edges alone";
}

TEST(VisiblePointFeedback, HasThePointsThatRaysMeet) {
    FeedbackStage scene;
    scene.draw(FramesUntilReady);
    EXPECT_EQ(scene.statistics().state, FeedbackState::Used);
    expectTruePoints(scene, scene.stage.camera(), 320, 240);
}

TEST(VisiblePointFeedback, ArrivesWithinThreeFramesAndIsLeftOutRatherThanWaitedFor) {
    FeedbackStage scene;
    EXPECT_EQ(scene.statistics().state, FeedbackState::NotAsked);
    scene.draw(1);
    EXPECT_EQ(scene.statistics().state, FeedbackState::NotReady);
    EXPECT_EQ(scene.statistics().begun, 1U);
    int frames = 1;
    for (; scene.statistics().state != FeedbackState::Used && frames < 10; ++frames)
        scene.draw(1);
    EXPECT_LE(frames, FramesUntilReady);
    for (int i = 0; i < 20; ++i) {
        scene.lookFrom(Ogre::Vector3(0.1F * static_cast<float>(i), 8, 16), Ogre::Vector3::ZERO);
        scene.draw(1);
        const FeedbackStatistics now = scene.statistics();
        ASSERT_EQ(now.state, FeedbackState::Used);
        EXPECT_GE(now.age, 1U);
        EXPECT_LE(now.age, 3U);
        EXPECT_GT(now.known, 0.9);
        EXPECT_EQ(now.leftOut, 0U);
    }
    EXPECT_GT(scene.statistics().arrived, 10U);
}

TEST(VisiblePointFeedback, FollowsItsViewport) {
    FeedbackStage scene;
    scene.draw(FramesUntilReady);
    const FeedbackStatistics whole = scene.statistics();
    // Neither in a corner nor of the window's shape.
    scene.stage.viewport().setDimensions(0.25F, 0.1F, 0.6F, 0.5F);
    scene.draw(FramesUntilReady);
    EXPECT_EQ(scene.statistics().state, FeedbackState::Used);
    const Ogre::Viewport& viewport = scene.stage.viewport();
    expectTruePoints(scene, scene.stage.camera(), viewport.getActualWidth(),
                     viewport.getActualHeight());
    // Hardly a pixel.
    scene.stage.viewport().setDimensions(0.5F, 0.5F, 0.005F, 0.005F);
    scene.draw(FramesUntilReady);
    EXPECT_EQ(scene.statistics().state, FeedbackState::NotSupported);
    scene.stage.viewport().setDimensions(0, 0, 1, 1);
    scene.draw(FramesUntilReady);
    EXPECT_EQ(scene.statistics().columns, whole.columns);
    expectTruePoints(scene, scene.stage.camera(), 320, 240);
}

TEST(VisiblePointFeedback, TakesTheSizeThatIsWanted) {
    FeedbackStage scene;
    scene.draw(FramesUntilReady);
    const FeedbackStatistics before = scene.statistics();
    setFeedbackSize(20, 9);
    scene.draw(FramesUntilReady);
    const FeedbackStatistics after = scene.statistics();
    EXPECT_NEAR(static_cast<double>(after.columns), 20.0, 3.0);
    EXPECT_NEAR(static_cast<double>(after.rows), 9.0, 2.0);
    EXPECT_LT(after.points, before.points);
    EXPECT_THROW(setFeedbackSize(7, 9), Ogre::InvalidParametersException);
    EXPECT_THROW(setFeedbackSize(20, 513), Ogre::InvalidParametersException);
    setFeedbackSize(60, 27);
}

/// A texture that another viewer sees the scene in.
class TextureView {
public:
    TextureView(FeedbackStage& scene, Ogre::uint samples, bool hasDepth = true)
        : mManager(scene.stage.sceneManager()) {
        mCamera = mManager.createCamera("texture");
        mManager.getRootSceneNode()->createChildSceneNode()->attachObject(mCamera);
        mCamera->getParentSceneNode()->setPosition(5, 7, 14);
        mCamera->getParentSceneNode()->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
        mCamera->setNearClipDistance(0.1F);
        mCamera->setFarClipDistance(1000);
        mTexture = Ogre::TextureManager::getSingleton().createManual(
            "FeedbackView", "General", Ogre::TEX_TYPE_2D, 300, 200, 0, Ogre::PF_BYTE_RGBA,
            Ogre::TU_RENDERTARGET, nullptr, false, samples);
        target().setDepthBufferPool(hasDepth ? 1 : 0); // which have other names in 14
        target().addViewport(mCamera);
    }
    ~TextureView() {
        target().removeAllViewports();
        mManager.destroyCamera(mCamera);
        Ogre::TextureManager::getSingleton().remove(mTexture);
    }
    TextureView(const TextureView&) = delete;
    TextureView& operator=(const TextureView&) = delete;

    Ogre::RenderTarget& target() { return *mTexture->getBuffer()->getRenderTarget(); }
    Ogre::Camera& camera() { return *mCamera; }

private:
    Ogre::SceneManager& mManager;
    Ogre::Camera* mCamera = nullptr;
    Ogre::TexturePtr mTexture;
};

TEST(VisiblePointFeedback, ReadsTexturesOfOtherViewersToo) {
    FeedbackStage scene;
    TextureView other(scene, 0);
    scene.draw(FramesUntilReady);
    expectTruePoints(scene, other.camera(), 300, 200);
    expectTruePoints(scene, scene.stage.camera(), 320, 240);
}

TEST(VisiblePointFeedback, ReadsTheFirstOfAViewersViewports) {
    FeedbackStage scene;
    TextureView other(scene, 0);
    // The texture is drawn first, and its viewport is older.
    other.target().removeAllViewports();
    other.target().addViewport(&scene.stage.camera());
    scene.stage.window().removeAllViewports();
    scene.stage.window().addViewport(&scene.stage.camera());
    scene.draw(FramesUntilReady);
    expectTruePoints(scene, scene.stage.camera(), 300, 200);
    const FeedbackStatistics before = scene.statistics();
    scene.draw(6);
    const FeedbackStatistics after = scene.statistics();
    EXPECT_EQ(after.state, FeedbackState::Used);
    EXPECT_EQ(after.begun, before.begun + 6) << "once a frame";
    EXPECT_EQ(after.columns, before.columns);
    EXPECT_EQ(after.leftOut, 0U);
}

TEST(VisiblePointFeedback, ReadsMultisampledTextures) {
    FeedbackStage scene;
    TextureView other(scene, 4);
    scene.draw(FramesUntilReady);
    const FeedbackStatistics statistics = feedbackStatistics(other.camera());
    EXPECT_EQ(statistics.state, FeedbackState::Used);
    // Of one of a pixel's samples, which is not in its middle.
    EXPECT_GT(statistics.points, statistics.columns * statistics.rows / 2);
    for (const VisiblePoint& point : feedbackPoints(other.camera()))
        EXPECT_TRUE(std::abs(point.ws.y()) < 0.3 || point.ws.lpNorm<Eigen::Infinity>() < 2.1)
            << point.ws.transpose();
}

TEST(VisiblePointFeedback, SaysOnceThatAViewportHasNoDepths) {
    FeedbackStage scene;
    LogCollector log;
    TextureView other(scene, 0, false);
    scene.draw(4);
    EXPECT_EQ(feedbackStatistics(other.camera()).state, FeedbackState::NotSupported);
    EXPECT_EQ(log.count("there is no feedback for camera 'texture'"), 1U) << log.all();
    EXPECT_EQ(scene.statistics().state, FeedbackState::Used);
}

TEST(VisiblePointFeedback, LeavesThePictureAsItIs) {
    // A uniform map has no use for points.
    const auto picture = [](bool isOn) {
        FeedbackStage scene;
        const auto setup = UniformShadowCameraSetup::create();
        setup->setFeedback(isOn);
        scene.stage.setShadowSetup(setup);
        // What is in front of the scene, in a corner of its own, is cut to it.
        TextureView other(scene, 0);
        Ogre::Viewport* const corner =
            scene.stage.window().addViewport(&other.camera(), 1, 0.7F, 0.0F, 0.3F, 0.3F);
        corner->setOverlaysEnabled(false);
        scene.draw(5);
        const std::vector<std::uint8_t> result = scene.stage.picture();
        scene.stage.window().removeViewport(1);
        return result;
    };
    EXPECT_EQ(picture(true), picture(false));
}

TEST(VisiblePointFeedback, AfterACameraCutIsTheFitWithout) {
    std::array<Mat4, 2> fits;
    for (const bool isOn : {false, true}) {
        FeedbackStage scene("", true);
        scene.draw(FramesUntilReady);
        // Neither setup knows a frame before.
        scene.useSetup(isOn);
        scene.lookFrom(Ogre::Vector3(0, 8, 16), Ogre::Vector3(0, 0, 60));
        scene.addCube(Ogre::Vector3(0, 1, 40), Ogre::Vector3(2, 2, 2));
        LastMap published;
        scene.draw(1);
        if (isOn) {
            EXPECT_EQ(scene.statistics().state, FeedbackState::CameraCut);
        }
        ASSERT_TRUE(published.fit.hasMap());
        fits[isOn ? 1 : 0] = published.fit.clipFromWorld;
    }
    EXPECT_EQ(fits[0], fits[1]);
}

/// Walks and turns through samples, as fast as a man and as nobody, and cuts.
TEST(VisiblePointFeedback, LosesNoShadow) {
    for (const char* const name : {"street", "miners-lamp", "field"}) {
        const Samples::SampleScene& scene = *Samples::findSampleScene(name);
        Samples::Stage stage({.headless = true, .width = 160, .height = 120});
        stage.show(scene);
        const Samples::ShadowOracle oracle(Samples::collectTriangles(stage.sceneManager()));
        Samples::MapEmulation emulation(oracle, Samples::CasterFaces::Backs);
        Samples::MapCapture capture(stage);
        const Eigen::Vector3d& origin = oracle.scene().wsOrigin;
        const auto reach = static_cast<double>(scene.shadowDistance);
        for (const char* const setup : {"XPSM", "Optimal", "Cascades-2"}) {
            capture.begin(Samples::withOptions(*Samples::findEmulatedSetup(setup), {"feedback=on"}),
                          256, reach, origin);
            std::size_t shadowed = 0;
            std::size_t used = 0;
            for (int frame = 0; frame < 24; ++frame) {
                Samples::SampleView view =
                    scene.views[static_cast<std::size_t>(frame / 8) % scene.views.size()];
                const Ogre::Vector3 ahead = view.target - view.position;
                const float turn = frame % 8 < 4 ? 0.5F : 20.0F;
                view.position += 0.02F * static_cast<float>(frame) * ahead.normalisedCopy();
                view.target = view.position +
                              Ogre::Quaternion(Ogre::Degree(turn * static_cast<float>(frame % 8)),
                                               Ogre::Vector3::UNIT_Y) *
                                  ahead;
                stage.setView(view);
                const Samples::CapturedFrame maps =
                    capture.nextFrame(Samples::MapCapture::Draws::Everything);
                emulation.setView(Samples::oracleView(stage.camera(), 160, 120, reach, origin));
                emulation.setLight(Samples::oracleLight(stage.light(), origin));
                EXPECT_EQ(emulation.shadowedOutside(maps.maps), 0U)
                    << name << ", " << setup << ", frame " << frame;
                shadowed += static_cast<std::size_t>(
                    std::ranges::count(emulation.truth().pixels, Samples::PixelClass::Shadowed));
                used += feedbackStatistics(stage.camera()).state == FeedbackState::Used ? 1 : 0;
            }
            EXPECT_GT(shadowed, 1000U) << name;
            EXPECT_GT(used, 12U) << name;
        }
    }
}

TEST(VisiblePointFeedback, EndsWithItsCamera) {
    FeedbackStage scene;
    for (int i = 0; i < 4; ++i) {
        TextureView other(scene, 0);
        // Once while readings are under way.
        scene.draw(i == 0 ? 1 : FramesUntilReady);
        EXPECT_EQ(feedbackStatistics(other.camera()).state,
                  i == 0 ? FeedbackState::NotReady : FeedbackState::Used);
    }
    scene.draw(FramesUntilReady);
    EXPECT_EQ(scene.statistics().state, FeedbackState::Used);
}

TEST(VisiblePointFeedback, OutlivesSetupsAndScenes) {
    const auto setup = XPSMShadowCameraSetup::create();
    setup->setFeedback(true);
    for (int i = 0; i < 3; ++i) { // each with a Root of its own
        FeedbackStage scene;
        scene.stage.setShadowSetup(setup);
        scene.draw(FramesUntilReady);
        EXPECT_EQ(scene.statistics().state, FeedbackState::Used);
        scene.useSetup(false); // drops its own
        scene.draw(2);
        EXPECT_EQ(scene.statistics().state, FeedbackState::NotAsked);
        const std::uint64_t begun = scene.statistics().begun;
        scene.draw(2);
        EXPECT_EQ(scene.statistics().begun, begun) << "nobody asks, and nothing is read";
        scene.stage.setShadowSetup(setup);
        scene.draw(FramesUntilReady);
        EXPECT_EQ(scene.statistics().state, FeedbackState::Used);
        if (i == 1) scene.stage.clear(); // another scene manager
        if (i == 2) detachFromOgre();
        scene.draw(2);
    }
}

/// How often a viewer's frames were read until there was no need any more.
std::uint64_t readingsUntilRest(FeedbackStage& scene) {
    constexpr int FramesToRest = 24;
    for (int i = 0; i < FramesToRest; ++i) {
        const std::uint64_t begun = scene.statistics().begun;
        scene.draw(2);
        if (scene.statistics().begun == begun) return begun;
    }
    ADD_FAILURE() << "it is read still";
    return 0;
}

TEST(VisiblePointFeedback, RestsWhereAllStandsStill) {
    FeedbackStage scene("LixelSceneManager");
    static_cast<LixelSceneManager&>(scene.stage.sceneManager()).setChangesAnnounced(true);
    const std::uint64_t begun = readingsUntilRest(scene);
    EXPECT_GE(begun, 3U);
    scene.draw(4);
    EXPECT_EQ(scene.statistics().begun, begun);
    scene.box->translate(1, 0, 0);
    scene.draw(1);
    EXPECT_EQ(scene.statistics().begun, begun + 1);
    EXPECT_GT(readingsUntilRest(scene), begun + 1) << "what it shows of the box is news";
}

TEST(VisiblePointFeedback, IsAnOptionAsText) {
    const auto setup = XPSMShadowCameraSetup::create();
    EXPECT_EQ(setup->getParameter("feedback"), "false");
    EXPECT_TRUE(setup->setParameter("feedback", "on"));
    EXPECT_TRUE(setup->getFeedback());
    EXPECT_STREQ(toString(FeedbackState::CameraCut), "camera cut");
}

} // namespace
} // namespace Lixel::Tests
