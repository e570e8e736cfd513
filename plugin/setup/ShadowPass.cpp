#include "setup/ShadowPass.h"

#include "scene/OgreVersions.h"
#include "scene/PerScene.h"
#include "setup/MapProof.h"

#include <OgreCamera.h>
#include <OgreRenderSystem.h>
#include <OgreRenderTarget.h>
#include <OgreRenderTargetListener.h>
#include <OgreRoot.h>
#include <OgreViewport.h>

#include <algorithm>
#include <chrono>
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
    void arm(Ogre::Camera& camera, Ogre::Frustum* volume, const std::optional<MapContent>& content,
             StillLayer* layer = nullptr) {
        Ogre::RenderTarget* const target = camera.getViewport()->getTarget();
        // Only the first call saves the culling frustum, which is restored after the pass.
        Armed& armed =
            mArmed[target].try_emplace(&camera, Armed(camera.getCullingFrustum())).first->second;
        if (volume != nullptr) {
            armed.volume = volume;
            armed.content = content;
            armed.layer = layer;
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
                    armed.layer = nullptr; // of the same setup's memory
                }
    }

    /// Has a camera's texture compared with what it holds now, after the camera drew into it.
    void prove(Ogre::Camera& camera, const Ogre::TexturePtr& texture) {
        Armed& armed = mArmed.at(camera.getViewport()->getTarget()).at(&camera);
        armed.proof = texture;
        armed.kept = readTexels(*texture);
    }

    /// Says what a target shows, until something is drawn into it.
    void note(const Ogre::RenderTarget* target, const MapContent& content) {
        mContents.insert_or_assign(target, content);
    }

    const MapContent* contentOf(const ShadowTarget& target) const {
        const auto known = mContents.find(target.target);
        if (known == mContents.end()) return nullptr;
        // Another target may have come to be at the address of one that has gone.
        const MapContent& content = known->second;
        return content.texture.lock() == target.texture &&
                       content.textureState == target.texture->getStateCount()
                   ? &content
                   : nullptr;
    }

    StillLayer* layerOf(const Ogre::Camera& camera, const Ogre::RenderTarget& target) const {
        const auto armed = mArmed.find(&target);
        // Cameras that share a target are drawn together.
        if (armed == mArmed.end() || armed->second.size() != 1) return nullptr;
        const auto& [drawn, state] = *armed->second.begin();
        return drawn == &camera ? state.layer : nullptr;
    }

    double drawingTimeOf(const Ogre::RenderTarget* target) const {
        const auto known = mMilliseconds.find(target->getName());
        return known != mMilliseconds.end() ? known->second : 0.0;
    }

    void forgetContents() {
        mContents.clear();
        ++mGeneration;
    }
    unsigned long generation() const { return mGeneration; }

    void forget() {
        Ogre::RenderSystem* const system = Ogre::Root::getSingleton().getRenderSystem();
        for (const Ogre::String& name : mTargets)
            if (Ogre::RenderTarget* const target =
                    system != nullptr ? system->getRenderTarget(name) : nullptr)
                target->removeListener(this);
        mTargets.clear();
        mContents.clear();
        mMilliseconds.clear();
        abandon([](const Ogre::Camera&) { return true; });
    }

    /// Sets those cameras back that wait for a pass, which an exception has ended or kept from
    /// beginning.
    template <typename IsAbandoned>
    void abandon(const IsAbandoned& isAbandoned) {
        for (auto& [target, cameras] : mArmed)
            std::erase_if(cameras, [&](const auto& entry) {
                const auto& [camera, armed] = entry;
                if (!isAbandoned(*camera)) return false;
                setDepthClamp(false);
                disarm(*camera, armed);
                return true;
            });
        eraseEmpty();
    }

    void cameraDestroyed(Ogre::Camera* camera) override {
        for (auto& [target, cameras] : mArmed)
            cameras.erase(camera);
        eraseEmpty();
    }

    void preRenderTargetUpdate(const Ogre::RenderTargetEvent& event) override {
        if (mArmed.count(event.source) == 0) return;
        setDepthClamp(true);
        mBegin = Clock::now();
    }

    /// Whatever is drawn into the target, what it showed before is gone.
    void preViewportUpdate(const Ogre::RenderTargetViewportEvent& event) override {
        mContents.erase(event.source->getTarget());
    }

    void postViewportUpdate(const Ogre::RenderTargetViewportEvent& event) override {
        Ogre::RenderTarget* const target = event.source->getTarget();
        // A map may have been drawn into it meanwhile: of the shadows that a shadow camera sees.
        mContents.erase(target);
        const auto armed = mArmed.find(target);
        // Cameras that share a target are drawn together.
        if (armed == mArmed.end() || armed->second.size() != 1) return;
        const auto& [camera, state] = *armed->second.begin();
        if (state.volume != nullptr && state.content && event.source->getCamera() == camera)
            note(target, *state.content);
    }

    void postRenderTargetUpdate(const Ogre::RenderTargetEvent& event) override {
        const auto armed = mArmed.find(event.source);
        if (armed == mArmed.end()) return;
        setDepthClamp(false);
        for (const auto& [camera, state] : armed->second) {
            disarm(*camera, state);
            if (state.content)
                mMilliseconds[event.source->getName()] =
                    std::chrono::duration<double, std::milli>(Clock::now() - mBegin).count();
            if (state.proof) proveMap(*state.proof, state.kept);
        }
        mArmed.erase(armed);
    }

