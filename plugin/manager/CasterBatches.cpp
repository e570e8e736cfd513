#include "manager/CasterBatches.h"

#include "scene/CasterPass.h"
#include "scene/OgreVersions.h"
#include "setup/MapContent.h"

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgrePass.h>
#include <OgreRenderQueue.h>
#include <OgreSubEntity.h>
#include <OgreTechnique.h>

#include <algorithm>

namespace Lixel {
namespace {

/// For how many maps a batch that is not used keeps its buffers.
constexpr std::uint64_t MapsUnused = 256;

} // namespace

std::size_t CasterBatches::Hash::operator()(const CasterBatchKey& key) const {
    const auto rest = static_cast<std::uint64_t>(key.culling) << 32U |
                      std::uint64_t{key.group} << 16U | std::uint64_t{key.priority};
    return (reinterpret_cast<std::uintptr_t>(key.mesh) ^ rest) * 0x9E3779B97F4A7C15ULL >> 7U;
}

bool CasterBatches::begin(Ogre::SceneManager& manager, const Ogre::Camera& camera,
                          Ogre::RenderQueue& queue) {
    mBegun.clear();
    Ogre::Viewport& viewport = *camera.getViewport();
    const Ogre::RenderSystem& system = *Ogre::Root::getSingleton().getRenderSystem();
    if (camera.getPolygonMode() != Ogre::PM_SOLID || hasWindow(camera) ||
        !drawsQueuesAsUsual(manager, viewport) || hasGlobalInstances(system) ||
        // Integers cannot be blended: there the order of drawing decides.
        Ogre::PixelUtil::isInteger(viewport.getTarget()->suggestPixelFormat()) ||
        queue.getRenderableListener() != nullptr || hasForeignListener(manager) ||
        !mMaterials.follow(manager))
        return false;
    mQueue = &queue;
    ++mMap;
    mSource.setCurrentCamera(&camera, manager.getCameraRelativeRendering());
    mSource.setCurrentRenderTarget(viewport.getTarget());
    return true;
}

bool CasterBatches::takes(const Ogre::Entity& entity) {
    return !entity._getParentNodeFullTransform().linear().hasNegativeScale();
}

bool CasterBatches::take(Ogre::SubEntity& part, Ogre::uint8 group, Ogre::ushort priority) {
    const auto [start, end] = indexRangeOf(part);
    if (start != end || part.getUseIdentityView() || part.getUseIdentityProjection()) return false;
    const std::optional<Ogre::CullingMode> culling = cullingOf(part);
    if (!culling) return false;
    const CasterBatchKey key{part.getSubMesh(), *culling, group, priority};
    std::unique_ptr<CasterBatch>& batch = mBatches[key];
    if (!batch) batch = std::make_unique<CasterBatch>(key);
    if (batch->map != mMap) {
        batch->map = mMap;
        batch->casters().clear();
        mBegun.push_back(batch.get());
    }
    batch->casters().push_back(&part);
    return true;
}

std::optional<Ogre::CullingMode> CasterBatches::cullingOf(const Ogre::SubEntity& part) {
    Known& known = mKnown[part.getMaterial().get()];
    if (known.map != mMap) known = {mMap, readCulling(part)};
    return known.culling;
}

std::optional<Ogre::CullingMode> CasterBatches::readCulling(const Ogre::SubEntity& part) const {
    part.getMaterial()->touch(); // as RenderQueue::addRenderable
    Ogre::Technique* const technique = part.getTechnique();
    if (technique == nullptr || technique->getNumPasses() == 0 ||
        technique->getShadowCasterMaterial() || technique->isTransparent() ||
        technique->isTransparentSortingForced())
        return std::nullopt;
    const Ogre::Pass& pass = *technique->getPass(0);
    if (!drawsWhole(pass)) return std::nullopt;
    if (!mQueue->getSplitPassesByLightingType()) return pass.getCullingMode();
    // Then OGRE draws the first pass's ambient part as a caster, or the pass itself.
    std::size_t drawn = 0;
    for (const Ogre::IlluminationPass* lit : technique->getIlluminationPasses()) {
        if (lit->stage != Ogre::IS_AMBIENT || lit->pass->getIndex() > 0) continue;
        if (!drawsWhole(*lit->pass) || lit->pass->getCullingMode() != pass.getCullingMode())
            return std::nullopt;
        ++drawn;
    }
    return drawn == 1 ? std::optional(pass.getCullingMode()) : std::nullopt;
}

void CasterBatches::queue() {
    for (CasterBatch* batch : mBegun) {
        const CasterBatchKey& key = batch->key();
        if (batch->casters().size() >= FewestCasters && CasterBatch::canDraw(*key.mesh)) {
            batch->fill(mSource, mMaterials.of(key.culling));
            mQueue->addRenderable(batch, key.group, key.priority);
            ++mCount;
        } else {
            for (Ogre::SubEntity* caster : batch->casters())
                mQueue->addRenderable(caster, key.group, key.priority);
        }
    }
    mBegun.clear();
    mSource.setCurrentRenderable(nullptr);
    if (mMap % MapsUnused == 0) forgetUnused();
}

void CasterBatches::forgetUnused() {
    const auto isOld = [&](std::uint64_t map) { return map + MapsUnused < mMap; };
    std::erase_if(mBatches, [&](const auto& entry) { return isOld(entry.second->map); });
    std::erase_if(mKnown, [&](const auto& entry) { return isOld(entry.second.map); });
}

void CasterBatches::clear() {
    mBegun.clear();
    mBatches.clear();
    mKnown.clear();
    mMaterials.clear();
    mCount = 0;
}

} // namespace Lixel
