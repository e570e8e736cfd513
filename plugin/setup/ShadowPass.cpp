#include "setup/ShadowPass.h"

#include "scene/OgreVersions.h"

#include <OgreCamera.h>
#include <OgreRenderSystem.h>
#include <OgreRenderTarget.h>
#include <OgreRenderTargetListener.h>
#include <OgreRoot.h>
#include <OgreViewport.h>

#include <algorithm>
#include <map>
#include <set>

namespace Lixel {
namespace {

/// One for all targets, and never destroyed before them: a render target does not tell its
/// listeners when it goes. Cameras do: where an exception ends the preparation of maps, their
/// textures may go before they are drawn.
class ShadowPassListener : public Ogre::RenderTargetListener, public Ogre::Camera::Listener {
public:
    /// @param volume the camera's culling frustum from now on, or null to leave it as it is
    void arm(Ogre::Camera& camera, Ogre::Frustum* volume) {
        Ogre::RenderTarget* const target = camera.getViewport()->getTarget();
        // Only the first call saves the culling frustum, which is restored after the pass.
        Armed& armed =
            mArmed[target].try_emplace(&camera, Armed{camera.getCullingFrustum()}).first->second;
        if (volume != nullptr) {
            armed.volume = volume;
            camera.setCullingFrustum(volume);
        }
        target->addListener(this); // once, however often it is called
        camera.addListener(this);
        mTargets.insert(target->getName());
    }

    void release(const Ogre::Frustum& volume) {
        for (auto& [target, cameras] : mArmed)
            for (auto& [camera, armed] : cameras)
                if (armed.volume == &volume) {
                    camera->setCullingFrustum(armed.before);
                    armed.volume = nullptr;
                }
    }

    void forget() {
        Ogre::RenderSystem* const system = Ogre::Root::getSingleton().getRenderSystem();
        for (const Ogre::String& name : mTargets)
            if (Ogre::RenderTarget* const target =
                    system != nullptr ? system->getRenderTarget(name) : nullptr)
                target->removeListener(this);
        mTargets.clear();
        for (const auto& [target, cameras] : mArmed)
            for (const auto& [camera, armed] : cameras)
                camera->removeListener(this);
        mArmed.clear();
    }

    void cameraDestroyed(Ogre::Camera* camera) override {
        for (auto& [target, cameras] : mArmed)
            cameras.erase(camera);
        std::erase_if(mArmed, [](const auto& entry) { return entry.second.empty(); });
    }

    void preRenderTargetUpdate(const Ogre::RenderTargetEvent& event) override {
        if (mArmed.count(event.source) != 0) setDepthClamp(true);
    }

    void postRenderTargetUpdate(const Ogre::RenderTargetEvent& event) override {
        const auto armed = mArmed.find(event.source);
        if (armed == mArmed.end()) return;
        setDepthClamp(false);
        for (const auto& [camera, state] : armed->second) {
            camera->removeListener(this);
            camera->setCullingFrustum(state.before);
            camera->getViewport()->setAutoUpdated(true);
        }
        mArmed.erase(armed);
    }

private:
    static void setDepthClamp(bool enabled) {
        if (canClampDepth()) Ogre::Root::getSingleton().getRenderSystem()->_setDepthClamp(enabled);
    }

    struct Armed {
        Ogre::Frustum* before = nullptr; ///< the culling frustum that comes back
        Ogre::Frustum* volume = nullptr; ///< what it is meanwhile
    };
    /// Cameras that will draw into a target. Several may share one since OGRE 14, which also gives
    /// each a culling frustum of its own and expects it to stay.
    std::map<Ogre::RenderTarget*, std::map<Ogre::Camera*, Armed>> mArmed;
    /// Names of all that it listens to. Some may have gone.
    std::set<Ogre::String> mTargets;
};

ShadowPassListener& listener() {
    static ShadowPassListener instance;
    return instance;
}

} // namespace

bool canClampDepth() {
    const Ogre::RenderSystem* const system = Ogre::Root::getSingleton().getRenderSystem();
    return system != nullptr && system->getCapabilities() != nullptr &&
           system->getCapabilities()->hasCapability(Ogre::RSC_DEPTH_CLAMP);
}

void forgetShadowPasses() {
    listener().forget();
}

void armShadowPass(Ogre::Camera& shadowCamera, Ogre::Frustum& cullingFrustum) {
    listener().arm(shadowCamera, &cullingFrustum);
}

void releaseShadowPass(const Ogre::Frustum& cullingFrustum) {
    listener().release(cullingFrustum);
}

std::vector<ShadowTarget> shadowTargetsFrom(const Ogre::Camera& camera,
                                            Ogre::SceneManager& sceneManager) {
    std::vector<ShadowTarget> targets = shadowTargetsOf(sceneManager);
    const Ogre::Viewport* const viewport = camera.getViewport();
    const auto own = std::ranges::find(
        targets, viewport != nullptr ? viewport->getTarget() : nullptr, &ShadowTarget::target);
    targets.erase(targets.begin(), own);
    return targets;
}

void skipShadowPass(Ogre::Camera& shadowCamera) {
    Ogre::Viewport* const viewport = shadowCamera.getViewport();
    clearViewport(*viewport, Ogre::FBT_COLOUR | Ogre::FBT_DEPTH, Ogre::ColourValue::White);
    viewport->setAutoUpdated(false);
    listener().arm(shadowCamera, nullptr);
}

} // namespace Lixel
