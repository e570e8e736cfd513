#pragma once

#include "scene/CasterSearch.h"
#include "scene/Fingerprint.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace Ogre {
class Entity;
class Material;
class Mesh;
} // namespace Ogre

namespace Lixel {

/** Tells whether casters look the same to a shadow map as they did before.

    OGRE tells nobody that a flag, a material or a transform has changed, so everything that a
    caster's depths depend on is read again. That can be said of entities about which nothing
    depends on the camera (PlainEntity.h), made of static buffers and of materials without holes
    and without shadow programs of their own. Whatever else casts may look different each time:
    skeletons, particles, billboards, holes, an application's own objects.
*/
class CasterFingerprint {
public:
    /// One caster, as it was read last.
    struct Caster {
        const Ogre::MovableObject* object = nullptr;
        /// None where it may look different each time.
        std::optional<Fingerprint> value;
        /// The reading since which it has been there in each, and the same.
        unsigned long since = 0;
        /// The last reading that it was in.
        unsigned long read = 0;
    };

    CasterFingerprint() = default;
    /// Of casters that were read before, all of them known.
    explicit CasterFingerprint(const Fingerprint& value) : mValue(value) {}

    /** Reads the casters that a search found.
        @param each whether to read each of them and remember it, for each() to tell which ones have
        changed; otherwise reading ends with the first that may look different each time */
    void take(const CasterSearch& search, bool each);

    /// Of all casters; no use where one of them is unknown.
    const Fingerprint& value() const { return mValue; }
    /// The first caster that may look different each time; empty if there is none.
    const std::string& unknownName() const { return mUnknown; }

    /// Each caster that has bounds, where that was asked for. Valid until the next reading.
    std::span<const Caster* const> each() const { return {mEach.data(), mEach.size()}; }
    /// The number of the last reading.
    unsigned long reading() const { return mReading; }
    /// Whether a caster was the same in so many readings before the last one, and in that.
    bool isStill(const Caster& caster, unsigned long readings) const {
        return caster.value && mReading - caster.since >= readings;
    }

private:
    /// @return none where it may look different each time
    std::optional<Fingerprint> read(const Ogre::MovableObject& object);
    void remember(const Ogre::MovableObject& object, const std::optional<Fingerprint>& value);
    void forgetGone();
    /// Null where what it draws may be different each time.
    const Fingerprint* find(const Ogre::Material& material);
    bool isStatic(const Ogre::Mesh& mesh);

    Fingerprint mValue;
    std::string mUnknown;
    unsigned long mReading = 0;
    /// By address: another object at the same one is another caster unless it looks the same.
    std::unordered_map<const Ogre::MovableObject*, Caster> mKnown;
    std::vector<Caster*> mEach;
    /// Of the reading before, since most casters are found in the same order again.
    std::vector<Caster*> mBefore;
    // What many casters share, read once for all of them.
    struct Known {
        bool still = false;
        Fingerprint value;
    };
    std::map<const Ogre::Material*, Known> mMaterials;
    std::map<const Ogre::Mesh*, bool> mMeshes;
};

} // namespace Lixel
