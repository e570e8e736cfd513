#pragma once

#include "fit/geometry/Types.h"
#include "scene/BoxBlock.h"
#include "scene/Fingerprint.h"
#include "scene/NodeCuller.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <vector>

#include <OgreAxisAlignedBox.h>
#include <OgreSphere.h>

namespace Ogre {
class MovableObject;
class SceneManager;
class SceneNode;
} // namespace Ogre

namespace Lixel {

/// Asks for memory that will be read soon.
inline void prefetchObject(const void* object, std::size_t size) {
    constexpr std::size_t CacheLine = 64;
    for (std::size_t line = 0; line < size; line += CacheLine)
        __builtin_prefetch(static_cast<const char*>(object) + line);
}

/// What a search in a store found, with its scratch memory.
struct NodeSearch {
    /// Slots of nodes that are inside or cut the border for certain, in order.
    std::vector<std::uint32_t> found;
    /// Slots of nodes whose boxes have to be compared again, in order.
    std::vector<std::uint32_t> doubtful;

    /// Adds what was doubtful to what was found, except where `isOutside` is true of the slot.
    template <typename IsOutside>
    void decide(const IsOutside& isOutside) {
        std::erase_if(doubtful, isOutside);
        if (doubtful.empty()) return;
        merged.clear();
        std::ranges::merge(found, doubtful, std::back_inserter(merged));
        found.swap(merged);
        doubtful.clear();
    }

    // Scratch memory: a bit for each slot.
    std::vector<std::uint64_t> foundBits;
    std::vector<std::uint64_t> doubtfulBits;
    std::vector<std::uint32_t> merged;
};

/** A scene's nodes with the boxes of what is attached to them, in flat memory.

    Boxes lie in blocks of 64, as arrays; a block holds boxes that are near to each other and of
    like size (SpatialKey.h), and has a box of its own. So a volume is compared with few blocks, and
    with the boxes of those that it cuts, eight at a time. Blocks are the leaves of a search tree of
    one level: a box that moves out of its block, and out of the block's part of the order, goes
    into the block where it belongs; a full block is split, and an empty one is joined with its
    neighbour.

    Bullet's dynamic tree (btDbvt) was measured beside it, with the same boxes, views of a quarter
    of them and moves of up to .2 m: at 10 000 boxes it takes more than twice as long to find, and 3
    times to move; at 100 000, more than 5 times, and 7 to 10 times.

    Nodes are found in the order in which they were added, wherever they move, so that what is drawn
    at equal depth does not flicker. A removed node's place is taken by one that is added later.
*/
class LIXEL_API NodeStore {
public:
    /// A node's place, from 0.
    using Slot = std::uint32_t;
    static constexpr Slot NoSlot = ~Slot{0};

    NodeStore();
    ~NodeStore();
    NodeStore(const NodeStore&) = delete;
    NodeStore& operator=(const NodeStore&) = delete;

    /// Adds a node that is nowhere until it gets a box.
    Slot add(Ogre::SceneNode& node);
    /// Sets a node's box, in the world. A null box is nowhere; one that is infinite, or has a NaN,
    /// is found by every search, and is for the searcher to decide on.
    /// @param sphere the only object's, in the world
    void set(Slot slot, const Ogre::AxisAlignedBox& box, const Ogre::Sphere& sphere);
    void remove(Slot slot);
    /// Call whenever something is attached to a node, or detached from it.
    /// @param object what is attached, where that is one object; otherwise null
    void setOnlyObject(Slot slot, Ogre::MovableObject* object) {
        mPlaces[slot].object = object;
        mPlaces[slot].known = NothingKnown;
        ++mPlaces[slot].attachment;
    }

    /// Call whenever what a shadow map may show of a node has changed: where it and its objects
    /// are, what is attached, whether it is in the scene graph.
    void noteChange() { ++mChanges; }
    /// How often that was.
    std::uint64_t changes() const { return mChanges; }
    /// Whether the application has promised to announce all other changes of objects too.
    /// @see LixelSceneManager::setChangesAnnounced
    bool areChangesAnnounced() const { return mAreChangesAnnounced; }
    void setChangesAnnounced(bool announced) {
        if (announced == mAreChangesAnnounced) return;
        mAreChangesAnnounced = announced;
        announceChange();
    }
    /// Something of an object may be otherwise, or whether it is in the scene graph.
    void announceChange() {
        ++mChanges;
        ++mReading;
    }

