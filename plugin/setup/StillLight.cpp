#include "setup/StillLight.h"

#include "scene/MeshShapes.h"
#include "scene/NodeStore.h"
#include "scene/OgreVersions.h"
#include "setup/MapContent.h"
#include "setup/SetupMemory.h"
#include "setup/ShadowPass.h"

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreLight.h>
#include <OgreManualObject.h>
#include <OgreMaterialManager.h>
#include <OgreMesh.h>
#include <OgreRenderQueue.h>
#include <OgreSceneManager.h>
#include <OgreStaticGeometry.h>
#include <OgreViewport.h>

#include <algorithm>
#include <array>
#include <typeinfo>

namespace Lixel {
namespace {

/// Watching a light costs a reading of its casters: where something may look different without a
/// word, it is tried again a few times a second.
constexpr unsigned FramesOfDoubt = 15;

/// All that outlives a frame and may have the next one's maps be others.
Fingerprint memoriesOf(const LightMemory& memory) {
    Fingerprint all;
    if (memory.division) {
        memory.division->addMemory(all);
        if (memory.division->wsAimAxis) addVector(*memory.division->wsAimAxis, all);
    }
    for (std::size_t part = 0; part < memory.parts.count; ++part)
        addMemory(memory.states[part].memory, all);
    for (const std::unique_ptr<LastingMap>& lasting : memory.lasting) {
        if (!lasting) continue;
        const ShadowFit& fit = lasting->fit;
        for (const double number : fit.clipFromWorld.reshaped())
            all.add(number);
        all.add(fit.depthScale);
        all.add(fit.depthOffset);
        addVector(lasting->wsOrigin, all);
        all.add(lasting->settings);
        addMemory(lasting->state.memory, all);
    }
    return all;
}

void addQueues(Ogre::SceneManager& manager, Fingerprint& situation) {
    std::uint64_t group = 0;
    for (const auto& queue : manager.getRenderQueue()->_getQueueGroups()) {
        ++group;
        if (queue && !queue->getShadowsEnabled()) situation.add(group);
    }
}

void addOgreVector(const Ogre::Vector3& vector, Fingerprint& fingerprint) {
    fingerprint.add(std::span<const float>(vector.ptr(), 3));
}

void addViewer(const Ogre::Camera& viewer, Fingerprint& situation) {
    addMatrices(viewer, situation);
    addOgreVector(viewer.getDerivedPosition(), situation);
    situation.add(std::uint64_t{viewer.isReflected()} << 2U |
                  std::uint64_t{viewer.isCustomViewMatrixEnabled()} << 1U |
                  std::uint64_t{viewer.getUseRenderingDistance()});
    situation.add(static_cast<const void*>(viewer.getLodCamera()));
    addOgreVector(viewer.getLodCamera()->getDerivedPosition(), situation);
}

void addLightOf(const Ogre::Light& light, const Ogre::Camera& viewer, Fingerprint& situation) {
    situation.add(static_cast<std::uint64_t>(light.getType()));
    addOgreVector(light.getDerivedDirection(), situation);
    addOgreVector(light.getDerivedPosition(), situation);
    situation.add(std::array{light.getSpotlightOuterAngle().valueRadians(),
                             light._deriveShadowNearClipDistance(&viewer),
                             light.getAttenuationRange(), light.getShadowFarDistance()});
}

bool tellsChanges(const Ogre::MovableObject& object) {
    if (typeid(object) == typeid(Ogre::Entity)) {
        const auto& entity = static_cast<const Ogre::Entity&>(object);
        return entity.isInitialised() && !entity.hasSkeleton() &&
               !entity.getMesh()->hasVertexAnimation() && entity.getAttachedObjects().empty();
    }
    return typeid(object) == typeid(Ogre::ManualObject) ||
           typeid(object) == typeid(Ogre::StaticGeometry::Region);
}

} // namespace

bool StillLight::begin(const std::optional<Fingerprint>& situation, LightMemory& memory) {
    mBelieved.clear();
    mIsWatched = false;
    if (!situation) {
        forget();
        return false;
    }
    const bool isSame = mSituation == situation;
    mSituation = situation;
    if (!isSame)
        mFramesToWait = 0;
    else if (mIsDoubted)
        mFramesToWait = FramesOfDoubt;
    if (isSame && mRests) return true;
    mRests = isSame && !mIsDoubted && !mMaps.empty() && mMaps.size() == memory.maps &&
             mMemories == memoriesOf(memory);
    if (!mRests) watch(memory);
    // What changes in each frame is not looked at twice.
    mIsWatched = isSame && !mRests && mFramesToWait == 0;
    if (mFramesToWait > 0) --mFramesToWait;
    return mRests;
}

void StillLight::watch(const LightMemory& memory) {
    mRests = false;
    mIsDoubted = false;
    mMemories = memoriesOf(memory);
    mMaps.clear();
}

void StillLight::fitNevertheless(const LightMemory& memory) {
    mBelieved = std::move(mMaps);
    watch(memory);
    mIsWatched = true;
}

void StillLight::forget() {
    mSituation.reset();
    mMaps.clear();
    mBelieved.clear();
    mRests = false;
    mIsWatched = false;
}

void addSituation(const Ogre::Light& light, const Ogre::Camera& viewer,
                  const Ogre::Viewport& viewport, std::span<const ShadowTarget> targets,
                  Fingerprint& situation) {
    Ogre::SceneManager& manager = *viewer.getSceneManager();
    if (const NodeStore* const store = findStore(manager)) situation.add(store->changes());
    situation.add(MeshShapes::shared().unrest());
    situation.add(std::uint64_t{manager.getShadowTechnique()});
    situation.add(std::uint64_t{manager.getShadowTextureSelfShadow()});
    situation.add(std::uint64_t{manager.getVisibilityMask() & viewport.getVisibilityMask()});
    situation.add(std::uint64_t{Ogre::MaterialManager::getSingleton()._getActiveSchemeIndex()});
    situation.add(std::uint64_t{canClampDepth()});
    addQueues(manager, situation);
    addViewer(viewer, situation);
    addLightOf(light, viewer, situation);
    for (const ShadowTarget& target : targets)
        situation.add(std::uint64_t{target.texture->getWidth()} << 32U |
                      std::uint64_t{target.texture->getHeight()});
}

bool tellChanges(std::span<const Ogre::MovableObject* const> objects) {
    return std::ranges::all_of(
        objects, [](const Ogre::MovableObject* object) { return tellsChanges(*object); });
}

void addVector(const Vec3& vector, Fingerprint& fingerprint) {
    for (const double coordinate : vector)
        fingerprint.add(coordinate);
}

void addFrame(const FrameFingerprint& frame, Fingerprint& fingerprint) {
    addVector(frame.measures, fingerprint);
    addVector(frame.wsView, fingerprint);
    addVector(frame.wsLight, fingerprint);
}

void addMemory(const FitMemory& memory, Fingerprint& fingerprint) {
    const auto addMaybe = [&](const std::optional<Vec3>& vector) {
        fingerprint.add(std::uint64_t{vector.has_value()});
        if (vector) addVector(*vector, fingerprint);
    };
    fingerprint.add(std::uint64_t{memory.wsMapAxes.has_value()});
    if (memory.wsMapAxes)
        for (const Vec3& axis : *memory.wsMapAxes)
            addVector(axis, fingerprint);
    fingerprint.add(std::uint64_t{memory.search.has_value()});
    if (const auto& search = memory.search) {
        addVector(search->wsSpread, fingerprint);
        addMaybe(search->wsTarget);
        fingerprint.add(search->step);
        fingerprint.add(static_cast<std::uint64_t>(search->turn));
        fingerprint.add(search->cost);
        fingerprint.add(static_cast<std::uint64_t>(search->calm));
        addFrame(search->fingerprint, fingerprint);
    }
    fingerprint.add(memory.stableRadius);
    fingerprint.add(std::uint64_t{memory.orientationJumps});
}

} // namespace Lixel
