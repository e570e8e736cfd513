#include "setup/LightGuard.h"

#include "scene/Identity.h"
#include "scene/Log.h"
#include "scene/OgreVersions.h"
#include "scene/PerScene.h"
#include "setup/News.h"

#include <OgreLight.h>
#include <OgreNode.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>

#include <cmath>
#include <map>
#include <string>

namespace Lixel {
namespace {

bool isFinite(const Ogre::Vector3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Whether all that its nodes say of where it is, as they stand now, is finite: what they derived in
/// the frame before is not asked for.
bool areNodesFinite(const Ogre::Light& light) {
    Ogre::Vector3 ws = Ogre::Vector3::ZERO;
    for (const Ogre::Node* node = light.getParentNode(); node != nullptr;
         node = node->getParent()) {
        const Ogre::Quaternion& turn = node->getOrientation();
        if (!std::isfinite(turn.Dot(turn)) || !isFinite(node->getScale())) return false;
        ws = turn * (node->getScale() * ws) + node->getPosition();
    }
    return isFinite(ws);
}

enum class Trouble { None, NotPlaced, NotFinite };

/// Leaves the light relative to no camera, until OGRE tells it this frame's.
Trouble troubleOf(Ogre::Light& light) {
    if (!isPlaced(light)) return Trouble::NotPlaced;
    if (!areNodesFinite(light)) return Trouble::NotFinite;
    // It may be relative to one that has gone, which it reads when it is asked where it is.
    light._setCameraRelative(nullptr);
    const bool finite =
        (light.getType() == Ogre::Light::LT_POINT || isFinite(light.getDerivedDirection())) &&
        (light.getType() == Ogre::Light::LT_DIRECTIONAL || isFinite(light.getDerivedPosition())) &&
        canDrawShadowsOf(light);
    return finite ? Trouble::None : Trouble::NotFinite;
}

const char* toString(Trouble trouble) {
    return trouble == Trouble::NotPlaced
               ? "is attached to no scene node"
               : "has a direction, position, angle or shadow distance that is not finite, or a "
                 "negative distance";
}

/// Calls `visit` with each of a scene manager's lights.
template <typename Visit>
void forLights(Ogre::SceneManager& sceneManager, const Visit& visit) {
    for (const auto& [name, object] : sceneManager.getMovableObjects(LightTypeName))
        visit(static_cast<Ogre::Light&>(*object));
}

/// What is known of a light that was bad once.
struct Guarded {
    /// Its visibility flags, while it has none.
    Ogre::uint32 flags = 0;
    bool hidden = false;
    News news;
    /// The last round in which it was there.
    unsigned long seen = 0;
};

class Guard : public SceneManagerListener {
public:
    void preUpdateSceneGraph(Ogre::SceneManager* source, Ogre::Camera*) override {
        // Shadow cameras draw with the lights as their viewer found them.
        if (source->_getCurrentRenderStage() == Ogre::SceneManager::IRS_RENDER_TO_TEXTURE) return;
        ++mRound;
        forLights(*source, [&](Ogre::Light& light) {
            const Trouble trouble = troubleOf(light);
            if (trouble != Trouble::None)
                hide(light, trouble);
            else if (!mGuarded.empty())
                show(light);
            // OGRE 1.12 derives anew where a light is relative to the camera only after it moved.
            if (source->getCameraRelativeRendering()) light._notifyMoved();
        });
        std::erase_if(mGuarded, [this](const auto& entry) { return entry.second.seen != mRound; });
    }

    /// Before it goes.
    void leave(Ogre::SceneManager& sceneManager) {
        forLights(sceneManager, [this](Ogre::Light& light) {
            const auto found = mGuarded.find(identityOf(light));
            if (found == mGuarded.end() || !found->second.hidden) return;
            const Trouble trouble = troubleOf(light);
            if (trouble == Trouble::None) return show(light);
            log(light, toString(trouble),
                " still: it stays without visibility flags, and nobody will put them on again");
        });
    }

private:
    static void log(const Ogre::Light& light, const char* what, const char* consequence) {
        std::string message = "light '" + light.getName() + "' ";
        message += what;
        message += consequence;
        logWarning(message);
    }

    void hide(Ogre::Light& light, Trouble trouble) {
        const Identity identity = identityOf(light);
        const bool mayShine = light.getVisible() && light.getVisibilityFlags() != 0;
        if (!mayShine && !mGuarded.contains(identity)) return;
        Guarded& guarded = mGuarded[identity];
        guarded.seen = mRound;
        if (!mayShine && !guarded.hidden) return;
        // Whatever flags it has now, its user gave it.
        if (light.getVisibilityFlags() != 0) guarded.flags = light.getVisibilityFlags();
        light.setVisibilityFlags(0);
        guarded.hidden = true;
        if (guarded.news.isNew(static_cast<unsigned>(trouble),
                               Ogre::Root::getSingleton().getNextFrameNumber()))
            log(light, toString(trouble),
                "; it neither shines nor casts shadows until that is mended");
    }

    void show(Ogre::Light& light) {
        const auto found = mGuarded.find(identityOf(light));
        if (found == mGuarded.end()) return;
        Guarded& guarded = found->second;
        guarded.seen = mRound;
        if (guarded.hidden && light.getVisibilityFlags() == 0)
            light.setVisibilityFlags(guarded.flags);
        guarded.hidden = false;
    }

    /// Of those that are still there.
    std::map<Identity, Guarded> mGuarded;
    unsigned long mRound = 0;
};

PerScene<Guard>& guards() {
    static PerScene<Guard> all;
    return all;
}

} // namespace

void guardLights(Ogre::SceneManager& sceneManager) {
    guards().of(sceneManager);
}

void unguardLights() {
    guards().forEach(
        [](Ogre::SceneManager& sceneManager, Guard& guard) { guard.leave(sceneManager); });
    guards().clear();
}

} // namespace Lixel
