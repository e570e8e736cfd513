#include "scene/SceneRules.h"

#include "scene/PlainEntity.h"

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreInstancedEntity.h>
#include <OgreMaterialManager.h>
#include <OgreRenderQueue.h>
#include <OgreRenderQueueSortingGrouping.h>
#include <OgreSceneManager.h>
#include <OgreViewport.h>

#include <algorithm>
#include <typeinfo>

namespace Lixel {
namespace {

/// Whether an object is more than a place for others: cameras and lights are attached to nodes too,
/// and instances, which their batch draws.
bool isDrawn(const Ogre::MovableObject& object) {
    constexpr Ogre::uint32 WithoutFactory = ~Ogre::uint32{0};
    switch (object.getTypeFlags()) {
    case Ogre::SceneManager::FRUSTUM_TYPE_MASK:
    case Ogre::SceneManager::LIGHT_TYPE_MASK:
        return false;
    case WithoutFactory: // terrain, batches, instances, an application's own
        return dynamic_cast<const Ogre::InstancedEntity*>(&object) == nullptr;
    default:
        return true;
    }
}

/// Whether the object is too far from `lodCamera` to be drawn, as
/// MovableObject::_notifyCurrentCamera decides; that function itself would change the object's
/// state and fire its listeners.
bool isBeyondRenderingDistance(const Ogre::MovableObject& object, const Ogre::Camera& lodCamera) {
    const Ogre::Node* const node = object.getParentNode();
    // The radius is the sphere's, scaled by the node as OGRE scales it.
    const Ogre::Vector3& scale = node->_getDerivedScale();
    const Ogre::Real factor = std::max({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)});
    const Ogre::Real reach = object.getRenderingDistance() + object.getBoundingRadius() * factor;
    return node->getSquaredViewDepth(&lodCamera) > reach * reach;
}

bool hasRenderingDistance(const Ogre::MovableObject& object, const Ogre::Camera& viewer) {
    return object.getRenderingDistance() > 0 && viewer.getUseRenderingDistance();
}

/// Whether something on the object's bones receives, which is drawn with it but is on no node.
template <typename Receives>
bool attachmentReceives(const Ogre::MovableObject& object, const Receives& receives) {
    const auto* const entity = dynamic_cast<const Ogre::Entity*>(&object);
    if (entity == nullptr) return false;
    const auto& attached = entity->getAttachedObjects();
    return std::any_of(attached.begin(), attached.end(), [&](Ogre::MovableObject* child) {
        return child->getVisible() && receives(*child);
    });
}

} // namespace

SceneRules::SceneRules(const Ogre::Camera& viewer, const Ogre::Viewport& viewport)
    : mCamera(&viewer),
      mSceneManager(viewer.getSceneManager()),
      mVisibilityMask(viewport.getVisibilityMask() & mSceneManager->getVisibilityMask()),
      mCastersReceive(mSceneManager->getShadowTextureSelfShadow() ||
                      mSceneManager->isShadowTechniqueIntegrated()) {
    mFingerprint.add(std::uint64_t{mVisibilityMask});
    mFingerprint.add(std::uint64_t{mCastersReceive});
    mFingerprint.add(std::uint64_t{Ogre::MaterialManager::getSingleton()._getActiveSchemeIndex()});
    std::uint64_t group = 0;
    for (const auto& queue : mSceneManager->getRenderQueue()->_getQueueGroups()) {
        ++group;
        if (queue && !queue->getShadowsEnabled()) mFingerprint.add(group);
    }
}

bool SceneRules::canBeKnown(const Ogre::MovableObject& object, const NodeStore* store,
                            NodeStore::Slot slot) {
    if (store == nullptr || slot == NodeStore::NoSlot ||
        object.getWorldBoundingBox() != store->box(slot))
        return false;
    return !store->areChangesAnnounced() || PlainEntity(&object, 0).entity() != nullptr;
}

bool SceneRules::draws(const Ogre::MovableObject& object) const {
    // getVisible() is the object's own flag; isVisible() would answer for the last camera drawn.
    return object.getVisible() && (object.getVisibilityFlags() & mVisibilityMask) != 0 &&
           (typeid(object) == typeid(Ogre::Entity) || isDrawn(object));
}

bool SceneRules::casts(const Ogre::MovableObject& object) const {
    if (!object.getCastShadows()) return false;
    // OGRE makes the viewer the level of detail camera of shadow cameras, whatever its own is.
    return !hasRenderingDistance(object, *mCamera) || !isBeyondRenderingDistance(object, *mCamera);
}

bool SceneRules::receives(Ogre::MovableObject& object, BareParts& bare) const {
    if (hasRenderingDistance(object, *mCamera) &&
        isBeyondRenderingDistance(object, *mCamera->getLodCamera()))
        return false;
    const auto asked = [&](Ogre::MovableObject& body) {
        return bare.receives(body, mCastersReceive);
    };
    return mSceneManager->getRenderQueue()
               ->getQueueGroup(object.getRenderQueueGroup())
               ->getShadowsEnabled() &&
           (asked(object) || attachmentReceives(object, asked));
}

} // namespace Lixel
