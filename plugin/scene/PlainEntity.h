#pragma once

#include <OgreEntity.h>
#include <OgreMesh.h>
#include <OgreSubEntity.h>

namespace Lixel {

/** An entity about which nothing depends on the camera that sees it: no listener, rendering
    distance, levels of detail, skeleton, animation or attachments.

    What OGRE tells nobody of is read anew each time. The rest cannot change while the entity stays
    attached and its mesh stays the same.
*/
class PlainEntity {
public:
    /// Nothing that is plain.
    PlainEntity() = default;
    /// @param attachment number of the node's last change of attachments
    PlainEntity(const Ogre::MovableObject* object, std::uint32_t attachment);

    /// Whether it is the plain entity that was attached at that change, and still plain.
    bool isStill(const Ogre::MovableObject* object, std::uint32_t attachment) const {
        return mEntity != nullptr && mEntity == object && mAttachment == attachment &&
               hasPlainSettings(*mEntity) && hasSameMesh();
    }
    /// Null for nothing that is plain.
    const Ogre::Entity* entity() const { return mEntity; }
    /// Whether it was this one at that change: good enough to ask for its memory.
    bool was(const Ogre::MovableObject* object, std::uint32_t attachment) const {
        return mEntity == object && mAttachment == attachment;
    }

private:
    static bool hasPlainSettings(const Ogre::Entity& entity) {
        return entity.getListener() == nullptr && !(entity.getRenderingDistance() > 0) &&
               !(entity.getRenderingMinPixelSize() > 0);
    }
    static bool hasPlainMesh(const Ogre::Mesh& mesh) {
        return mesh.getNumLodLevels() <= 1 && !mesh.hasSkeleton() && !mesh.hasVertexAnimation();
    }
    bool hasSameMesh() const {
        return mMesh->getStateCount() == mMeshState &&
               mMesh->getBoundingSphereRadius() == mMeshRadius && hasPlainMesh(*mMesh);
    }

    const Ogre::Entity* mEntity = nullptr;
    const Ogre::Mesh* mMesh = nullptr;
    std::size_t mMeshState = 0;
    Ogre::Real mMeshRadius = 0;
    std::uint32_t mAttachment = 0;
};

/// Whether the parts' materials have no levels of detail, and are there.
bool hasPlainMaterials(const Ogre::Entity& entity);

} // namespace Lixel
