#pragma once

#include "common/Scenes.h"

#include <OgreShadowCameraSetup.h>

#include <memory>

struct GLFWwindow;

namespace Lixel::Samples {

/// How a stage is opened.
struct StageOptions {
    bool headless = true;
    int width = 800;
    int height = 600;
    std::string title = "Lixel";
    /// OGRE's log file; empty for none.
    std::string logFile{};
    /// Scene manager type; empty for OGRE's default one.
    std::string sceneManagerType{};
};

/** OGRE as an application runs it, with one camera and one light, in a window or headless.

    Loads what plugins.cfg and resources.cfg beside the program say, the plugin and its materials
    among it. One stage at a time.
*/
class Stage {
public:
    /// @exception std::runtime_error saying why no window or context can be had
    explicit Stage(const StageOptions& options);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    Ogre::Root& root() { return *mRoot; }
    Ogre::RenderWindow& window() { return *mWindow; }
    Ogre::Viewport& viewport() { return *mViewport; }
    Ogre::SceneManager& sceneManager() { return *mSceneManager; }
    Ogre::Camera& camera() { return *mCamera; }
    Ogre::Light& light() { return *mLight; }
    /// Null when headless.
    GLFWwindow* glfwWindow() { return mGlfwWindow.get(); }

    /// Builds the scene, with additive texture shadows and Lixel's caster and receiver.
    void show(const SampleScene& scene);
    void setView(const SampleView& view);
    void setLight(const SampleLight& light);
    void setShadowSetup(const Ogre::ShadowCameraSetupPtr& setup);
    void setShadowMapSize(int texels);

    /// Begins anew, with a scene manager of the same type. Its scene, camera, viewport and light
    /// go, and all meshes.
    void clear();

    /// Draws one frame; where there is a window, shows it.
    void drawFrame();

    /// The window's picture as RGB bytes, row 0 at the top.
    std::vector<std::uint8_t> picture();

    /** Draws a frame that shows, instead of the scene, how much of the light each pixel gets: one
        byte each, row 0 at the top, 255 for lit. Exactly the frame that drawFrame would draw. */
    std::vector<std::uint8_t> drawVisibility();

    /// Waits until everything drawn is drawn.
    void finish();
    /// The OpenGL renderer's own name.
    std::string glRenderer();

private:
    void open(const StageOptions& options);
    /// Gives a new scene manager camera, viewport, light and shadows.
    void furnish();
    void openWindow(const StageOptions& options);

    /// Ends GLFW, too.
    struct CloseGlfwWindow {
        void operator()(GLFWwindow* window) const;
    };

    // The window outlives what OGRE draws into it, also where the constructor throws.
    std::unique_ptr<GLFWwindow, CloseGlfwWindow> mGlfwWindow;
    std::unique_ptr<Ogre::LogManager> mLogManager;
    std::unique_ptr<Ogre::Root> mRoot;
    Ogre::RenderWindow* mWindow = nullptr;
    Ogre::Viewport* mViewport = nullptr;
    Ogre::SceneManager* mSceneManager = nullptr;
    Ogre::Camera* mCamera = nullptr;
    Ogre::Light* mLight = nullptr;
};

/// Folder of the running program, where its plugins.cfg and resources.cfg are.
std::string programFolder();

} // namespace Lixel::Samples
