#include "material/ShadowParameters.h"

#include "material/MaterialCheck.h"
#include "material/NoMapsCheck.h"
#include "material/ReceiverParameters.h"
#include "material/SharedParameters.h"
#include "material/SurfaceReceivers.h"
#include "scene/PerScene.h"

#include <OgreCamera.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreLight.h>
#include <OgreRenderTexture.h>
#include <OgreSceneManager.h>
#include <OgreTexture.h>
#include <OgreViewport.h>

#include <cmath>
#include <set>

namespace Lixel {
namespace {

/// The texture that a shadow camera draws; null where it is none of the scene manager's.
Ogre::TexturePtr textureOf(const Ogre::Camera& shadowCamera, Ogre::SceneManager& manager) {
    for (const ShadowTarget& map : shadowTargetsOf(manager))
        if (map.target == shadowCamera.getViewport()->getTarget()) return map.texture;
    return {};
}

bool hasReceiverPasses(const Ogre::SceneManager& manager) {
    return manager.isShadowTechniqueTextureBased() && !manager.isShadowTechniqueIntegrated();
}

} // namespace

/// Lets a scene manager's lights shadow nothing before each view, then binds each fitted map.
class ShadowParameters::SceneListener : public SceneManagerListener {
public:
    explicit SceneListener(Ogre::SceneManager& manager)
        : mManager(manager), mSurfaceReceivers(manager), mCheck(manager), mNoMapsCheck(manager) {}
    ~SceneListener() override {
        if (mListensToObjects) mManager.removeRenderObjectListener(&mSurfaceReceivers);
    }
    SceneListener(const SceneListener&) = delete;
    SceneListener& operator=(const SceneListener&) = delete;

    void preUpdateSceneGraph(Ogre::SceneManager* source, Ogre::Camera*) override {
        if (source->_getCurrentRenderStage() == Ogre::SceneManager::IRS_RENDER_TO_TEXTURE) return;
        letAllBeLit();
        SharedParameters::setFog(*source);
        mHasMaps = false;
        mCheck.endView();
    }

    /// A program keeps the last light's value of a custom parameter that the next light lacks, so
    /// every light gets one, which says "lit", before maps are fitted.
    void letAllBeLit() {
        mMaps.clear();
        mSplits.clear();
        mSurfaceReceivers.clear();
        for (const auto& [name, object] : mManager.getMovableObjects(LightTypeName))
            bindNoMaps(static_cast<Ogre::Light&>(*object));
    }

    void bind(const ShadowMap& map) {
        if (!mHasMaps) mCheck.beginView(map.shadowCamera.getViewport()->getMaterialScheme());
        mHasMaps = true;
        mNoMapsCheck.mapFitted();
        const ReceiverParameters parameters = receiverParameters(map);
        bindMap(map.light, map.iteration, parameters);
        bindSplit(map);
        const Ogre::TexturePtr texture = textureOf(map.shadowCamera, mManager);
        if (texture) mCheck.checkMap(*texture, map);
        // Receiver passes see one map a light.
        if (map.iteration != 0) return;
        mMaps[&map.light] = parameters;
        listenToObjects(hasReceiverPasses(mManager));
        if (mListensToObjects && texture) mSurfaceReceivers.setMap(map.light, texture);
    }

    void postFindVisibleObjects(Ogre::SceneManager*,
                                Ogre::SceneManager::IlluminationRenderStage stage,
                                Ogre::Viewport* viewport) override {
        mCheck.dropUnusable();
        if (stage != Ogre::SceneManager::IRS_NONE) return;
        if (!mHasMaps) return mNoMapsCheck.checkQueue(*viewport);
        if (!mCheck.looks()) return;
        std::set<const Ogre::Light*> withMaps;
        for (const auto& [light, parameters] : mMaps)
            withMaps.insert(light);
        mCheck.checkQueue(withMaps);
    }

    void shadowTextureReceiverPreViewProj(Ogre::Light* light, Ogre::Frustum*) override {
        mSurfaceReceivers.setModulativeLight(light);
        const auto found = mMaps.find(light);
        SharedParameters::setModulativeReceiver(
            found != mMaps.end() ? found->second : litParameters(), light->getAs4DVector(true));
    }

private:
    /// Where the map's slice ends, beside those of the maps before it.
    void bindSplit(const ShadowMap& map) {
        Ogre::Vector4& depths =
            mSplits.try_emplace(&map.light, EndlessDepth, EndlessDepth, EndlessDepth, EndlessDepth)
                .first->second;
        if (map.iteration < 4 && std::isfinite(map.part.vsEnd))
            depths[map.iteration] = static_cast<Ogre::Real>(map.part.vsEnd);
        map.light.setCustomParameter(LP_SPLIT_DEPTHS, depths);
    }

    /// It is asked for every object that is drawn: only where there are receiver passes.
    void listenToObjects(bool listen) {
        if (listen == mListensToObjects) return;
        mListensToObjects = listen;
        if (listen)
            mManager.addRenderObjectListener(&mSurfaceReceivers);
        else
            mManager.removeRenderObjectListener(&mSurfaceReceivers);
    }

    Ogre::SceneManager& mManager;
    std::map<const Ogre::Light*, ReceiverParameters> mMaps;
    std::map<const Ogre::Light*, Ogre::Vector4> mSplits;
    SurfaceReceivers mSurfaceReceivers;
    MaterialCheck mCheck;
    NoMapsCheck mNoMapsCheck;
    /// Whether a map was fitted for the camera that is being drawn.
    bool mHasMaps = false;
    bool mListensToObjects = false;
};

class ShadowParameters::Scenes : public PerScene<SceneListener> {};

ShadowParameters::ShadowParameters()
    : mShared(std::make_unique<SharedParameters>()), mScenes(std::make_unique<Scenes>()) {
    addShadowMapObserver(*this);
}

ShadowParameters::~ShadowParameters() = default;

ShadowParameters::SceneListener& ShadowParameters::listenerOf(Ogre::SceneManager& manager) {
    const auto [listener, isNew] = mScenes->of(manager, manager);
    // Too late for this frame's beginning.
    if (isNew) {
        listener.letAllBeLit();
        SharedParameters::setFog(manager);
    }
    return listener;
}

void ShadowParameters::serve(Ogre::SceneManager& manager) {
    listenerOf(manager);
}

void ShadowParameters::shadowMapFitted(const ShadowMap& map) {
    listenerOf(map.sceneManager).bind(map);
    SharedParameters::setCasterDepth(map.fit);
    map.light.setCustomParameter(LP_CASTER_DEPTH,
                                 Ogre::Vector4(static_cast<Ogre::Real>(map.fit.depthScale),
                                               static_cast<Ogre::Real>(map.fit.depthOffset), 0, 0));
}

} // namespace Lixel
