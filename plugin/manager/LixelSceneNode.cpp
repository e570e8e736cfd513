#include "manager/LixelSceneNode.h"

#include "scene/Log.h"

#include <OgreMovableObject.h>
#include <OgreSceneManager.h>

#include <algorithm>
#include <array>
#include <utility>

namespace Lixel {
namespace {

bool isFinite(const Ogre::Affine3& transform) {
    // Each is 0, or NaN for what is not finite. Four sums, which do not wait for each other.
    std::array<Ogre::Real, 4> sums{};
    for (int row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            sums[column] += 0 * transform[row][column];
    return sums[0] + sums[1] + sums[2] + sums[3] == 0;
}

/// Whether a map may show an object. Viewers, lights and shadow cameras move in each frame, and who
/// asks for maps reads them himself.
bool mayBeSeen(const Ogre::MovableObject* object) {
    const Ogre::uint32 type = object->getTypeFlags();
    return type != Ogre::SceneManager::FRUSTUM_TYPE_MASK &&
           type != Ogre::SceneManager::LIGHT_TYPE_MASK;
}

} // namespace

LixelSceneNode::~LixelSceneNode() {
    mNodes->moved.remove(*this);
    if (mNodes->moved.root() == this) mNodes->moved.setRoot(nullptr);
    if (mMatters) store().noteChange();
    if (mSlot != NodeStore::NoSlot) store().remove(mSlot);
}

void LixelSceneNode::attachObject(Ogre::MovableObject* object) {
    SceneNode::attachObject(object);
    // At once: OGRE updates nodes by their addresses, and the order of drawing must not depend on
    // it.
    if (mSlot == NodeStore::NoSlot) mSlot = store().add(*this);
    noteObjects();
}

Ogre::MovableObject* LixelSceneNode::detachObject(unsigned short index) {
    Ogre::MovableObject* const object = SceneNode::detachObject(index);
    noteObjects();
    return object;
}

void LixelSceneNode::detachObject(Ogre::MovableObject* object) {
    SceneNode::detachObject(object);
    noteObjects();
}

Ogre::MovableObject* LixelSceneNode::detachObject(const Ogre::String& name) {
    Ogre::MovableObject* const object = SceneNode::detachObject(name);
    noteObjects();
    return object;
}

void LixelSceneNode::detachAllObjects() {
    SceneNode::detachAllObjects();
    noteObjects();
}

void LixelSceneNode::noteObjects() {
    if (mSlot == NodeStore::NoSlot) return;
    const auto& objects = getAttachedObjects();
    store().setOnlyObject(mSlot, objects.size() == 1 ? objects.front() : nullptr);
    const bool didMatter = std::exchange(mMatters, std::ranges::any_of(objects, mayBeSeen));
    if (didMatter || mMatters) store().noteChange();
}

void LixelSceneNode::updateFromParentImpl() const {
    // Its box is next.
    if (mSlot != NodeStore::NoSlot) store().prefetchPlace(mSlot);
    SceneNode::updateFromParentImpl();
    if (mMatters) store().noteChange();
}

void LixelSceneNode::needUpdate(bool forceParentUpdate) {
    // What has no parent is the root, or out of the scene graph.
    if (mParent == nullptr || mParent != mNodes->moved.root())
        return SceneNode::needUpdate(forceParentUpdate);
    mNeedParentUpdate = true;
    mNeedChildUpdate = true;
    mCachedTransformOutOfDate = true;
    if (!mParentNotified || forceParentUpdate) mNodes->moved.add(*this);
    mParentNotified = true;
    mChildrenToUpdate.clear(); // all of them are updated
}

void LixelSceneNode::_update(bool updateChildren, bool parentHasChanged) {
    SceneNode::_update(updateChildren, parentHasChanged);
    if (updateChildren && mNodes->moved.root() == this) mNodes->moved.update();
}

void LixelSceneNode::setParent(Ogre::Node* parent) {
    mNodes->moved.remove(*this);
    SceneNode::setParent(parent);
    // A new node has nothing yet that comes or goes with it.
    if (mSlot != NodeStore::NoSlot || numChildren() > 0) store().announceChange();
}

void LixelSceneNode::_updateBounds() {
    mWorldAABB.setNull();
    if (getAttachedObjects().empty()) {
        if (mSlot == NodeStore::NoSlot) return;
        store().remove(mSlot);
        mSlot = NodeStore::NoSlot;
        return;
    }
    store().prefetchBox(mSlot);
    // OGRE asserts on boxes of objects at places that are not finite.
    const bool placed = isFinite(_getFullTransform());
    if (placed) {
        for (const Ogre::MovableObject* object : getAttachedObjects())
            mWorldAABB.merge(object->getWorldBoundingBox(true));
    } else if (!mReported) {
        logWarning("scene node '" + getName() + "' (with '" +
                   getAttachedObjects().front()->getName() +
                   "') has a position, orientation or scale that is not finite; it is not drawn "
                   "until it has");
    }
    mReported = !placed;
    const Ogre::MovableObject* const only = store().onlyObject(mSlot);
    // Derived at once, not when it is asked for: sphere queries find what no camera has seen.
    store().set(mSlot, mWorldAABB,
                placed && only != nullptr ? only->getWorldBoundingSphere(true) : Ogre::Sphere());
}

} // namespace Lixel
