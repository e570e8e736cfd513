#include "scene/NodeStore.h"

#include "fit/geometry/Multiversion.h"
#include "scene/SpatialKey.h"

#include <OgreMovableObject.h>
#include <OgreSceneNode.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <span>

namespace Lixel {
namespace {

using Slot = NodeStore::Slot;

constexpr std::size_t BlockCapacity = 64;

/// A block with fewer boxes is joined with its neighbour, where both have no more than JoinedMost:
/// then neither the next box that comes nor the next one that goes undoes it.
constexpr std::size_t SparseBlock = 12;
constexpr std::size_t JoinedMost = 40;

/// A sum of at most six products and a plane's offset in single precision, in two orders: this much
/// of the sum of the terms' sizes leaves an answer in doubt. It is 32 times the rounding of one
/// operation (2⁻²⁴), and covers the slack of CasterVolume (2⁻²¹).
constexpr float Rounding = 0x1p-19F;

/// A plane in single precision.
struct ScanPlane {
    float normal[3];
    float size[3];
    float offset;
};

struct ScanPlanes {
    std::array<ScanPlane, NodeCuller::Capacity> list;
    std::size_t count;

    explicit ScanPlanes(const NodeCuller& volume) : count(volume.size()) {
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                list[i].normal[axis] = static_cast<float>(volume[i].normal[axis]);
                list[i].size[axis] = std::abs(list[i].normal[axis]);
            }
            list[i].offset = static_cast<float>(volume[i].offset);
        }
    }
};

/// Centres and half extents of a block's boxes, an array for each coordinate.
struct Boxes {
    alignas(32) float centre[3][BlockCapacity];
    alignas(32) float half[3][BlockCapacity];
};

struct Box {
    float centre[3];
    float half[3];
};

enum class Side { Outside, Cut, Inside };

/// How a volume lies to a block: which of its planes cut the block, and from which distance to them
/// on a box's side is certain.
struct Cut {
    Side side = Side::Inside;
    float doubt = 0.0F;
    std::size_t count = 0;
    std::array<std::size_t, NodeCuller::Capacity> planes;
};

/// For each box, how far it reaches into the half space: negative where it is outside.
LIXEL_MULTIVERSION void reachInto(const Boxes& boxes, const ScanPlane& plane,
                                  float (&least)[BlockCapacity]) {
    for (std::size_t i = 0; i < BlockCapacity; ++i) {
        float reach = plane.offset;
        for (int axis = 0; axis < 3; ++axis)
            reach +=
                plane.normal[axis] * boxes.centre[axis][i] + plane.size[axis] * boxes.half[axis][i];
        least[i] = least[i] < reach ? least[i] : reach;
    }
}

/// Lowest and highest coordinate of the first `count` boxes along one axis.
LIXEL_MULTIVERSION void findEnds(const Boxes& boxes, int axis, std::size_t count, float& lowest,
                                 float& highest) {
    const float* const centre = boxes.centre[axis];
    const float* const half = boxes.half[axis];
    float lower = std::numeric_limits<float>::infinity();
    float upper = -lower;
    for (std::size_t i = 0; i < count; ++i) {
        const float low = centre[i] - half[i];
        const float high = centre[i] + half[i];
        lower = low < lower ? low : lower;
        upper = high > upper ? high : upper;
    }
    lowest = lower;
    highest = upper;
}

Box boxOf(const Ogre::AxisAlignedBox& bounds) {
    const Ogre::Vector3 centre = bounds.getCenter();
    const Ogre::Vector3 half = bounds.getHalfSize();
    return {{centre.x, centre.y, centre.z}, {half.x, half.y, half.z}};
}

/// Whether a box has ends that are finite, so that it can be sorted and compared.
bool hasBounds(const Box& box) {
    float sum = 0.0F;
    for (int axis = 0; axis < 3; ++axis)
        sum += std::abs(box.centre[axis]) + box.half[axis];
    return std::isfinite(sum);
}

void setBit(std::vector<std::uint64_t>& bits, Slot slot) {
    bits[slot / 64] |= std::uint64_t{1} << (slot % 64);
}

void listBits(const std::vector<std::uint64_t>& bits, std::vector<Slot>& slots) {
    for (std::size_t word = 0; word < bits.size(); ++word)
        for (std::uint64_t rest = bits[word]; rest != 0; rest &= rest - 1)
            slots.push_back(static_cast<Slot>(64 * word) +
                            static_cast<Slot>(std::countr_zero(rest)));
}

} // namespace

struct NodeStore::Block {
    Boxes boxes;
    Slot slots[BlockCapacity];
    std::size_t count = 0;
    /// Boxes whose keys are at least this and less than the next block's first one are here.
    std::uint64_t firstKey = 0;
    std::uint64_t endKey = 0;
    /// Around all boxes.
    float lower[3];
    float upper[3];
    /// Whether it may be larger than it need be.
    bool loose = false;

