#include "browser/Viewer.h"

#include "common/FileWatch.h"
#include "common/PictureFile.h"
#include "common/PlanCounts.h"

#include <Lixel/reload/Reload.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <map>

namespace Lixel::Samples {
namespace {

/// Turn per pixel of mouse motion: half a window of 800 pixels is 80 degrees.
constexpr float RadiansPerPixel = 0.0035F;
/// Flying crosses the shadow distance, or without one the view, in this many seconds.
constexpr float SecondsAcross = 20.0F;

/// Between two lines about maps in the title.
constexpr std::chrono::milliseconds TitleInterval(500);

/// Between two looks at the files of scripts and shaders.
constexpr std::chrono::milliseconds WatchInterval(250);

/// One window's state; GLFW's callbacks reach it through the window's user pointer.
class Viewer {
public:
    Viewer(Stage& stage, const SampleScene& scene, const BrowserOptions& options)
        : mStage(stage),
          mScene(scene),
          mOptions(options),
          mView(static_cast<std::size_t>(options.view) - 1),
          mPicture(options.output.empty() ? "lixel.png" : options.output) {
        const auto& setups = shadowSetups();
        for (std::size_t i = 0; i < setups.size(); ++i)
            if (setups[i].name == options.setup) mSetup = i;
        mWatches.emplace(Ogre::RGN_DEFAULT, Ogre::RGN_DEFAULT);
        if (scene.shaderSystem) mWatches.emplace(MediaGroup, MediaGroup);
        GLFWwindow* const window = stage.glfwWindow();
        glfwSetWindowUserPointer(window, this);
        glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
            if (action == GLFW_PRESS) of(w).keyPressed(key);
        });
        glfwSetCursorPosCallback(window,
                                 [](GLFWwindow* w, double x, double y) { of(w).mouse(x, y); });
        glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).resized(); });
        showTitle();
    }

    void run() {
        fmt::print("Drag with a mouse button to look, W A S D Q E to fly (Shift: faster), "
                   "1-{} setups{}, V views, F12 picture, Esc ends.\n"
                   "What is edited in Lixel's scripts and shaders shows at once.\n",
                   std::min<std::size_t>(shadowSetups().size(), 9),
                   mScene.shaderSystem ? ", 0 the scene's own" : "");
        std::fflush(stdout);
        auto last = std::chrono::steady_clock::now();
        while (glfwWindowShouldClose(mStage.glfwWindow()) == GLFW_FALSE) {
            glfwPollEvents();
            const auto now = std::chrono::steady_clock::now();
            fly(std::chrono::duration<float>(now - last).count());
            last = now;
            readEdits(now);
            mPlans.clear();
            mStage.drawFrame();
            showPlans(now);
        }
    }

