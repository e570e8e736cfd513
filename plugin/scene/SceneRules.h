#pragma once

#include "scene/BareParts.h"
#include "scene/Fingerprint.h"
#include "scene/NodeStore.h"

namespace Ogre {
class Camera;
class MovableObject;
class SceneManager;
class Viewport;
} // namespace Ogre

namespace Lixel {

/** What OGRE makes of an object for one viewer: whether it draws it, lets it cast and receive.

    Every question is answered from the object as it is now; nothing is remembered of it, since OGRE
    tells nobody that a flag or a material has changed.
*/
class LIXEL_API SceneRules {
public:
    SceneRules() = default;
    /// Both must outlive the rules.
    SceneRules(const Ogre::Camera& viewer, const Ogre::Viewport& viewport);

    Ogre::SceneManager& sceneManager() const { return *mSceneManager; }

    /// All that answers depend on beside the objects, where these say the same for every camera.
    const Fingerprint& fingerprint() const { return mFingerprint; }
    /// Whether a store may keep answers about an object. It gives them to all who ask by the same
    /// rules; where changes are announced, to other cameras too.
    /// @param slot of the node that has no other object; NoSlot for others
    static bool canBeKnown(const Ogre::MovableObject& object, const NodeStore* store,
                           NodeStore::Slot slot);

    /// Whether it is drawn where it is in view: visible by its own flag and by the masks of scene
    /// manager and viewport, and more than a place for others.
    bool draws(const Ogre::MovableObject& object) const;
    /// Whether it casts, of those that are drawn: as its `castShadows` says, within its rendering
    /// distance.
    bool casts(const Ogre::MovableObject& object) const;
    /// Whether a drawn object receives shadows. Its rendering distance, self-shadowing, its render
    /// queue group and its materials decide.
    /// @param bare handles and logs parts without a material
    bool receives(Ogre::MovableObject& object, BareParts& bare) const;

private:
    const Ogre::Camera* mCamera = nullptr;
    Ogre::SceneManager* mSceneManager = nullptr;
    unsigned mVisibilityMask = 0;
    /// OGRE sorts casters out of the receivers, which integrated techniques do not know.
    bool mCastersReceive = true;
    Fingerprint mFingerprint;
};

} // namespace Lixel