    Block() {
        // Lanes without a box are compared too.
        std::fill_n(&boxes.centre[0][0], 3 * BlockCapacity, 0.0F);
        std::fill_n(&boxes.half[0][0], 3 * BlockCapacity, 0.0F);
        findBounds();
    }

    Box box(std::size_t index) const {
        Box result;
        for (int axis = 0; axis < 3; ++axis) {
            result.centre[axis] = boxes.centre[axis][index];
            result.half[axis] = boxes.half[axis][index];
        }
        return result;
    }

    std::uint64_t key(std::size_t index) const {
        const Box own = box(index);
        return spatialKey(own.centre, own.half);
    }

    void write(std::size_t index, const float* centre, const float* halfExtents) {
        for (int axis = 0; axis < 3; ++axis) {
            boxes.centre[axis][index] = centre[axis];
            boxes.half[axis][index] = halfExtents[axis];
            lower[axis] = std::min(lower[axis], centre[axis] - halfExtents[axis]);
            upper[axis] = std::max(upper[axis], centre[axis] + halfExtents[axis]);
        }
    }

    void append(Slot slot, const float* centre, const float* halfExtents) {
        slots[count] = slot;
        write(count++, centre, halfExtents);
    }

    Cut cutBy(const ScanPlanes& planes) const {
        Cut cut;
        if (count == 0) cut.side = Side::Outside;
        for (std::size_t i = 0; i < planes.count && cut.side != Side::Outside; ++i) {
            const ScanPlane& plane = planes.list[i];
            float middle = plane.offset;
            float reach = 0.0F;
            float terms = std::abs(plane.offset);
            for (int axis = 0; axis < 3; ++axis) {
                middle += plane.normal[axis] * ((lower[axis] + upper[axis]) / 2.0F);
                reach += plane.size[axis] * ((upper[axis] - lower[axis]) / 2.0F);
                terms += std::max(std::abs(lower[axis]), std::abs(upper[axis]));
            }
            const float doubt = Rounding * terms;
            if (middle + reach < -doubt) {
                cut.side = Side::Outside;
            } else if (!(middle - reach > doubt)) {
                cut.side = Side::Cut;
                cut.planes[cut.count++] = i;
                cut.doubt = std::max(cut.doubt, doubt);
            }
        }
        return cut;
    }

    void findBounds() {
        for (int axis = 0; axis < 3; ++axis)
            findEnds(boxes, axis, count, lower[axis], upper[axis]);
    }
};

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
    const Box box = bounds.isFinite() ? boxOf(bounds) : Box{};
    if (!bounds.isFinite() || !hasBounds(box)) {
        if (place.unbounded) return;
        takeAway(slot);
        place.unbounded = true;
        place.index = static_cast<std::uint32_t>(mUnbounded.size());
        mUnbounded.push_back(slot);
        ++mSize;
        return;
    }
    const std::uint64_t key = spatialKey(box.centre, box.half);
    if (place.block != nullptr && key >= place.block->firstKey && key < place.block->endKey) {
        place.block->write(place.index, box.centre, box.half);
        if (!place.block->loose) mLoose.push_back(place.block);
        place.block->loose = true;
        return;
    }
    takeAway(slot);
    insert(slot, key, box.centre, box.half);
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
        Block& block = *place.block;
        const std::size_t last = --block.count;
        if (place.index != last) {
            const Box moved = block.box(last);
            block.slots[place.index] = block.slots[last];
            block.write(place.index, moved.centre, moved.half);
            mPlaces[block.slots[last]].index = place.index;
        }
        if (!block.loose) mLoose.push_back(&block);
        block.loose = true;
        place.block = nullptr;
        --mSize;
        if (block.count < SparseBlock) join(block);
    }
}

std::size_t NodeStore::positionOf(std::uint64_t key) const {
    const auto after = std::upper_bound(mFirstKeys.begin(), mFirstKeys.end(), key);
    return static_cast<std::size_t>(after - mFirstKeys.begin()) - 1;
}

std::size_t NodeStore::positionOf(const Block& block) const {
    // Where many boxes have one key, several blocks begin with it.
    std::size_t position = positionOf(block.firstKey);
    while (mBlocks[position].get() != &block)
        --position;
    return position;
}

void NodeStore::insert(Slot slot, std::uint64_t key, const float* centre,
                       const float* halfExtents) {
    if (mBlocks.empty()) {
        mBlocks.push_back(std::make_unique<Block>());
        mBlocks.back()->endKey = std::numeric_limits<std::uint64_t>::max();
        mFirstKeys.push_back(0);
    }
    std::size_t position = positionOf(key);
    if (mBlocks[position]->count == BlockCapacity) {
        split(position);
        position = positionOf(key);
    }
    Block& block = *mBlocks[position];
    mPlaces[slot].block = &block;
    mPlaces[slot].index = static_cast<std::uint32_t>(block.count);
    block.append(slot, centre, halfExtents);
}

