#include "manager/VisibleObjects.h"

#include "manager/CameraVolume.h"
#include "manager/CasterBatches.h"
#include "manager/SeenBounds.h"
#include "scene/OgreVersions.h"

#include <OgreCamera.h>
#include <OgreDefaultDebugDrawer.h>
#include <OgreRenderQueue.h>

#include <algorithm>
#include <limits>
#include <typeinfo>

namespace Lixel {
namespace {

/// How many nodes ahead memory is asked for: what the store keeps of a node, then what lies all over
/// the heap, an entity, the list of its parts, and the parts.
constexpr std::size_t PlacesAhead = 28;
constexpr std::size_t EntitiesAhead = 12;
constexpr std::size_t ListsAhead = 8;
constexpr std::size_t PartsAhead = 4;

/// What all parts of one entity are queued with.
struct QueuePlace {
    Ogre::uint8 group;
    Ogre::ushort priority;
};

/// Where Entity::_updateRenderQueue queues a part.
QueuePlace placeOf(const Ogre::SubEntity& part, const QueuePlace& entity,
                   const Ogre::RenderQueue& queue) {
    if (part.isRenderQueuePrioritySet())
        return {part.getRenderQueueGroup(), part.getRenderQueuePriority()};
    if (part.isRenderQueueGroupSet())
        return {part.getRenderQueueGroup(), queue.getDefaultRenderablePriority()};
    return entity;
}

/// Queues an entity's visible parts as Entity::_updateRenderQueue does.
/// @param batches null where none of them can be taken
void queueParts(const Ogre::Entity& entity, const QueuePlace& place, Ogre::RenderQueue& queue,
                CasterBatches* batches) {
    for (Ogre::SubEntity* part : entity.getSubEntities()) {
        if (!part->isVisible()) continue;
        const auto [group, priority] = placeOf(*part, place, queue);
        if (batches == nullptr || !batches->take(*part, group, priority))
            queue.addRenderable(part, group, priority);
    }
}

/// As MovableObject::getReceivesShadows, of an entity.
bool receives(const Ogre::Entity& entity) {
    return std::ranges::any_of(entity.getSubEntities(), [](const Ogre::SubEntity* part) {
        const Ogre::MaterialPtr& material = part->getMaterial();
        return material->getReceiveShadows() || material->getSupportedTechniques().empty();
    });
}

/// The visibility mask that MovableObject::isVisible asks for.
Ogre::uint32 currentMask() {
    const Ogre::SceneManager* const current = Ogre::Root::getSingleton()._getCurrentSceneManager();
    return current == nullptr ? std::numeric_limits<Ogre::uint32>::max()
                              : current->_getCombinedVisibilityMask();
}

/// Whether a drawer has to be told of every node in view, and not only of those whose box is shown.
bool drawsEveryNode(const Ogre::SceneManager& manager, const Ogre::DebugDrawer& drawer) {
    return manager.getDisplaySceneNodes() || manager.getShowBoundingBoxes() ||
           typeid(drawer) != typeid(Ogre::DefaultDebugDrawer);
}

/** Queues plain entities in one pass over what is seen. */
class ShortWay {
public:
    ShortWay(Ogre::RenderQueue& queue, SeenBounds& bounds, bool onlyShadowCasters,
             CasterBatches* batches)
        : mQueue(queue),
          mBounds(bounds),
          mBatches(batches),
          mOnlyShadowCasters(onlyShadowCasters),
          mMask(currentMask()),
          // An object's group and priority begin as these; OGRE does not say whether they were set.
          mStandard(queue.getDefaultQueueGroup() == Ogre::RENDER_QUEUE_MAIN &&
                    queue.getDefaultRenderablePriority() == StandardPriority) {}

    void add(Ogre::Entity& entity, const Ogre::AxisAlignedBox& box, const Ogre::Sphere& sphere) {
        if (!entity.getVisible() || (entity.getVisibilityFlags() & mMask) == 0) return;
        for (Ogre::SubEntity* part : entity.getSubEntities())
            part->_invalidateCameraCache();
        const QueuePlace place{entity.getRenderQueueGroup(), queuePriorityOf(entity)};
        const bool received =
            mQueue.getQueueGroup(place.group)->getShadowsEnabled() && receives(entity);
        if (!mOnlyShadowCasters || entity.getCastShadows()) {
            if (mStandard)
                queueParts(entity, place, mQueue,
                           mBatches != nullptr && CasterBatches::takes(entity) ? mBatches
                                                                               : nullptr);
            else
                entity._updateRenderQueue(&mQueue);
            mBounds.merge(box, sphere, received);
        } else if (received) {
            mBounds.mergeNotDrawn(sphere);
        }
    }

private:
    static constexpr Ogre::ushort StandardPriority = 100;

