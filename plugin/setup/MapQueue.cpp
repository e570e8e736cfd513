#include "setup/MapQueue.h"

#include <algorithm>
#include <limits>

namespace Lixel {

bool MapQueue::ask(const Key& key, unsigned long frame, const Wish& wish, const MapBudget& budget) {
    Entry& entry = enter(key, frame, budget);
    const bool must = wish.must || entry.age > budget.oldest;
    if (must && !entry.hasPlace) {
        ++mMaps;
        mMilliseconds += wish.milliseconds;
        entry.hasPlace = true;
    }
    if (!entry.hasPlace) entry.hasPlace = takePlace(wish.milliseconds, budget);

    entry.urgency = wish.wrongness / std::max(wish.distance, std::numeric_limits<double>::min());
    entry.milliseconds = wish.milliseconds;
    entry.wants = true;
    if (entry.hasPlace) entry.age = 0;
    return entry.hasPlace;
}

void MapQueue::rest(const Key& key, unsigned long frame, const MapBudget& budget) {
    Entry& entry = enter(key, frame, budget);
    if (entry.hasPlace) {
        --mMaps;
        mMilliseconds -= entry.milliseconds;
    }
    entry.age = 0;
    entry.wants = entry.hasPlace = false;
}

MapQueue::Entry& MapQueue::enter(const Key& key, unsigned long frame, const MapBudget& budget) {
    const auto known = mEntries.find(key);
    if (frame != mFrame || (known != mEntries.end() && known->second.round == mRound)) {
        mFrame = frame;
        givePlaces(budget);
    }
    Entry& entry = mEntries[key];
    // One that was not asked for in the round before is new.
    if (entry.round + 1 != mRound) entry = {};
    entry.round = mRound;
    ++entry.age;
    return entry;
}

void MapQueue::givePlaces(const MapBudget& budget) {
    std::erase_if(mEntries, [this](const auto& known) { return known.second.round != mRound; });
    ++mRound;
    mMaps = 0;
    mMilliseconds = 0.0;
    mWaiting.clear();
    for (auto& [key, entry] : mEntries) {
        entry.hasPlace = false;
        if (entry.wants) mWaiting.push_back(&entry);
    }
    const auto urgency = [&](const Entry* entry) {
        const unsigned age = entry->age + 1;
        return age > budget.oldest ? std::numeric_limits<double>::infinity() : entry->urgency * age;
    };
    std::ranges::stable_sort(mWaiting, std::ranges::greater{}, urgency);
    for (Entry* entry : mWaiting)
        entry->hasPlace = takePlace(entry->milliseconds, budget);
}

bool MapQueue::takePlace(double milliseconds, const MapBudget& budget) {
    if (budget.maps > 0 && mMaps >= budget.maps) return false;
    if (budget.milliseconds > 0.0 && mMaps > 0 &&
        mMilliseconds + milliseconds > budget.milliseconds)
        return false;
    ++mMaps;
    mMilliseconds += milliseconds;
    return true;
}

MapQueue& mapQueue() {
    static MapQueue queue;
    return queue;
}

} // namespace Lixel
