#include "scene/PlainEntity.h"

#include <algorithm>
#include <typeinfo>

namespace Lixel {

PlainEntity::PlainEntity(const Ogre::MovableObject* object, std::uint32_t attachment)
    : mAttachment(attachment) {
    if (object == nullptr || typeid(*object) != typeid(Ogre::Entity)) return;
    const auto& entity = static_cast<const Ogre::Entity&>(*object);
    if (!entity.isInitialised() || !hasPlainSettings(entity) || entity.hasSkeleton() ||
        !entity.getAttachedObjects().empty() || !hasPlainMesh(*entity.getMesh()))
        return;
    mEntity = &entity;
    mMesh = entity.getMesh().get();
    mMeshState = mMesh->getStateCount();
    mMeshRadius = mMesh->getBoundingSphereRadius();
}

bool hasPlainMaterials(const Ogre::Entity& entity) {
    return std::ranges::all_of(entity.getSubEntities(), [](const Ogre::SubEntity* part) {
        const Ogre::MaterialPtr& material = part->getMaterial();
        return material && material->getLodValues().size() <= 1;
    });
}

} // namespace Lixel
