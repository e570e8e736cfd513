#pragma once

#include "scene/NodeStore.h"
#include "scene/PlainEntity.h"

#include <vector>

namespace Ogre {
struct VisibleObjectsBoundsInfo;
} // namespace Ogre

namespace Lixel {

class CasterBatches;

/** Finds what a camera sees in a store, and queues it as OGRE's default scene manager does.

    OGRE asks each object in view for its levels of detail, its materials and its bounds, which
    takes longer than all else, most of it waiting for memory. Plain entities go a short way, after
    OGRE's own way has been taken once.
*/
class VisibleObjects {
public:
    /// Finds the nodes whose objects `camera` sees.
    void find(const NodeStore& store, const Ogre::Camera& camera);

    /// Queues the objects of the nodes found.
    /// @param bounds are widened by what was queued; may be null
    /// @param batches take what casters they can; null where each is queued by itself
    void queue(Ogre::SceneManager& manager, Ogre::Camera& camera,
               Ogre::VisibleObjectsBoundsInfo* bounds, bool onlyShadowCasters,
               CasterBatches* batches);

private:
    void fetchAhead(std::size_t position) const;

    NodeSearch mSearch;
    const NodeStore* mStore = nullptr;
    /// For each slot what was plain when OGRE's way was last taken.
    std::vector<PlainEntity> mPlain;
};

} // namespace Lixel