private:
    using Clock = std::chrono::steady_clock;

    static void setDepthClamp(bool enabled) {
        if (canClampDepth()) Ogre::Root::getSingleton().getRenderSystem()->_setDepthClamp(enabled);
    }

    struct Armed {
        explicit Armed(Ogre::Frustum* culling) : before(culling) {}

        Ogre::Frustum* before;             ///< the culling frustum that comes back
        Ogre::Frustum* volume = nullptr;   ///< what it is meanwhile
        std::optional<MapContent> content; ///< what the target shows afterwards
        StillLayer* layer = nullptr;       ///< in which it is drawn
        Ogre::TexturePtr proof;            ///< to be compared with what it held before
        std::vector<std::uint8_t> kept;
    };

    void disarm(Ogre::Camera& camera, const Armed& armed) {
        camera.removeListener(this);
        camera.setCullingFrustum(armed.before);
        camera.getViewport()->setAutoUpdated(true);
    }

    void eraseEmpty() {
        std::erase_if(mArmed, [](const auto& entry) { return entry.second.empty(); });
    }

    /// Cameras that will draw into a target. Several may share one since OGRE 14, which also gives
    /// each a culling frustum of its own and expects it to stay.
    std::map<const Ogre::RenderTarget*, std::map<Ogre::Camera*, Armed>> mArmed;
    std::map<const Ogre::RenderTarget*, MapContent> mContents;
    unsigned long mGeneration = 0;
    /// When the target that is being drawn was begun, and how long each one took, by
    /// its name, which a texture that is made anew has again.
    Clock::time_point mBegin;
    std::map<Ogre::String, double> mMilliseconds;
    /// Names of all that it listens to. Some may have gone.
    std::set<Ogre::String> mTargets;
};

ShadowPassListener& listener() {
    static ShadowPassListener instance;
    return instance;
}

/// Sets back, before a viewer's frame, what the last one left behind where an exception ended it:
/// since 13.6 OGRE needs each shadow camera's own culling frustum before it asks any setup.
class FrameBegin : public SceneManagerListener {
public:
    void preUpdateSceneGraph(Ogre::SceneManager* source, Ogre::Camera*) override {
        // Between the setups and their passes, shadow cameras draw.
        if (source->_getCurrentRenderStage() == Ogre::SceneManager::IRS_RENDER_TO_TEXTURE) return;
        listener().abandon(
            [&](const Ogre::Camera& camera) { return camera.getSceneManager() == source; });
    }
};

PerScene<FrameBegin>& frameBegins() {
    static PerScene<FrameBegin> all;
    return all;
}

/// As ShadowPassListener::arm.
void arm(Ogre::Camera& camera, Ogre::Frustum* volume, const std::optional<MapContent>& content,
         StillLayer* layer = nullptr) {
    frameBegins().of(*camera.getSceneManager());
    listener().arm(camera, volume, content, layer);
}

} // namespace

bool canClampDepth() {
    const Ogre::RenderSystem* const system = Ogre::Root::getSingleton().getRenderSystem();
    return system != nullptr && system->getCapabilities() != nullptr &&
           system->getCapabilities()->hasCapability(Ogre::RSC_DEPTH_CLAMP);
}

void forgetShadowPasses() {
    frameBegins().clear();
    listener().forget();
}

void armShadowPass(Ogre::Camera& shadowCamera, Ogre::Frustum& cullingFrustum,
                   const std::optional<MapContent>& content, StillLayer* layer) {
    arm(shadowCamera, &cullingFrustum, content, layer);
}

void proveShadowPass(Ogre::Camera& shadowCamera, Ogre::Frustum& cullingFrustum,
                     const std::optional<MapContent>& content, const ShadowTarget& target) {
    arm(shadowCamera, &cullingFrustum, content);
    listener().prove(shadowCamera, target.texture);
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

void skipShadowPass(Ogre::Camera& shadowCamera, const ShadowTarget& target, bool believed) {
    const auto clear = [&] {
        clearViewport(*shadowCamera.getViewport(), Ogre::FBT_COLOUR | Ogre::FBT_DEPTH,
                      Ogre::ColourValue::White);
    };
    const MapContent* const content = contentOf(target);
    const bool isEmpty = content != nullptr && content->empty;
    const bool proves = isProofMode() && (isEmpty || believed);
    const std::vector<std::uint8_t> kept =
        proves ? readTexels(*target.texture) : std::vector<std::uint8_t>();
    if (!isEmpty || proves) clear();
    if (proves) proveMap(*target.texture, kept);
    if (!isEmpty) {
        MapContent empty;
        empty.empty = true;
        empty.texture = target.texture;
        empty.textureState = target.texture->getStateCount();
        listener().note(target.target, empty);
    }
    shadowCamera.getViewport()->setAutoUpdated(false);
    arm(shadowCamera, nullptr, std::nullopt);
}

void keepShadowPass(Ogre::Camera& shadowCamera, Ogre::Frustum& cullingFrustum) {
    shadowCamera.getViewport()->setAutoUpdated(false);
    arm(shadowCamera, &cullingFrustum, std::nullopt);
}

const MapContent* contentOf(const ShadowTarget& target) {
    return listener().contentOf(target);
}

StillLayer* layerOf(const Ogre::Camera& shadowCamera, const Ogre::RenderTarget& target) {
    return listener().layerOf(shadowCamera, target);
}

double drawingTimeOf(const ShadowTarget& target) {
    return listener().drawingTimeOf(target.target);
}

void forgetContents() {
    listener().forgetContents();
}

unsigned long contentGeneration() {
    return listener().generation();
}

} // namespace Lixel
