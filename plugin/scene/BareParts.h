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

    OGRE itself draws such a part in its default white, which receives shadows; but an entity's it
    asks for its level of detail, and crashes. So the log has to say it before anything is drawn. */
class BareParts {
public:
    /// Whether a part of the object's receives shadows: its material does, as Ogre::MovableObject
    /// has it, which would ask a material that is not there. Says so in the log, once for each
    /// object.
    /// @param castersReceive whether parts that cast do
    bool receives(Ogre::MovableObject& object, bool castersReceive);

private:
    std::set<std::pair<const Ogre::MovableObject*, std::string>> mTold;
};

} // namespace Lixel
