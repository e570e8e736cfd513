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
    };

    FreshOgre() : FreshOgre(Options()) {}
    explicit FreshOgre(const Options& options) {
        if (const std::string error = Headless::enable(); !error.empty())
            throw std::runtime_error(error);
        mRoot.loadPlugin(OGRE_PLUGIN_DIR "/RenderSystem_GL3Plus.so");
        if (options.hasPlugin) mRoot.loadPlugin(LIXEL_PLUGIN_DIR "/Plugin_Lixel.so");
        Ogre::RenderSystem& system = *mRoot.getAvailableRenderers().front();
        mRoot.setRenderSystem(&system);
        system.setConfigOption("Separate Shader Objects", options.separateShaders ? "Yes" : "No");
        mRoot.initialise(false);
        Ogre::NameValuePairList parameters;
        for (const auto& [name, value] : Headless::windowParameters())
            parameters[name] = value;
        mWindow = mRoot.createRenderWindow("", Side, Side, false, &parameters);
    }

    /// Reads Lixel's materials; their scripts may be those of another folder.
    void readScripts(const std::string& scripts = LIXEL_MATERIALS_DIR "/scripts") {
        auto& groups = Ogre::ResourceGroupManager::getSingleton();
        groups.addResourceLocation(OGRE_SHADOW_MEDIA, "FileSystem", Ogre::RGN_INTERNAL);
        groups.addResourceLocation(scripts, "FileSystem");
        groups.addResourceLocation(LIXEL_MATERIALS_DIR "/programs/glsl", "FileSystem");
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
        std::vector<std::uint8_t> rgb(std::size_t{3} * Side * Side);
        mWindow->copyContentsToMemory(Ogre::Box(0, 0, Side, Side),
                                      Ogre::PixelBox(Side, Side, 1, Ogre::PF_BYTE_RGB, rgb.data()));
        return rgb;
    }

private:
    static constexpr Ogre::uint32 Side = 64;

    struct Log {
        Log() { manager.createLog("", true, false, true); }
        Ogre::LogManager manager;
    } mLog;
    Ogre::Root mRoot{"", "", ""};
    Ogre::RenderWindow* mWindow = nullptr;
};

} // namespace Lixel::Tests
