#pragma once

#include "scene/CasterSearch.h"
#include "scene/Fingerprint.h"

#include <map>
#include <string>

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
    /// Reads the casters that a search found.
    void take(const CasterSearch& search);

    /// Of all casters; no use where one of them is unknown.
    const Fingerprint& value() const { return mValue; }
    /// The first caster that may look different each time; empty if there is none.
    const std::string& unknownName() const { return mUnknown; }

private:
    /// @return false where it may look different each time
    bool add(const Ogre::MovableObject& object);
    /// Null where what it draws may be different each time.
    const Fingerprint* find(const Ogre::Material& material);
    bool isStatic(const Ogre::Mesh& mesh);

    Fingerprint mValue;
    std::string mUnknown;
    // What many casters share, read once for all of them.
    struct Known {
        bool still = false;
        Fingerprint value;
    };
    std::map<const Ogre::Material*, Known> mMaterials;
    std::map<const Ogre::Mesh*, bool> mMeshes;
};

} // namespace Lixel
