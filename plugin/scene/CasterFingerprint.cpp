#include "scene/CasterFingerprint.h"

#include "scene/CasterPass.h"
#include "scene/MeshBuffers.h"
#include "scene/PlainEntity.h"

#include <OgreHardwareVertexBuffer.h>
#include <OgreSceneNode.h>
#include <OgreSubMesh.h>
#include <OgreTechnique.h>

#include <algorithm>

namespace Lixel {
namespace {

bool isStaticData(const Ogre::VertexData* data) {
    if (data == nullptr) return true;
    return std::ranges::all_of(data->vertexBufferBinding->getBindings(), [](const auto& binding) {
        return isStaticBuffer(binding.second.get());
    });
}

} // namespace

void CasterFingerprint::take(const CasterSearch& search) {
    mValue = {};
    mUnknown.clear();
    mMaterials.clear();
    mMeshes.clear();
    if (!search.unboundedName().empty()) mUnknown = search.unboundedName();
    for (const Ogre::MovableObject* object : search.objects()) {
        if (!mUnknown.empty()) return;
        if (!add(*object)) mUnknown = object->getName();
    }
}

bool CasterFingerprint::add(const Ogre::MovableObject& object) {
    const PlainEntity plain(&object, 0);
    if (plain.entity() == nullptr) return false;
    const Ogre::Entity& entity = *plain.entity();
    if (!isStatic(*entity.getMesh())) return false;
    mValue.add(&entity);
    mValue.add(entity.getMesh().get());
    mValue.add(entity.getMesh()->getStateCount());
    mValue.add(std::uint64_t{entity.getRenderQueueGroup()});
    const Ogre::Affine3& transform = entity._getParentNodeFullTransform();
    mValue.add(std::span<const float>(transform[0], 12));
    for (Ogre::SubEntity* part : entity.getSubEntities()) {
        const Ogre::MaterialPtr& material = part->getMaterial();
        if (!material || material->getLodValues().size() > 1) return false;
        const Fingerprint* const drawn = find(*material);
        if (drawn == nullptr) return false;
        mValue.add(std::uint64_t{part->isVisible()});
        // A part's own render queue group may be one that is not drawn.
        mValue.add(part->isRenderQueueGroupSet() ? std::uint64_t{part->getRenderQueueGroup()} + 1
                                                 : std::uint64_t{0});
        mValue.add(part->getIndexDataStartIndex());
        mValue.add(part->getIndexDataEndIndex());
        // When OGRE draws a part of some indices, it leaves these with all that share the mesh.
        mValue.add(part->getSubMesh()->indexData->indexStart);
        mValue.add(part->getSubMesh()->indexData->indexCount);
        mValue.add(*drawn);
    }
    return true;
}

const Fingerprint* CasterFingerprint::find(const Ogre::Material& material) {
    const auto [entry, isNew] = mMaterials.try_emplace(&material);
    Known& known = entry->second;
    if (!isNew) return known.still ? &known.value : nullptr;
    // OGRE draws the technique of the viewport's scheme: all that it may be have to be alike.
    known.still = std::ranges::all_of(
        material.getSupportedTechniques(), [&](const Ogre::Technique* technique) {
            if (technique->getNumPasses() == 0) return false;
            const Ogre::Pass& pass = *technique->getPasses().front();
            known.value.add(technique);
            known.value.add(std::uint64_t{pass.getCullingMode()});
            known.value.add(std::uint64_t{pass.getManualCullingMode()});
            known.value.add(std::uint64_t{technique->isTransparent()});
            return drawsWhole(pass) && !technique->getShadowCasterMaterial();
        });
    known.value.add(&material);
    known.value.add(std::uint64_t{material.getTransparencyCastsShadows()});
    return known.still ? &known.value : nullptr;
}

bool CasterFingerprint::isStatic(const Ogre::Mesh& mesh) {
    const auto [entry, isNew] = mMeshes.try_emplace(&mesh, false);
    if (isNew)
        entry->second = isStaticData(mesh.sharedVertexData) &&
                        std::ranges::all_of(mesh.getSubMeshes(), [](const Ogre::SubMesh* part) {
                            const Ogre::HardwareIndexBuffer* const indices =
                                part->indexData->indexBuffer.get();
                            return (part->useSharedVertices || isStaticData(part->vertexData)) &&
                                   (indices == nullptr || isStaticBuffer(indices));
                        });
    return entry->second;
}

} // namespace Lixel
