#include "setup/SetupMemory.h"

#include "setup/ShadowPass.h"

#include <OgreCamera.h>
#include <OgreLight.h>
#include <OgreRoot.h>

namespace Lixel {
namespace {

/// Memories unused for this many frames are dropped: their light or camera may be gone.
constexpr unsigned long ForgetAfterFrames = 600;

} // namespace

LightMemory::~LightMemory() {
    // The last reference to a setup may go between the preparation of its map and the pass.
    for (const CasterVolume& volume : volumes)
        releaseShadowPass(volume);
}

void SetupMemory::sceneGone(Ogre::SceneManager& sceneManager) {
    mScenes.erase(&sceneManager);
}

void SetupMemory::sweep(Scene& scene, unsigned long frame) {
    if (frame - scene.lastSweep <= ForgetAfterFrames) return;
    std::erase_if(scene.lights, [&](const auto& entry) {
        return frame - entry.second->lastFrame > ForgetAfterFrames;
    });
    std::erase_if(scene.news, [](const auto& entry) { return entry.second.isForgettable(); });
    scene.lastSweep = frame;
}

SetupMemory::Kept SetupMemory::of(Ogre::SceneManager& sceneManager, const Ogre::Light& light,
                                  const Ogre::Camera& viewer) {
    const unsigned long frame = Ogre::Root::getSingleton().getNextFrameNumber();
    watchScene(sceneManager);
    Scene& scene = mScenes[&sceneManager];
    sweep(scene, frame);
    const Identity identity = identityOf(light);
    std::unique_ptr<LightMemory>& memory = scene.lights[{identity, identityOf(viewer)}];
    if (!memory) memory = std::make_unique<LightMemory>();
    memory->lastFrame = frame;
    LightNews& news = scene.news[identity];
    news.use();
    return {*memory, news};
}

} // namespace Lixel
