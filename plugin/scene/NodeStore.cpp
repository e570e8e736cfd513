#include "scene/NodeStore.h"

#include <OgreMovableObject.h>
#include <OgreSceneNode.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <span>

namespace Lixel {
namespace {

using Slot = NodeStore::Slot;

/// A block with fewer boxes is joined with its neighbour, where both have no more than JoinedMost:
/// then neither the next box that comes nor the next one that goes undoes it.
constexpr std::size_t SparseBlock = 12;
constexpr std::size_t JoinedMost = 40;

void setBit(std::vector<std::uint64_t>& bits, Slot slot) {
    bits[slot / 64] |= std::uint64_t{1} << (slot % 64);
}

/// Sets the bits of the slots of some of a block's boxes.
void setBits(std::vector<std::uint64_t>& bits, const BoxBlock& block, std::uint64_t boxes) {
    for (; boxes != 0; boxes &= boxes - 1)
        setBit(bits, block.slots[std::countr_zero(boxes)]);
}

void listBits(const std::vector<std::uint64_t>& bits, std::vector<Slot>& slots) {
    for (std::size_t word = 0; word < bits.size(); ++word)
        for (std::uint64_t rest = bits[word]; rest != 0; rest &= rest - 1)
            slots.push_back(static_cast<Slot>(64 * word) +
                            static_cast<Slot>(std::countr_zero(rest)));
}

} // namespace

NodeStore::NodeStore() = default;
NodeStore::~NodeStore() = default;

Slot NodeStore::add(Ogre::SceneNode& node) {
    Slot slot = static_cast<Slot>(mPlaces.size());
    if (mFree.empty()) {
        mPlaces.emplace_back();
    } else {
        slot = mFree.back();
        mFree.pop_back();
    }
    mPlaces[slot].node = &node;
    setOnlyObject(slot, nullptr);
    return slot;
}

void NodeStore::set(Slot slot, const Ogre::AxisAlignedBox& bounds, const Ogre::Sphere& sphere) {
    Place& place = mPlaces[slot];
    place.box = bounds;
    place.sphere = sphere;
    if (bounds.isNull()) {
        takeAway(slot);
        return;
    }
    const FlatBox box = bounds.isFinite() ? FlatBox::of(bounds) : FlatBox{};
    const auto replace = [&] {
        if (place.block->replace(place.index, box)) noteLoose(*place.block);
    };
    // Asked first: finding a box's key, and whether it has bounds, takes longer.
    if (place.block != nullptr && bounds.isFinite() && place.block->keeps(box)) return replace();
    if (!bounds.isFinite() || !box.hasBounds()) {
        if (place.unbounded) return;
        takeAway(slot);
        place.unbounded = true;
        place.index = static_cast<std::uint32_t>(mUnbounded.size());
        mUnbounded.push_back(slot);
        ++mSize;
        return;
    }
    const std::uint64_t key = box.key();
    if (place.block != nullptr && key >= place.block->firstKey && key < place.block->endKey)
        return replace();
    takeAway(slot);
    insert(slot, key, box);
    ++mSize;
}

void NodeStore::remove(Slot slot) {
    takeAway(slot);
    mPlaces[slot].node = nullptr;
    setOnlyObject(slot, nullptr);
    mFree.push_back(slot);
}

void NodeStore::takeAway(Slot slot) {
    Place& place = mPlaces[slot];
    if (place.unbounded) {
        const Slot last = mUnbounded.back();
        mUnbounded[place.index] = last;
        mPlaces[last].index = place.index;
        mUnbounded.pop_back();
        place.unbounded = false;
        --mSize;
    } else if (place.block != nullptr) {
        BoxBlock& block = *place.block;
        if (block.endsReached(place.index) != 0) noteLoose(block);
        const std::size_t last = --block.count;
        if (place.index != last) {
            const FlatBox moved = block.box(last);
            block.slots[place.index] = block.slots[last];
            block.write(place.index, moved);
            mPlaces[block.slots[last]].index = place.index;
        }
        place.block = nullptr;
        --mSize;
        if (block.count < SparseBlock) join(block);
    }
}

void NodeStore::noteLoose(BoxBlock& block) {
    if (!block.loose) mLoose.push_back(&block);
    block.loose = true;
}

std::size_t NodeStore::positionOf(std::uint64_t key) const {
    const auto after = std::upper_bound(mFirstKeys.begin(), mFirstKeys.end(), key);
    return static_cast<std::size_t>(after - mFirstKeys.begin()) - 1;
}

std::size_t NodeStore::positionOf(const BoxBlock& block) const {
    // Where many boxes have one key, several blocks begin with it.
    std::size_t position = positionOf(block.firstKey);
    while (mBlocks[position].get() != &block)
        --position;
    return position;
}

void NodeStore::insert(Slot slot, std::uint64_t key, const FlatBox& box) {
    if (mBlocks.empty()) {
        mBlocks.push_back(std::make_unique<BoxBlock>());
        mBlocks.back()->endKey = std::numeric_limits<std::uint64_t>::max();
        mFirstKeys.push_back(0);
    }
    std::size_t position = positionOf(key);
    if (mBlocks[position]->count == BoxBlock::Capacity) {
        split(position);
        position = positionOf(key);
    }
    BoxBlock& block = *mBlocks[position];
    mPlaces[slot].block = &block;
    mPlaces[slot].index = static_cast<std::uint32_t>(block.count);
    block.append(slot, box);
}

void NodeStore::split(std::size_t position) {
    BoxBlock& whole = *mBlocks[position];
    struct Keyed {
        std::uint64_t key;
        std::size_t index;
    };
    std::array<Keyed, BoxBlock::Capacity> order;
    for (std::size_t i = 0; i < BoxBlock::Capacity; ++i)
        order[i] = {whole.keyWithin(whole.box(i).key()), i};
    std::ranges::sort(order, {}, &Keyed::key);
    // Equal keys stay together, unless there are no others.
    std::size_t middle = BoxBlock::Capacity / 2;
    while (middle < BoxBlock::Capacity && order[middle].key == order[middle - 1].key)
        ++middle;
    if (middle == BoxBlock::Capacity) {
        middle = BoxBlock::Capacity / 2;
        while (middle > 0 && order[middle].key == order[middle - 1].key)
            --middle;
        if (middle == 0) middle = BoxBlock::Capacity / 2;
    }

    auto upper = std::make_unique<BoxBlock>();
    upper->firstKey = order[middle].key;
    upper->endKey = whole.endKey;
    const BoxBlock old = whole;
    const auto fill = [&](BoxBlock& block, std::span<const Keyed> part) {
        block.count = 0;
        for (const Keyed& keyed : part) {
            const FlatBox box = old.box(keyed.index);
            Place& place = mPlaces[old.slots[keyed.index]];
            place.block = &block;
            place.index = static_cast<std::uint32_t>(block.count);
            block.append(old.slots[keyed.index], box);
        }
        block.findBounds();
    };
    const std::span<const Keyed> all(order);
    fill(whole, all.first(middle));
    fill(*upper, all.subspan(middle));
    whole.endKey = upper->firstKey;
    const auto next = static_cast<std::ptrdiff_t>(position) + 1;
    mFirstKeys.insert(mFirstKeys.begin() + next, upper->firstKey);
    mBlocks.insert(mBlocks.begin() + next, std::move(upper));
}

/// Puts a block's boxes into the block before it, if both are sparse enough.
void NodeStore::join(const BoxBlock& sparse) {
    if (mBlocks.size() == 1) return;
    const std::size_t position = std::max<std::size_t>(positionOf(sparse), 1);
    BoxBlock& into = *mBlocks[position - 1];
    BoxBlock& from = *mBlocks[position];
    if (into.count + from.count > JoinedMost) return;
    for (std::size_t i = 0; i < from.count; ++i) {
        const FlatBox box = from.box(i);
        mPlaces[from.slots[i]].block = &into;
        mPlaces[from.slots[i]].index = static_cast<std::uint32_t>(into.count);
        into.append(from.slots[i], box);
    }
    into.endKey = from.endKey;
    if (from.loose) std::erase(mLoose, &from);
    const auto at = static_cast<std::ptrdiff_t>(position);
    mFirstKeys.erase(mFirstKeys.begin() + at);
    mBlocks.erase(mBlocks.begin() + at);
}

void NodeStore::tighten() {
    for (BoxBlock* const block : mLoose) {
        block->findBounds();
        block->loose = false;
    }
    mLoose.clear();
}

void NodeStore::find(const NodeCuller& volume, NodeSearch& search) const {
    search.found.clear();
    search.doubtful.clear();
    const std::size_t words = (mPlaces.size() + 63) / 64;
    search.foundBits.assign(words, 0);
    search.doubtfulBits.assign(words, 0);

    const ScanPlanes planes(volume);
    for (const std::unique_ptr<BoxBlock>& block : mBlocks) {
        const BoxBlock::Cut cut = block->cutBy(planes);
        if (cut.side == BoxBlock::Side::Outside) continue;
        const BoxBlock::Found found = cut.side == BoxBlock::Side::Inside
                                          ? BoxBlock::Found{.certain = block->allBoxes()}
                                          : block->touching(planes, cut);
        setBits(search.foundBits, *block, found.certain);
        setBits(search.doubtfulBits, *block, found.doubtful);
    }
    for (const Slot slot : mUnbounded)
        setBit(search.doubtfulBits, slot);
    listBits(search.foundBits, search.found);
    listBits(search.doubtfulBits, search.doubtful);
}

void NodeStore::prefetch(Slot slot) const {
    if (!isSomewhere(slot)) return;
    // Whether a node is in the scene graph stands at its end, whatever OGRE's version.
    __builtin_prefetch(reinterpret_cast<const char*>(mPlaces[slot].node + 1) - 1);
    // An object's flags and an entity's parts come after its name and before its animation.
    if (mPlaces[slot].object != nullptr)
        prefetchObject(mPlaces[slot].object, sizeof(Ogre::MovableObject) + sizeof(void*) * 8);
}

void NodeStore::prefetchBox(Slot slot) const {
    const Place& place = mPlaces[slot];
    if (place.block == nullptr) return;
    prefetchObject(place.block, offsetof(BoxBlock, boxes));
    prefetchObject(&place.block->boxes[place.index / BoxBlock::Lanes], sizeof(BoxBlock::Eight));
}

std::size_t NodeStore::cutBlocks(const NodeCuller& volume) const {
    const ScanPlanes planes(volume);
    return static_cast<std::size_t>(std::ranges::count_if(mBlocks, [&](const auto& block) {
        return block->cutBy(planes).side == BoxBlock::Side::Cut;
    }));
}

namespace {
std::map<const Ogre::SceneManager*, NodeStore*>& stores() {
    static std::map<const Ogre::SceneManager*, NodeStore*> all;
    return all;
}
} // namespace

NodeStore* findStore(const Ogre::SceneManager& manager) {
    const auto found = stores().find(&manager);
    return found == stores().end() ? nullptr : found->second;
}

void announceChangeInStores() {
    for (const auto& [manager, store] : stores())
        store->announceChange();
}

void setStore(const Ogre::SceneManager& manager, NodeStore* store) {
    if (store != nullptr)
        stores()[&manager] = store;
    else
        stores().erase(&manager);
}

} // namespace Lixel
