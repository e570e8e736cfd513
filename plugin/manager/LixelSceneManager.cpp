#include "manager/LixelSceneManager.h"

#include "manager/CasterBatches.h"
#include "manager/LixelSceneNode.h"
#include "manager/NearestDepth.h"
#include "manager/VisibleObjects.h"
#include "setup/MapContent.h"
#include "setup/MapPlan.h"
#include "setup/MapProof.h"
#include "setup/ShadowPass.h"
#include "setup/StillLayer.h"

#include <OgreRenderQueue.h>
#include <OgreRenderTarget.h>
#include <OgreViewport.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

namespace Lixel {
namespace {

/// Has what is drawn added to what a viewport shows, while it lives.
class WithoutClearing {
public:
    explicit WithoutClearing(Ogre::Viewport& viewport)
        : mViewport(viewport), mBuffers(viewport.getClearBuffers()) {
        mViewport.setClearEveryFrame(false, mBuffers);
    }
    ~WithoutClearing() { mViewport.setClearEveryFrame(true, mBuffers); }
    WithoutClearing(const WithoutClearing&) = delete;
    WithoutClearing& operator=(const WithoutClearing&) = delete;

private:
    Ogre::Viewport& mViewport;
    unsigned mBuffers;
};

/// Has OGRE's current scene manager be the one that it was, where an exception ends a frame. OGRE
/// leaves it, and objects of other scenes ask it even when it is destroyed.
class CurrentManagerKept {
public:
    CurrentManagerKept() = default;
    ~CurrentManagerKept() {
        if (std::uncaught_exceptions() > mExceptions) resetCurrentSceneManager(mBefore);
    }
    CurrentManagerKept(const CurrentManagerKept&) = delete;
    CurrentManagerKept& operator=(const CurrentManagerKept&) = delete;

private:
    int mExceptions = std::uncaught_exceptions();
    Ogre::SceneManager* mBefore = Ogre::Root::getSingleton()._getCurrentSceneManager();
};

/// Whether a viewport begins with nothing in all of its target.
bool clearsAll(const Ogre::Viewport& viewport) {
    const Ogre::RenderTarget& target = *viewport.getTarget();
    return viewport.getClearEveryFrame() && (viewport.getClearBuffers() & Ogre::FBT_COLOUR) != 0 &&
           static_cast<unsigned>(viewport.getActualWidth()) == target.getWidth() &&
           static_cast<unsigned>(viewport.getActualHeight()) == target.getHeight();
}

void widen(Ogre::VisibleObjectsBoundsInfo& bounds, const Ogre::VisibleObjectsBoundsInfo& other) {
    bounds.aabb.merge(other.aabb);
    bounds.receiverAabb.merge(other.receiverAabb);
    bounds.minDistance = std::min(bounds.minDistance, other.minDistance);
    bounds.maxDistance = std::max(bounds.maxDistance, other.maxDistance);
    bounds.minDistanceInFrustum = std::min(bounds.minDistanceInFrustum, other.minDistanceInFrustum);
    bounds.maxDistanceInFrustum = std::max(bounds.maxDistanceInFrustum, other.maxDistanceInFrustum);
}

} // namespace

LixelSceneManager::LixelSceneManager(const Ogre::String& name)
    : SceneManager(name),
      mNodes(std::make_shared<SceneNodes>()),
      mStore(&mNodes->store),
      mVisible(std::make_unique<VisibleObjects>()),
      mBatches(std::make_unique<CasterBatches>()) {
    setStore(*this, mStore);
}

LixelSceneManager::~LixelSceneManager() {
    setStore(*this, nullptr);
}

void LixelSceneManager::setChangesAnnounced(bool announced) {
    mStore->setChangesAnnounced(announced);
}

bool LixelSceneManager::getChangesAnnounced() const {
    return mStore->areChangesAnnounced();
}

void LixelSceneManager::announceChange() {
    mStore->announceChange();
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
    return new LixelSceneNode(*this, mNodes);
}

Ogre::SceneNode* LixelSceneManager::createSceneNodeImpl(const Ogre::String& name) {
    return new LixelSceneNode(*this, name, mNodes);
}

void LixelSceneManager::_updateSceneGraph(Ogre::Camera* camera) {
    mNodes->moved.setRoot(static_cast<const LixelSceneNode*>(getRootSceneNode()));
    SceneManager::_updateSceneGraph(camera);
    mStore->tighten();
}

void LixelSceneManager::_findVisibleObjects(Ogre::Camera* camera,
                                            Ogre::VisibleObjectsBoundsInfo* visibleBounds,
                                            bool onlyShadowCasters) {
    mVisible->find(*mStore, *camera);
    CasterBatches* const batches = mUsesBatches && !mProves && onlyShadowCasters &&
                                           mBatches->begin(*this, *camera, *getRenderQueue())
                                       ? mBatches.get()
                                       : nullptr;
    const LayerPart part = mPart != nullptr ? *mPart : LayerPart();
    mVisible->queue(*this, *camera, visibleBounds, onlyShadowCasters, batches, part);
    if (batches != nullptr) batches->queue();
    // Materials may ask for the depths of all that is in the map.
    if (part.layer != nullptr && !part.isStill && visibleBounds != nullptr)
        widen(*visibleBounds, part.layer->seen());
}

void LixelSceneManager::_renderScene(Ogre::Camera* camera, Ogre::Viewport* viewport,
                                     bool includeOverlays) {
    const CurrentManagerKept kept;
    if (_getCurrentRenderStage() != IRS_RENDER_TO_TEXTURE) {
        SceneManager::_renderScene(camera, viewport, includeOverlays);
        return;
    }
    std::optional<NearestDepth> nearest;
    if (storesDepthAsColour(*this, *viewport->getTarget())) nearest.emplace(*this);
    MapShortcuts shortcuts;
    shortcuts.layers = nearest && drawLayers(*camera, *viewport, includeOverlays, *nearest);
    if (!shortcuts.layers) SceneManager::_renderScene(camera, viewport, includeOverlays);
    shortcuts.batches = mBatches->takeCount() > 0;
    if (shortcuts.any() && isProofMode()) prove(*camera, *viewport, includeOverlays, shortcuts);
}

/*  1. Draw what stands still into the map, and copy it into the layer; or copy it from there.
    2. Draw what moves over it. */
bool LixelSceneManager::drawLayers(Ogre::Camera& camera, Ogre::Viewport& viewport,
                                   bool includeOverlays, const NearestDepth& nearest) {
    StillLayer* const layer = layerOf(camera, *viewport.getTarget());
    if (layer == nullptr) return false;
    const Ogre::TexturePtr map = mapOf(viewport);
    if (!map || !clearsAll(viewport) || !drawsQueuesAsOgre(viewport)) {
        layer->refuse();
        return false;
    }
    if (layer->isFilledFor(camera)) {
        layer->copyTo(*map);
    } else {
        drawPart(camera, viewport, includeOverlays, {layer, true});
        if (!layer->fill(*map, camera, getVisibleObjectsBoundsInfo(&camera))) {
            layer->refuse();
            return false;
        }
    }
    {
        const WithoutClearing withoutClearing(viewport);
        drawPart(camera, viewport, includeOverlays, {layer, false});
    }
    if (!nearest.dependsOnOrder()) return true;
    layer->refuse();
    return false;
}

void LixelSceneManager::drawPart(Ogre::Camera& camera, Ogre::Viewport& viewport,
                                 bool includeOverlays, const LayerPart& part) {
    mPart = &part;
    try {
        SceneManager::_renderScene(&camera, &viewport, includeOverlays);
    } catch (...) {
        mPart = nullptr;
        throw;
    }
    mPart = nullptr;
}

bool LixelSceneManager::drawsQueuesAsOgre(Ogre::Viewport& viewport) {
    return drawsQueuesAsUsual(*this, viewport) &&
           getRenderQueue()->getRenderableListener() == nullptr;
}

Ogre::TexturePtr LixelSceneManager::mapOf(const Ogre::Viewport& viewport) {
    const std::vector<ShadowTarget> targets = shadowTargetsOf(*this);
    const auto drawn = std::ranges::find(targets, viewport.getTarget(), &ShadowTarget::target);
    return drawn != targets.end() ? drawn->texture : nullptr;
}

void LixelSceneManager::prove(Ogre::Camera& camera, Ogre::Viewport& viewport, bool includeOverlays,
                              const MapShortcuts& shortcuts) {
    const Ogre::TexturePtr map = mapOf(viewport);
    if (!map) return;
    const std::vector<std::uint8_t> before = readTexels(*map);
    mProves = true;
    try {
        SceneManager::_renderScene(&camera, &viewport, includeOverlays);
    } catch (...) {
        mProves = false;
        throw;
    }
    mProves = false;
    proveMapDrawnBy(shortcuts, *map, before);
}

Ogre::SceneManager* LixelSceneManagerFactory::createInstance(const Ogre::String& name) {
    return new LixelSceneManager(name);
}

void LixelSceneManagerFactory::destroyInstance(Ogre::SceneManager* instance) {
    delete instance;
}

} // namespace Lixel