private:
    static Viewer& of(GLFWwindow* window) {
        return *static_cast<Viewer*>(glfwGetWindowUserPointer(window));
    }

    bool held(int key) const { return glfwGetKey(mStage.glfwWindow(), key) == GLFW_PRESS; }

    void keyPressed(int key) {
        const auto& setups = shadowSetups();
        if (key >= GLFW_KEY_1 && key <= GLFW_KEY_9) {
            const std::size_t choice = static_cast<std::size_t>(key - GLFW_KEY_1);
            if (choice < setups.size()) showSetup(choice);
        } else if (key == GLFW_KEY_0 && mScene.shaderSystem) {
            showPresets();
        } else if (key == GLFW_KEY_V) {
            showView((mView + 1) % mScene.views.size());
        } else if (key == GLFW_KEY_F12) {
            takePicture();
        } else if (key == GLFW_KEY_ESCAPE) {
            glfwSetWindowShouldClose(mStage.glfwWindow(), GLFW_TRUE);
        }
    }

    void showSetup(std::size_t choice) {
        const NamedSetup& setup = shadowSetups()[choice];
        mSetup = choice;
        // Options that were asked for belong to the setup that was asked for.
        const bool isAskedFor = setup.name == mOptions.setup;
        mStage.setShadowSetup(isAskedFor ? withOptions(setup, mOptions.assignments).create()
                                         : setup.create(),
                              setup.maps);
        fmt::print("{}: {}\n", setup.name, setup.title);
        std::fflush(stdout);
        showTitle();
    }

    void showPresets() {
        mStage.usePresets();
        fmt::print("{}: the scene's own\n", mStage.preset());
        std::fflush(stdout);
        showTitle();
    }

    void showView(std::size_t choice) {
        const SampleView& view = mScene.views[choice];
        mView = choice;
        mStage.setView(view);
        // A light that was asked for stays, unless it is another view's own.
        mStage.setLight(askedLight(mOptions, mScene, view).value_or(defaultLight(mScene, view)));
        showTitle();
    }

    void takePicture() {
        const int width = static_cast<int>(mStage.window().getWidth());
        const int height = static_cast<int>(mStage.window().getHeight());
        // No exception may pass through GLFW, which is C and called us.
        try {
            savePicture(mStage.picture(), width, height, mPicture);
            fmt::print("picture: {}\n", std::filesystem::absolute(mPicture).string());
            std::fflush(stdout);
        } catch (const std::exception& error) {
            fmt::print(stderr, "lixel-browser: {}\n", error.what());
        }
    }

    bool anyButtonHeld() const {
        for (int button = GLFW_MOUSE_BUTTON_1; button <= GLFW_MOUSE_BUTTON_LAST; ++button)
            if (glfwGetMouseButton(mStage.glfwWindow(), button) == GLFW_PRESS) return true;
        return false;
    }

    void mouse(double x, double y) {
        const float dx = static_cast<float>(x - mMouseX);
        const float dy = static_cast<float>(y - mMouseY);
        mMouseX = x;
        mMouseY = y;
        if (!anyButtonHeld()) return;
        Ogre::SceneNode& node = *mStage.camera().getParentSceneNode();
        node.yaw(Ogre::Radian(-dx * RadiansPerPixel), Ogre::Node::TS_WORLD);
        node.pitch(Ogre::Radian(-dy * RadiansPerPixel), Ogre::Node::TS_LOCAL);
    }

    void fly(float seconds) {
        Ogre::Vector3 move = Ogre::Vector3::ZERO;
        if (held(GLFW_KEY_W)) move.z -= 1;
        if (held(GLFW_KEY_S)) move.z += 1;
        if (held(GLFW_KEY_A)) move.x -= 1;
        if (held(GLFW_KEY_D)) move.x += 1;
        if (held(GLFW_KEY_Q)) move.y -= 1;
        if (held(GLFW_KEY_E)) move.y += 1;
        if (move == Ogre::Vector3::ZERO) return;
        const bool faster = held(GLFW_KEY_LEFT_SHIFT) || held(GLFW_KEY_RIGHT_SHIFT);
        const float across =
            mScene.shadowDistance > 0 ? mScene.shadowDistance : mScene.views[mView].farDistance;
        const float speed = across / SecondsAcross * (faster ? 5.0F : 1.0F);
        mStage.camera().getParentSceneNode()->translate(move.normalisedCopy() * speed * seconds,
                                                        Ogre::Node::TS_LOCAL);
    }

    void resized() {
        mStage.window().windowMovedOrResized();
        const Ogre::Viewport& viewport = mStage.viewport();
        if (viewport.getActualHeight() > 0)
            mStage.camera().setAspectRatio(Ogre::Real(viewport.getActualWidth()) /
                                           Ogre::Real(viewport.getActualHeight()));
    }

    /// Reads scripts and shaders again where their files have changed.
    void readEdits(std::chrono::steady_clock::time_point now) {
        if (now < mNextWatch) return;
        mNextWatch = now + WatchInterval;
        bool changed = false;
        std::vector<std::string> errors;
        for (auto& [group, watch] : mWatches) {
            if (!watch.changed()) continue;
            changed = true;
            std::ranges::move(reload(group), std::back_inserter(errors));
        }
        if (!changed) return;
        mError = errors.empty() ? "" : errors.front();
        for (const std::string& error : errors)
            fmt::print(stderr, "{}\n", error);
        fmt::print("{}\n", errors.empty() ? "scripts and shaders: read again"
                                          : "scripts and shaders: what has errors stays as it was");
        std::fflush(stdout);
        showTitle();
    }

    /// Says in the title what was done with the frame's maps.
    void showPlans(std::chrono::steady_clock::time_point now) {
        if (now < mNextTitle) return;
        mNextTitle = now + TitleInterval;
        std::string text = fmt::format("maps: {} drawn, {} kept, {} empty", mPlans.drawn,
                                       mPlans.reused, mPlans.skipped);
        if (mPlans.moving > 0) text += fmt::format(", {} of them what moves alone", mPlans.moving);
        if (mPlans.postponed > 0) text += fmt::format(", {} of them waiting", mPlans.postponed);
        if (!mPlans.reason.empty()) text += " (" + mPlans.reason + ")";
        if (text == mPlanText) return;
        mPlanText = text;
        showTitle();
    }

    void showTitle() {
        const std::string scene = fmt::format(
            "Lixel - {} - {} - {} - {}", mScene.name, mScene.views[mView].name,
            mStage.preset().empty() ? shadowSetups()[mSetup].title : mStage.preset(), mPlanText);
        glfwSetWindowTitle(mStage.glfwWindow(),
                           mError.empty() ? scene.c_str() : ("Error: " + mError).c_str());
    }

    Stage& mStage;
    const SampleScene& mScene;
    const BrowserOptions& mOptions;
    std::size_t mView;
    std::size_t mSetup = 0;
    std::string mPicture;
    /// By resource groups.
    std::map<std::string, FileWatch> mWatches;
    std::chrono::steady_clock::time_point mNextWatch;
    PlanCounts mPlans;
    std::string mPlanText;
    std::chrono::steady_clock::time_point mNextTitle;
    std::string mError; ///< the first of the last edit
    double mMouseX = 0.0;
    double mMouseY = 0.0;
};

} // namespace

void runViewer(Stage& stage, const SampleScene& scene, const BrowserOptions& options) {
    Viewer(stage, scene, options).run();
}

} // namespace Lixel::Samples
