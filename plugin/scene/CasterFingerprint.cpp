#include "scene/CasterFingerprint.h"

#include "scene/CasterPass.h"
#include "scene/MeshBuffers.h"
#include "scene/PlainEntity.h"

#include <OgreHardwareVertexBuffer.h>
#include <OgreSceneNode.h>
#include <OgreSubMesh.h>
#include <OgreTechnique.h>

#include <algorithm>
#include <utility>

namespace Lixel {
namespace {

bool isStaticData(const Ogre::VertexData* data) {
    if (data == nullptr) return true;
    return std::ranges::all_of(data->vertexBufferBinding->getBindings(), [](const auto& binding) {
        return isStaticBuffer(binding.second.get());
    });
}

} // namespace

void CasterFingerprint::take(const CasterSearch& search, bool each) {
    mValue = {};
    mUnknown.clear();
    mMaterials.clear();
    mMeshes.clear();
    std::swap(mEach, mBefore);
    mEach.clear();
    ++mReading;
    if (!search.unboundedName().empty()) mUnknown = search.unboundedName();
    for (const Ogre::MovableObject* object : search.objects()) {
        if (!mUnknown.empty() && !each) return;
        const std::optional<Fingerprint> value = read(*object);
        if (value)
            mValue.add(*value);
        else if (mUnknown.empty())
            mUnknown = object->getName();
        if (each) remember(*object, value);
    }
    forgetGone();
}

void CasterFingerprint::remember(const Ogre::MovableObject& object,
                                 const std::optional<Fingerprint>& value) {
    const std::size_t place = mEach.size();
    const bool isInPlace = place < mBefore.size() && mBefore[place]->object == &object;
    Caster& caster = isInPlace ? *mBefore[place] : mKnown[&object];
    const bool isSame = value && caster.read + 1 == mReading && caster.value == value;
    if (!isSame) {
        caster.object = &object;
        caster.value = value;
        caster.since = mReading;
    }
    caster.read = mReading;
    mEach.push_back(&caster);
}

void CasterFingerprint::forgetGone() {
    // Now and then: what has gone may come back, and does no harm meanwhile.
    if (mKnown.size() <= 2 * mEach.size() + 64) return;
    std::erase_if(mKnown, [this](const auto& known) { return known.second.read != mReading; });
}

std::optional<Fingerprint> CasterFingerprint::read(const Ogre::MovableObject& object) {
    const PlainEntity plain(&object, 0);
    if (plain.entity() == nullptr) return std::nullopt;
    const Ogre::Entity& entity = *plain.entity();
    if (!isStatic(*entity.getMesh())) return std::nullopt;
    Fingerprint value;
    value.add(&entity);
    value.add(entity.getMesh().get());
    value.add(entity.getMesh()->getStateCount());
    value.add(std::uint64_t{entity.getRenderQueueGroup()});
    const Ogre::Affine3& transform = entity._getParentNodeFullTransform();
    value.add(std::span<const float>(transform[0], 12));
    for (Ogre::SubEntity* part : entity.getSubEntities()) {
        const Ogre::MaterialPtr& material = part->getMaterial();
        if (!material || material->getLodValues().size() > 1) return std::nullopt;
        const Fingerprint* const drawn = find(*material);
        if (drawn == nullptr) return std::nullopt;
        value.add(std::uint64_t{part->isVisible()});
        // A part's own render queue group may be one that is not drawn.
        value.add(part->isRenderQueueGroupSet() ? std::uint64_t{part->getRenderQueueGroup()} + 1
                                                : std::uint64_t{0});
        const auto [start, end] = indexRangeOf(*part);
        value.add(std::uint64_t{start});
        value.add(std::uint64_t{end});
        // When OGRE draws a part of some indices, it leaves these with all that share the mesh.
        value.add(std::uint64_t{part->getSubMesh()->indexData->indexStart});
        value.add(std::uint64_t{part->getSubMesh()->indexData->indexCount});
        value.add(*drawn);
    }
    return value;
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
