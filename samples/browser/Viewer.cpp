#include "browser/Viewer.h"

#include "browser/Report.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace Lixel::Samples {
namespace {

/// Turn per pixel of mouse motion: half a window of 800 pixels is 80 degrees.
constexpr float RadiansPerPixel = 0.0035F;
/// Flying crosses the shadow distance in this many seconds.
constexpr float SecondsAcross = 20.0F;

/// One window's state; GLFW's callbacks reach it through the window's user pointer.
class Viewer {
public:
    Viewer(Stage& stage, const SampleScene& scene, const BrowserOptions& options)
        : mStage(stage),
          mScene(scene),
          mView(static_cast<std::size_t>(options.view) - 1),
          mPicture(options.output.empty() ? "lixel.png" : options.output) {
        const auto& setups = shadowSetups();
        for (std::size_t i = 0; i < setups.size(); ++i)
            if (setups[i].name == options.setup) mSetup = i;
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
                   "1-{} setups, V views, F12 picture, Esc ends.\n",
                   std::min<std::size_t>(shadowSetups().size(), 9));
        std::fflush(stdout);
        auto last = std::chrono::steady_clock::now();
        while (glfwWindowShouldClose(mStage.glfwWindow()) == GLFW_FALSE) {
            glfwPollEvents();
            const auto now = std::chrono::steady_clock::now();
            fly(std::chrono::duration<float>(now - last).count());
            last = now;
            mStage.drawFrame();
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
            if (choice >= setups.size()) return;
            mSetup = choice;
            mStage.setShadowSetup(setups[choice].create());
            fmt::print("{}: {}\n", setups[choice].name, setups[choice].title);
            std::fflush(stdout);
            showTitle();
        } else if (key == GLFW_KEY_V) {
            mView = (mView + 1) % mScene.views.size();
            mStage.setView(mScene.views[mView]);
            if (mScene.views[mView].light) mStage.setLight(*mScene.views[mView].light);
            showTitle();
        } else if (key == GLFW_KEY_F12) {
            const int width = static_cast<int>(mStage.window().getWidth());
            const int height = static_cast<int>(mStage.window().getHeight());
            savePicture(mStage.picture(), width, height, mPicture);
            fmt::print("picture: {}\n", std::filesystem::absolute(mPicture).string());
            std::fflush(stdout);
        } else if (key == GLFW_KEY_ESCAPE) {
            glfwSetWindowShouldClose(mStage.glfwWindow(), GLFW_TRUE);
        }
    }

    void mouse(double x, double y) {
        const float dx = static_cast<float>(x - mMouseX);
        const float dy = static_cast<float>(y - mMouseY);
        mMouseX = x;
        mMouseY = y;
        GLFWwindow* const window = mStage.glfwWindow();
        if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) != GLFW_PRESS &&
            glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_RIGHT) != GLFW_PRESS)
            return;
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
        const float speed =
            mScene.shadowDistance / SecondsAcross * (held(GLFW_KEY_LEFT_SHIFT) ? 5.0F : 1.0F);
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

    void showTitle() {
        glfwSetWindowTitle(mStage.glfwWindow(),
                           fmt::format("Lixel - {} - {} - {}", mScene.name,
                                       mScene.views[mView].name, shadowSetups()[mSetup].title)
                               .c_str());
    }

    Stage& mStage;
    const SampleScene& mScene;
    std::size_t mView;
    std::size_t mSetup = 0;
    std::string mPicture;
    double mMouseX = 0.0;
    double mMouseY = 0.0;
};

} // namespace

void runViewer(Stage& stage, const SampleScene& scene, const BrowserOptions& options) {
    Viewer(stage, scene, options).run();
}

} // namespace Lixel::Samples