    Ogre::RenderQueue& mQueue;
    SeenBounds& mBounds;
    CasterBatches* mBatches;
    bool mOnlyShadowCasters;
    Ogre::uint32 mMask;
    bool mStandard;
};

} // namespace

void VisibleObjects::find(const NodeStore& store, const Ogre::Camera& camera) {
    mStore = &store;
    const CameraVolume volume = volumeOf(camera);
    store.find(volume.planes, mSearch);
    const auto isOutside = [&](NodeStore::Slot slot) { return !camera.isVisible(store.box(slot)); };
    if (!volume.complete) std::erase_if(mSearch.found, isOutside);
    mSearch.decide(isOutside);
}

void VisibleObjects::fetchAhead(std::size_t position) const {
    const std::vector<NodeStore::Slot>& found = mSearch.found;
    if (position + PlacesAhead < found.size())
        mStore->prefetchPlace(found[position + PlacesAhead]);
    if (position + EntitiesAhead < found.size()) mStore->prefetch(found[position + EntitiesAhead]);
    const auto plain = [&](std::size_t ahead) -> const Ogre::Entity* {
        if (position + ahead >= found.size()) return nullptr;
        const NodeStore::Slot slot = found[position + ahead];
        const bool same = mPlain[slot].was(mStore->onlyObject(slot), mStore->attachment(slot));
        return same ? mPlain[slot].entity() : nullptr;
    };
    if (const Ogre::Entity* const entity = plain(ListsAhead))
        __builtin_prefetch(entity->getSubEntities().data());
    if (const Ogre::Entity* const entity = plain(PartsAhead))
        for (const Ogre::SubEntity* part : entity->getSubEntities())
            prefetchObject(part, sizeof(Ogre::SubEntity));
}

void VisibleObjects::queue(Ogre::SceneManager& manager, Ogre::Camera& camera,
                           Ogre::VisibleObjectsBoundsInfo* bounds, bool onlyShadowCasters,
                           CasterBatches* batches, const LayerPart& part) {
    Ogre::RenderQueue& queue = *manager.getRenderQueue();
    const bool anyPlain = lodListenersOf(manager).empty();
    Ogre::DebugDrawer* const drawer = manager.getDebugDrawer();
    const bool drawsNodes = drawer != nullptr && drawsEveryNode(manager, *drawer);
    mPlain.resize(std::max(mPlain.size(), mStore->slotCount()));
    SeenBounds seen(camera);
    ShortWay shortWay(queue, seen, onlyShadowCasters, batches);
    const std::vector<NodeStore::Slot>& found = mSearch.found;
    for (std::size_t i = 0; i < found.size(); ++i) {
        fetchAhead(i);
        const NodeStore::Slot slot = found[i];
        if (!mStore->isSomewhere(slot)) continue; // a listener of an object before destroyed it
        const Ogre::SceneNode& node = mStore->node(slot);
        if (!node.isInSceneGraph()) continue;
        Ogre::MovableObject* const only = mStore->onlyObject(slot);
        if (only != nullptr && !part.has(*only)) continue;
        const std::uint32_t attachment = mStore->attachment(slot);
        PlainEntity& plain = mPlain[slot];
        if (anyPlain && plain.isStill(only, attachment) && hasPlainMaterials(*plain.entity())) {
            shortWay.add(static_cast<Ogre::Entity&>(*only), mStore->box(slot),
                         mStore->sphere(slot));
        } else {
            for (Ogre::MovableObject* object : node.getAttachedObjects())
                if (part.has(*object))
                    queue.processVisibleObject(object, &camera, onlyShadowCasters, bounds);
            plain = PlainEntity(only, attachment);
            // When its materials have no levels any more, OGRE's way sets it back to the finest.
            if (plain.entity() != nullptr && !hasPlainMaterials(*plain.entity()))
                plain = PlainEntity();
        }
        if (drawsNodes || (drawer != nullptr && node.getShowBoundingBox()))
            drawer->drawSceneNode(&node);
    }
    if (bounds != nullptr) seen.addTo(*bounds);
}

} // namespace Lixel
