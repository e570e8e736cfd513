#pragma once

#include "fit/geometry/Types.h"

#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace Ogre {
class Entity;
class Material;
class MovableObject;
} // namespace Ogre

namespace Lixel {

/** Parts of objects that have no material, and what the log was told of them.

    OGRE draws such a part in its default white, which receives shadows. For a part of an entity it
    first asks the missing material for a level of detail, and crashes. So this is logged before
    anything is drawn. */
class BareParts {
public:
    /// Forgets what was read of materials. Until the next call nothing of them changes.
    void begin() { mRead.fill({}); }
    /// Whether any part of the object receives shadows. Ogre::MovableObject's own check would use
    /// a material that is not there. Logs missing materials, once for each object.
    /// @param castersReceive whether parts that cast do
    bool receives(Ogre::MovableObject& object, bool castersReceive);

private:
    /// What materials say that many parts wear, at places that follow from their addresses.
    struct Read {
        const Ogre::Material* material = nullptr;
        /// None where it depends on the part.
        std::optional<bool> receives;
    };

    /// The answer for an entity whose parts all have such materials.
    std::optional<bool> receivesAsMaterials(const Ogre::Entity& entity);

    std::array<Read, 64> mRead;
    std::set<std::pair<const Ogre::MovableObject*, std::string>> mTold;
};

} // namespace Lixel
