#pragma once

#include <OgreFrameListener.h>
#include <OgrePlugin.h>

#include <memory>

namespace Lixel {

class LixelSceneManagerFactory;
class OnDemandPrograms;
class ShadowCameraSetupManager;
class ShadowParameters;

/// Lixel as OGRE's plugin: registers what scripts and materials need, and nothing else.
class Plugin : public Ogre::Plugin, public Ogre::FrameListener {
public:
    Plugin();
    ~Plugin() override;

    const Ogre::String& getName() const override;
    void install() override {}
    void initialise() override;
    void shutdown() override;
    void uninstall() override {}

    /// Guards the lights of scene managers, and serves their materials, before any setup is used.
    bool frameStarted(const Ogre::FrameEvent& event) override;

private:
    std::unique_ptr<ShadowParameters> mShadowParameters;
    std::unique_ptr<ShadowCameraSetupManager> mPresets;
    std::unique_ptr<OnDemandPrograms> mPrograms;
    std::unique_ptr<LixelSceneManagerFactory> mSceneManagers;
};

} // namespace Lixel
