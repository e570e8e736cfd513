#include "manager/LixelSceneManager.h"

#include "manager/CasterBatches.h"
#include "manager/LixelSceneNode.h"
#include "manager/NearestDepth.h"
#include "setup/MapPlan.h"
#include "setup/MapProof.h"

#include <OgreViewport.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace Lixel {

LixelSceneManager::LixelSceneManager(const Ogre::String& name)
    : SceneManager(name),
      mStore(std::make_shared<NodeStore>()),
      mBatches(std::make_unique<CasterBatches>()) {
    setStore(*this, mStore.get());
}

LixelSceneManager::~LixelSceneManager() {
    setStore(*this, nullptr);
}

const Ogre::String& LixelSceneManager::getTypeName() const {
    static const Ogre::String name = TypeName;
    return name;
}

void LixelSceneManager::clearScene() {
    // OGRE shuts down by it: what the render system has made must go before that goes.
    mBatches->clear();
    SceneManager::clearScene();
}

Ogre::SceneNode* LixelSceneManager::createSceneNodeImpl() {
    return new LixelSceneNode(*this, mStore);
}

Ogre::SceneNode* LixelSceneManager::createSceneNodeImpl(const Ogre::String& name) {
    return new LixelSceneNode(*this, name, mStore);
}

void LixelSceneManager::_updateSceneGraph(Ogre::Camera* camera) {
    SceneManager::_updateSceneGraph(camera);
    mStore->tighten();
}

void LixelSceneManager::_findVisibleObjects(Ogre::Camera* camera,
                                            Ogre::VisibleObjectsBoundsInfo* visibleBounds,
                                            bool onlyShadowCasters) {
    mVisible.find(*mStore, *camera);
    const bool drawsAsOgre = mActiveQueuedRenderableVisitor == &mDefaultQueuedRenderableVisitor;
    CasterBatches* const batches = mUsesBatches && !mProves && onlyShadowCasters && drawsAsOgre &&
                                           mBatches->begin(*this, *camera, *getRenderQueue())
                                       ? mBatches.get()
                                       : nullptr;
    mVisible.queue(*this, *camera, visibleBounds, onlyShadowCasters, batches);
    if (batches != nullptr) batches->queue();
}

void LixelSceneManager::_renderScene(Ogre::Camera* camera, Ogre::Viewport* viewport,
                                     bool includeOverlays) {
    if (_getCurrentRenderStage() != IRS_RENDER_TO_TEXTURE) {
        SceneManager::_renderScene(camera, viewport, includeOverlays);
        return;
    }
    std::optional<NearestDepth> nearest;
    if (storesDepthAsColour(*this, *viewport->getTarget())) nearest.emplace(*this);
    SceneManager::_renderScene(camera, viewport, includeOverlays);
    if (mBatches->takeCount() > 0 && isProofMode())
        proveBatches(*camera, *viewport, includeOverlays);
}

void LixelSceneManager::proveBatches(Ogre::Camera& camera, Ogre::Viewport& viewport,
                                     bool includeOverlays) {
    const std::vector<ShadowTarget> targets = shadowTargetsOf(*this);
    const auto drawn = std::ranges::find(targets, viewport.getTarget(), &ShadowTarget::target);
    if (drawn == targets.end()) return;
    const std::vector<std::uint8_t> batched = readTexels(*drawn->texture);
    mProves = true;
    try {
        SceneManager::_renderScene(&camera, &viewport, includeOverlays);
    } catch (...) {
        mProves = false;
        throw;
    }
    mProves = false;
    proveBatchedMap(*drawn->texture, batched);
}

Ogre::SceneManager* LixelSceneManagerFactory::createInstance(const Ogre::String& name) {
    return new LixelSceneManager(name);
}

void LixelSceneManagerFactory::destroyInstance(Ogre::SceneManager* instance) {
    delete instance;
}

} // namespace Lixel