void NodeStore::split(std::size_t position) {
    Block& whole = *mBlocks[position];
    struct Keyed {
        std::uint64_t key;
        std::size_t index;
    };
    std::array<Keyed, BlockCapacity> order;
    for (std::size_t i = 0; i < BlockCapacity; ++i)
        order[i] = {whole.key(i), i};
    std::ranges::sort(order, {}, &Keyed::key);
    // Equal keys stay together, unless there are no others.
    std::size_t middle = BlockCapacity / 2;
    while (middle < BlockCapacity && order[middle].key == order[middle - 1].key)
        ++middle;
    if (middle == BlockCapacity) {
        middle = BlockCapacity / 2;
        while (middle > 0 && order[middle].key == order[middle - 1].key)
            --middle;
        if (middle == 0) middle = BlockCapacity / 2;
    }

    auto upper = std::make_unique<Block>();
    upper->firstKey = order[middle].key;
    upper->endKey = whole.endKey;
    const Block old = whole;
    const auto fill = [&](Block& block, std::span<const Keyed> part) {
        block.count = 0;
        for (const Keyed& keyed : part) {
            const Box box = old.box(keyed.index);
            Place& place = mPlaces[old.slots[keyed.index]];
            place.block = &block;
            place.index = static_cast<std::uint32_t>(block.count);
            block.append(old.slots[keyed.index], box.centre, box.half);
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
void NodeStore::join(const Block& sparse) {
    if (mBlocks.size() == 1) return;
    const std::size_t position = std::max<std::size_t>(positionOf(sparse), 1);
    Block& into = *mBlocks[position - 1];
    Block& from = *mBlocks[position];
    if (into.count + from.count > JoinedMost) return;
    for (std::size_t i = 0; i < from.count; ++i) {
        const Box box = from.box(i);
        mPlaces[from.slots[i]].block = &into;
        mPlaces[from.slots[i]].index = static_cast<std::uint32_t>(into.count);
        into.append(from.slots[i], box.centre, box.half);
    }
    into.endKey = from.endKey;
    if (from.loose) std::erase(mLoose, &from);
    const auto at = static_cast<std::ptrdiff_t>(position);
    mFirstKeys.erase(mFirstKeys.begin() + at);
    mBlocks.erase(mBlocks.begin() + at);
}

void NodeStore::tighten() {
    for (Block* const block : mLoose) {
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
    for (const std::unique_ptr<Block>& block : mBlocks) {
        const Cut cut = block->cutBy(planes);
        if (cut.side == Side::Outside) continue;
        if (cut.side == Side::Inside) {
            for (std::size_t i = 0; i < block->count; ++i)
                setBit(search.foundBits, block->slots[i]);
            continue;
        }
        float least[BlockCapacity];
        std::fill_n(least, BlockCapacity, std::numeric_limits<float>::infinity());
        for (std::size_t i = 0; i < cut.count; ++i)
            reachInto(block->boxes, planes.list[cut.planes[i]], least);
        for (std::size_t i = 0; i < block->count; ++i) {
            if (least[i] > cut.doubt)
                setBit(search.foundBits, block->slots[i]);
            else if (!(least[i] < -cut.doubt)) // what is not a number is in doubt
                setBit(search.doubtfulBits, block->slots[i]);
        }
    }
    for (const Slot slot : mUnbounded)
        setBit(search.doubtfulBits, slot);
    listBits(search.foundBits, search.found);
    listBits(search.doubtfulBits, search.doubtful);
}

void NodeStore::prefetch(Slot slot) const {
    // Whether a node is in the scene graph stands at its end, whatever OGRE's version.
    __builtin_prefetch(reinterpret_cast<const char*>(mPlaces[slot].node + 1) - 1);
    // An object's flags and an entity's parts come after its name and before its animation.
    if (mPlaces[slot].object != nullptr)
        prefetchObject(mPlaces[slot].object, sizeof(Ogre::MovableObject) + sizeof(void*) * 8);
}

std::size_t NodeStore::cutBlocks(const NodeCuller& volume) const {
    const ScanPlanes planes(volume);
    return static_cast<std::size_t>(std::ranges::count_if(
        mBlocks, [&](const auto& block) { return block->cutBy(planes).side == Side::Cut; }));
}

std::size_t NodeStore::memory() const {
    return mPlaces.capacity() * sizeof(Place) + mFree.capacity() * sizeof(Slot) +
           mUnbounded.capacity() * sizeof(Slot) + mBlocks.size() * sizeof(Block) +
           mBlocks.capacity() * sizeof(mBlocks[0]) + mFirstKeys.capacity() * sizeof(mFirstKeys[0]) +
           mLoose.capacity() * sizeof(mLoose[0]);
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

void setStore(const Ogre::SceneManager& manager, NodeStore* store) {
    if (store != nullptr)
        stores()[&manager] = store;
    else
        stores().erase(&manager);
}

} // namespace Lixel
