#pragma once

#include <Lixel/headless/Headless.h>
#include <Lixel/script/ShadowCameraSetupManager.h>

#include <Ogre.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace Lixel::Tests {

/// OGRE with a small window and no display, as it is before an application has read any script.
class FreshOgre {
public:
    struct Options {
        bool hasPlugin = true; ///< Plugin_Lixel
        bool separateShaders = false;
        const char* renderSystem = "RenderSystem_GL3Plus";
        /// Of Lixel's programs. Others than glsl need LIXEL_CG_PLUGIN, the path of Plugin_LixelCg.
        std::string language = "glsl";
        Ogre::uint32 side = 64; ///< of the window, in pixels
    };

    FreshOgre() : FreshOgre(Options()) {}
    explicit FreshOgre(const Options& options) : mOptions(options) {
        if (const std::string error = Headless::enable(); !error.empty())
            throw std::runtime_error(error);
        mRoot.loadPlugin(OGRE_PLUGIN_DIR "/" + std::string(options.renderSystem));
        if (options.hasPlugin) mRoot.loadPlugin(LIXEL_PLUGIN_DIR "/Plugin_Lixel.so");
#ifdef LIXEL_CG_PLUGIN
        if (options.language != "glsl") mRoot.loadPlugin(LIXEL_CG_PLUGIN);
#endif
        Ogre::RenderSystem& system = *mRoot.getAvailableRenderers().front();
        mRoot.setRenderSystem(&system);
        if (system.getConfigOptions().count("Separate Shader Objects") != 0)
            system.setConfigOption("Separate Shader Objects",
                                   options.separateShaders ? "Yes" : "No");
        mRoot.initialise(false);
        Ogre::NameValuePairList parameters;
        for (const auto& [name, value] : Headless::windowParameters())
            parameters[name] = value;
        mWindow = mRoot.createRenderWindow("", options.side, options.side, false, &parameters);
    }

    /// Reads Lixel's materials; their programs may be those of another folder.
    void readScripts(const std::string& programs = "") {
        auto& groups = Ogre::ResourceGroupManager::getSingleton();
        groups.addResourceLocation(OGRE_SHADOW_MEDIA, "FileSystem", Ogre::RGN_INTERNAL);
        groups.addResourceLocation(LIXEL_MATERIALS_DIR "/scripts", "FileSystem");
        const std::string all = LIXEL_MATERIALS_DIR "/programs/";
        groups.addResourceLocation(programs.empty() ? all + mOptions.language : programs,
                                   "FileSystem");
        if (mOptions.language != "glsl") groups.addResourceLocation(all + "cg_hlsl", "FileSystem");
        groups.initialiseAllResourceGroups();
    }

    /// Draws one frame of a cube in the sun, whose shadows are a preset's.
    void drawCube(const std::string& preset, const std::string& material) {
        Ogre::SceneManager& manager = *mRoot.createSceneManager();
        const auto place = [&](Ogre::MovableObject* object, const Ogre::Vector3& position) {
            Ogre::SceneNode* const node =
                manager.getRootSceneNode()->createChildSceneNode(position);
            node->attachObject(object);
            return node;
        };
        Ogre::Camera* const camera = manager.createCamera("");
        camera->setNearClipDistance(1);
        place(camera, Ogre::Vector3(0, 0, 300));
        Ogre::Light* const sun = manager.createLight();
        sun->setType(Ogre::Light::LT_DIRECTIONAL);
        place(sun, Ogre::Vector3::ZERO)
            ->setDirection(Ogre::Vector3(-1, -2, -1), Ogre::Node::TS_WORLD);
        Ogre::Entity* const cube = manager.createEntity(Ogre::SceneManager::PT_CUBE);
        cube->setMaterialName(material);
        place(cube, Ogre::Vector3::ZERO);
        ShadowCameraSetupManager::getByName(preset)->applyTo(*sun);
        mWindow->addViewport(camera);
        mRoot.renderOneFrame();
    }

    /// The last frame, once it is drawn.
    std::vector<std::uint8_t> picture() const {
        const Ogre::uint32 side = mOptions.side;
        std::vector<std::uint8_t> rgb(std::size_t{3} * side * side);
        mWindow->copyContentsToMemory(Ogre::Box(0, 0, side, side),
                                      Ogre::PixelBox(side, side, 1, Ogre::PF_BYTE_RGB, rgb.data()));
        return rgb;
    }

    Ogre::Root& root() {
        return mRoot;
    }
    Ogre::RenderWindow& window() {
        return *mWindow;
    }

private:
    struct Log {
        Log() { manager.createLog("", true, false, true); }
        Ogre::LogManager manager;
    } mLog;
    Options mOptions;
    Ogre::Root mRoot{"", "", ""};
    Ogre::RenderWindow* mWindow = nullptr;
};

} // namespace Lixel::Tests
