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

    /** Builds the scene, in an empty stage, with additive texture shadows and Lixel's caster and
        receiver.

        A scene of OGRE's shader system has integrated shadows and the presets of its lights.
        @exception std::runtime_error for such a scene, where programs are built without it
    */
    void show(const SampleScene& scene);
    void setView(const SampleView& view);
    void setLight(const SampleLight& light);
    /// @param sunMaps shadow maps that a sun has with it, in a scene of OGRE's shader system; a
    /// point light has six of Lixel's setups there, and one of OGRE's
    void setShadowSetup(const Ogre::ShadowCameraSetupPtr& setup, std::size_t sunMaps = 1);
    /// In a scene of OGRE's shader system, instead of a setup: whichever light is set has its own
    /// preset, as when the scene was shown.
    void usePresets();
    /// The name of the preset in use; empty where there is none.
    std::string preset() const { return mUsesPresets ? mLightPreset : ""; }
    void setShadowMapSize(int texels);

    /// Begins anew, with a scene manager of the same type. Its scene, camera, viewport and light
    /// go, and all meshes.
    void clear();

    /// Draws one frame; where there is a window, shows it.
    void drawFrame();

    /// The window's picture as RGB bytes, row 0 at the top.
    std::vector<std::uint8_t> picture();

    /** Draws a frame that shows, instead of the scene, how much of the light each pixel gets: one
        byte each, row 0 at the top, 255 for lit. Exactly the frame that drawFrame would draw.
        Of lights with several maps, too, where the scene manager has an integrated technique.

        In a scene of OGRE's shader system it follows from three frames: what the light adds to a
        pixel, as a part of what it would add without shadows; 0 where that is nothing.
        @param[out] isLit if not null, where that is enough to be told: not where its material's own
        shading leaves a pixel dark. True everywhere in other scenes. */
    std::vector<std::uint8_t> drawVisibility(std::vector<bool>* isLit = nullptr);

    /// Waits until everything drawn is drawn.
    void finish();
    /// The OpenGL renderer's own name.
    std::string glRenderer();

private:
    void open(const StageOptions& options);
    /// Gives a new scene manager camera, viewport, light and shadows.
    void furnish();
    void openWindow(const StageOptions& options);
    /// For a scene of OGRE's shader system.
    void startShaderSystem();
    /// Gives the light its preset, if they are used, and it and the scene manager as many maps as
    /// it has, in a scene of OGRE's shader system.
    void updateMaps();
    std::vector<std::uint8_t> visibilityOfBrightness(std::vector<bool>* isLit);

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

    SampleSky mSky;
    int mMapSize = 1024;
    /// What setups other than presets have, in a scene of OGRE's shader system.
    std::size_t mSunMaps = 1;
    std::size_t mLampMaps = 1;
    std::string mLightPreset;
    bool mUsesPresets = false;
    /// A ShaderSystemStage while such a scene is shown. It goes before the scene manager and Root.
    std::shared_ptr<void> mShaderSystem;
};

/// The resource group of media/, which is there while a scene of OGRE's shader system is shown.
inline constexpr const char* MediaGroup = "Media";

/// Folder of the running program, where its plugins.cfg and resources.cfg are.
std::string programFolder();

} // namespace Lixel::Samples
