#pragma once

#include "fit/problem/ShadowProblem.h"
#include "scene/CasterFingerprint.h"
#include "scene/Fingerprint.h"
#include "setup/DrawnMap.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace Ogre {
class Camera;
class Light;
class MovableObject;
class Viewport;
} // namespace Ogre

namespace Lixel {

class Survey;
struct FitMemory;
struct FrameFingerprint;
struct LightMemory;
struct ShadowTarget;

/// A map as it was fitted.
struct StillMap {
    ShownMap shown;
    /// Without its bodies.
    ShadowProblem problem;
    CasterFingerprint casters;
    /// LightMemory::nextPart, afterwards.
    std::size_t nextPart = 0;
};

/** Whether a light's maps are those of the frame before, without a look at the scene: where the
    application announces changes of objects (NodeStore::areChangesAnnounced).

    Maps are a function of the situation, of the scene, and of what fits remember. So where a frame
    had the situation of the one before, the scene has told of no change, and the fits have left
    their memory as they found it, all frames to come are the same.
*/
class StillLight {
public:
    /** A frame begins with the light's first map.
        @param situation of this frame; none where nothing can be said of it
        @return whether all of the light's maps are those that were noted last */
    bool begin(const std::optional<Fingerprint>& situation, LightMemory& memory);
    /// Whether it returned true.
    bool rests() const { return mRests; }
    /// Whether this frame is fitted, and may be the last one that is.
    bool isWatched() const { return mIsWatched; }

    /// What was fitted, map by map.
    void note(const StillMap& map) { mMaps.push_back(map); }
    /// Something in this frame may look different in the next one, and nobody tells.
    void doubt() { mIsDoubted = true; }
    const StillMap& map(std::size_t iteration) const { return mMaps[iteration]; }

    /// Has this frame fitted, though its maps are known: they are kept apart, to be compared.
    void fitNevertheless(const LightMemory& memory);
    /// The map that would have been repeated; null where none would.
    const StillMap* believed(std::size_t iteration) const {
        return iteration < mBelieved.size() ? &mBelieved[iteration] : nullptr;
    }

    /// Nothing is known.
    void forget();

private:
    void watch(const LightMemory& memory);

    std::optional<Fingerprint> mSituation;
    /// What fits remembered before the last frame that was fitted.
    Fingerprint mMemories;
    std::vector<StillMap> mMaps;
    std::vector<StillMap> mBelieved;
    bool mRests = false;
    bool mIsWatched = false;
    bool mIsDoubted = false;
    /// Until it is watched again.
    unsigned mFramesToWait = 0;
};

/// Adds all of a light, viewer and scene manager that a light's maps depend on.
/// @param targets the maps', from the first one on
void addSituation(const Ogre::Light& light, const Ogre::Camera& viewer,
                  const Ogre::Viewport& viewport, std::span<const ShadowTarget> targets,
                  Fingerprint& situation);

/// Whether none of these receivers may be elsewhere or look different without a word: entities
/// without skeleton, vertex animation and attached objects, manual objects and static geometry.
bool tellChanges(std::span<const Ogre::MovableObject* const> objects);

void addVector(const Vec3& vector, Fingerprint& fingerprint);
void addFrame(const FrameFingerprint& frame, Fingerprint& fingerprint);
/// Adds all that may have the next fit be another.
void addMemory(const FitMemory& memory, Fingerprint& fingerprint);

} // namespace Lixel