    /// What was read of a node's only object, as bits.
    enum Known : std::uint8_t {
        NothingKnown = 0,
        Draws = 2, ///< known where ReceivesKnown is
        CastsKnown = 4,
        Casts = 8, ///< where it is drawn
        ReceivesKnown = 16,
        Receives = 32 ///< where it is drawn
    };
    /// Objects are about to be read. @param rules all that answers depend on beside the objects
    void beginReading(const Fingerprint& rules) {
        if (rules == mReadingRules) return;
        mReadingRules = rules;
        ++mReading;
    }
    /// Somebody had a turn who may have changed objects: nothing is known of them any more, unless
    /// changes are announced.
    void endReading() {
        if (!mAreChangesAnnounced) ++mReading;
    }
    /// What is still known of a node's only object, in the scene graph.
    unsigned known(Slot slot) const {
        const Place& place = mPlaces[slot];
        return place.reading == mReading ? place.known : unsigned{NothingKnown};
    }
    /// Adds to what is known.
    void know(Slot slot, unsigned bits) {
        Place& place = mPlaces[slot];
        place.known = static_cast<std::uint8_t>(known(slot) | bits);
        place.reading = mReading;
    }

    /// Call after a frame's changes: searches are right without, and slower.
    void tighten();

    /** Finds the nodes whose boxes touch a volume.

        Single precision leaves some boxes in doubt, those that touch the volume's border.
    */
    void find(const NodeCuller& volume, NodeSearch& search) const;

    Ogre::SceneNode& node(Slot slot) const { return *mPlaces[slot].node; }
    /// Whether a slot found by a search still holds a node that has a box: listeners may destroy
    /// nodes, and create others in their places, while what was found is gone through.
    bool isSomewhere(Slot slot) const {
        return mPlaces[slot].block != nullptr || mPlaces[slot].unbounded;
    }
    /// Null where there is not one but several, or none.
    Ogre::MovableObject* onlyObject(Slot slot) const { return mPlaces[slot].object; }
    /// A number that changes with what is attached.
    std::uint32_t attachment(Slot slot) const { return mPlaces[slot].attachment; }
    /// As set.
    const Ogre::AxisAlignedBox& box(Slot slot) const { return mPlaces[slot].box; }
    const Ogre::Sphere& sphere(Slot slot) const { return mPlaces[slot].sphere; }
    /// Asks for the memory of a node and of its only object, which will be read soon. The slot's
    /// own is best asked for before.
    void prefetch(Slot slot) const;
    /// Asks for what is kept of a slot.
    void prefetchPlace(Slot slot) const { prefetchObject(&mPlaces[slot], sizeof(Place)); }
    /// Asks for the memory of a slot's box among others, which will be set soon.
    void prefetchBox(Slot slot) const;
    /// Slots in use or free: all are less than this.
    std::size_t slotCount() const { return mPlaces.size(); }
    /// Nodes that are somewhere.
    std::size_t size() const { return mSize; }
    /// Blocks of boxes, for statistics.
    std::size_t blockCount() const { return mBlocks.size(); }
    /// Blocks that a volume's border cuts, whose boxes a search compares, for statistics.
    std::size_t cutBlocks(const NodeCuller& volume) const;

private:
    struct Place {
        Ogre::SceneNode* node = nullptr;
        Ogre::MovableObject* object = nullptr;
        /// Null where the box is null or has no bounds.
        BoxBlock* block = nullptr;
        /// Within the block, or in mUnbounded.
        std::uint32_t index = 0;
        std::uint32_t attachment = 0;
        /// When what is known was read.
        std::uint32_t reading = 0;
        std::uint8_t known = NothingKnown;
        bool unbounded = false;
        Ogre::AxisAlignedBox box;
        Ogre::Sphere sphere;
    };

    void takeAway(Slot slot);
    void insert(Slot slot, std::uint64_t key, const FlatBox& box);
    void noteLoose(BoxBlock& block);
    void split(std::size_t position);
    void join(const BoxBlock& block);
    std::size_t positionOf(std::uint64_t key) const;
    std::size_t positionOf(const BoxBlock& block) const;

    std::vector<Place> mPlaces;
    std::vector<Slot> mFree;
    std::vector<Slot> mUnbounded;
    /// Sorted by the keys that they begin with, which mFirstKeys repeats.
    std::vector<std::unique_ptr<BoxBlock>> mBlocks;
    std::vector<std::uint64_t> mFirstKeys;
    std::vector<BoxBlock*> mLoose;
    std::size_t mSize = 0;
    std::uint64_t mChanges = 0;
    bool mAreChangesAnnounced = false;
    /// Changes when all has to be read anew.
    std::uint32_t mReading = 1;
    Fingerprint mReadingRules;
};

/// The store of a scene manager that keeps one, or null.
LIXEL_API NodeStore* findStore(const Ogre::SceneManager& manager);
/// Announces a change in all of them.
LIXEL_API void announceChangeInStores();
/// Tells findStore of a scene manager's store; null when it goes.
LIXEL_API void setStore(const Ogre::SceneManager& manager, NodeStore* store);

} // namespace Lixel
