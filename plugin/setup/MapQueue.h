#pragma once

#include "setup/MapBudget.h"

#include <map>
#include <utility>
#include <vector>

namespace Lixel {

/** Divides a frame's budget among the maps that want to be drawn.

    OGRE draws each map as soon as it was fitted, before the next one is asked for. So places are
    given at a frame's begin, by what each map wanted in the frame before; places that are not needed
    go to the next map that wants one.
*/
class LIXEL_API MapQueue {
public:
    /// A map: what it belongs to, and which of its maps it is.
    using Key = std::pair<const void*, std::size_t>;

    struct Wish {
        /// How wrong the map is that is kept, as a share of it; 0 to 1.
        double wrongness = 1.0;
        /// From the viewer to what it serves, in world units.
        double distance = 0.0;
        /// What drawing it took last time.
        double milliseconds = 0.0;
        /// Whether there is nothing to keep.
        bool must = false;
    };

    /// A map that ought to be drawn is asked for. @return whether it is to be drawn now
    bool ask(const Key& key, unsigned long frame, const Wish& wish, const MapBudget& budget);
    /// A map is asked for that need not be drawn.
    void rest(const Key& key, unsigned long frame, const MapBudget& budget);

private:
    struct Entry {
        /// Frames since it was drawn.
        unsigned age = 0;
        /// Of each frame since then.
        double urgency = 0.0;
        double milliseconds = 0.0;
        unsigned long round = 0;
        bool wants = false;
        bool hasPlace = false;
    };

    /// The map's entry in the current round; begins another round where it is time.
    Entry& enter(const Key& key, unsigned long frame, const MapBudget& budget);
    void givePlaces(const MapBudget& budget);
    bool takePlace(double milliseconds, const MapBudget& budget);

    std::map<Key, Entry> mEntries;
    unsigned long mFrame = 0;
    /// Of requests, one for each map: a frame, or a picture where several are drawn in one.
    unsigned long mRound = 1;
    /// What was given or taken in this round.
    std::size_t mMaps = 0;
    double mMilliseconds = 0.0;
    std::vector<Entry*> mWaiting;
};

/// The one of all setups.
MapQueue& mapQueue();

} // namespace Lixel
