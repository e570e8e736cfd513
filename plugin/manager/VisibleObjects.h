#pragma once

#include "scene/NodeStore.h"
#include "scene/PlainEntity.h"
#include "setup/StillLayer.h"

#include <vector>

namespace Ogre {
struct VisibleObjectsBoundsInfo;
} // namespace Ogre

namespace Lixel {

class CasterBatches;

/// The objects of a layer, or all others; all objects without a layer.
struct LayerPart {
    const StillLayer* layer = nullptr;
    bool isStill = false;

    bool has(const Ogre::MovableObject& object) const {
        return layer == nullptr || layer->holds(object) == isStill;
    }
};

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
    /// @param part which of them are queued
    void queue(Ogre::SceneManager& manager, Ogre::Camera& camera,
               Ogre::VisibleObjectsBoundsInfo* bounds, bool onlyShadowCasters,
               CasterBatches* batches, const LayerPart& part = {});

private:
    void fetchAhead(std::size_t position) const;

    NodeSearch mSearch;
    const NodeStore* mStore = nullptr;
    /// For each slot what was plain when OGRE's way was last taken.
    std::vector<PlainEntity> mPlain;
};

} // namespace Lixel
