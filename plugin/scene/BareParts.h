#pragma once

#include "fit/geometry/Types.h"

#include <set>
#include <string>
#include <utility>

namespace Ogre {
class MovableObject;
} // namespace Ogre

namespace Lixel {

/** Parts of objects that have no material, and what the log was told of them.

    OGRE draws such a part in its default white, which receives shadows. For a part of an entity it
    first asks the missing material for a level of detail, and crashes. So this is logged before
    anything is drawn. */
class BareParts {
public:
    /// Whether any part of the object receives shadows. Ogre::MovableObject's own check would use
    /// a material that is not there. Logs missing materials, once for each object.
    /// @param castersReceive whether parts that cast do
    bool receives(Ogre::MovableObject& object, bool castersReceive);

private:
    std::set<std::pair<const Ogre::MovableObject*, std::string>> mTold;
};

} // namespace Lixel
