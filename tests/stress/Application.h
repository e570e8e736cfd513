#pragma once

#include "SetupRecipe.h"

#include "common/Stage.h"

#include <Lixel/setup/ShadowMapObserver.h>

#include <Ogre.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Lixel::Tests {

/// A setup in use, and how to make another one like it.
struct UsedSetup {
    Ogre::ShadowCameraSetupPtr setup;
    /// Shared by all who share the setup, since its options may be changed.
    std::shared_ptr<SetupRecipe> recipe;
};

/// A light that has a colour channel of the picture for itself: 0 red, 1 green, 2 blue.
struct Lamp {
    Ogre::Light* light;
    std::size_t channel;
    UsedSetup own;
};

/// One scene manager and what an application knows of it.
struct World {
    static constexpr std::size_t MostLamps = 3;

    Ogre::SceneManager* manager;
    std::vector<Ogre::Entity*> bodies;
    std::vector<Lamp> lamps;
    std::vector<Ogre::Camera*> cameras;
    UsedSetup sceneSetup;
    Ogre::ShadowTechnique technique = Ogre::SHADOWTYPE_NONE;
    /// Whether Lixel's materials can read the shadow textures.
    bool readableFormat = true;
};

/// A render target with one camera or several, side by side.
struct Screen {
    Ogre::RenderTarget* target;
    Ogre::TexturePtr texture; ///< null for the window
};

/// What was told of one light's maps for one viewer, this frame.
struct ToldMaps {
    std::size_t maps = 0;
    std::size_t drawn = 0;
    FitReason last = FitReason::None;
};

/** An application on OGRE and Lixel whose every part can be created, changed and destroyed.

    Everything stands within some ten units of the origin, on a ground that casts nothing.
*/
class Application : private ShadowMapObserver, private Ogre::FrameListener {
public:
    Application();
    ~Application() override;

    Samples::Stage& stage() { return *mStage; }
    Ogre::Root& root() { return mStage->root(); }

    std::vector<std::unique_ptr<World>> worlds;
    /// The window first.
    std::vector<Screen> screens;
    /// Setups that were made and may be shared; some are in use nowhere.
    std::vector<UsedSetup> setups;
    bool pluginLoaded = true;

    /// A name that no other thing has.
    std::string newName(const std::string& what) { return what + std::to_string(mNames++); }

    World& addWorld(const std::string& type);
    void removeWorld(std::size_t index);
    Ogre::Entity& addBody(World& world, const std::string& mesh);
    /// Null where the world has as many lamps as there are channels.
    Lamp* addLamp(World& world, const std::string& name);
    Ogre::Camera& addCamera(World& world);
    void removeCamera(World& world, Ogre::Camera* camera);
    void addTexture();
    void removeTexture(std::size_t index);
    /// Shows cameras side by side on a screen.
    void show(Screen& screen, const std::vector<Ogre::Camera*>& cameras);
    void setTechnique(World& world, Ogre::ShadowTechnique technique);
    void setUp(Lamp& lamp, const UsedSetup& used);
    void setUp(World& world, const UsedSetup& used);
    /// Gives the world's bodies the materials that its technique wants.
    void dress(World& world);
    /// After meshes were reloaded: entities follow only when they are drawn.
    void followMeshes();
    void loadPlugin(bool load);
    /// Ends OGRE and begins again with one world.
    void restart();

    void drawFrame();
    const ToldMaps* told(const Ogre::Camera& viewer, const Ogre::Light& light) const;

    static const std::vector<std::string>& meshes();
    /// What makes a body some two units large: OGRE's own cube has sides of 100.
    static Ogre::Vector3 unitScale(const Ogre::Entity& body);

private:
    /// Without the plugin, OGRE ends on lights without a direction.
    void mendLights();
    void begin();
    void end();
    void shadowMapFitted(const ShadowMap& map) override;

    std::unique_ptr<Samples::Stage> mStage;
    std::map<std::pair<const Ogre::Camera*, const Ogre::Light*>, ToldMaps> mTold;
    std::string mFolder;
    std::size_t mNames = 0;
};

} // namespace Lixel::Tests
