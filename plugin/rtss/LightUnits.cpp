#include "rtss/LightUnits.h"

#include <OgreLight.h>

namespace Lixel {

LightUnits::LightUnits(Ogre::SceneManager& manager, AllLightUnits& all)
    : mManager(manager), mAll(all), mLayout(layoutOf(manager)) {
    // This may be in the midst of its frame.
    dealOut();
}

int LightUnits::firstUnit(const Ogre::Light& light, std::size_t startLight) const {
    constexpr int None = -1;
    const auto found = mFirstTextures.find(&light);
    if (found == mFirstTextures.end()) return None;
    if (startLight == 0) return static_cast<int>(found->second);
    if (startLight >= mStarts.size() || found->second < mStarts[startLight]) return None;
    return static_cast<int>(found->second - mStarts[startLight]);
}

void LightUnits::preUpdateSceneGraph(Ogre::SceneManager* source, Ogre::Camera*) {
    if (source->_getCurrentRenderStage() == Ogre::SceneManager::IRS_RENDER_TO_TEXTURE) return;
    mLayout = layoutOf(mManager);
    mAll.update();
    mAll.beginFrame();
}

void LightUnits::postFindVisibleObjects(Ogre::SceneManager* source,
                                        Ogre::SceneManager::IlluminationRenderStage,
                                        Ogre::Viewport*) {
    if (source->_getCurrentRenderStage() != Ogre::SceneManager::IRS_RENDER_TO_TEXTURE) dealOut();
}

void LightUnits::dealOut() {
    mFirstTextures.clear();
    mStarts.clear();
    std::size_t next = 0;
    for (const Ogre::Light* light : mManager._getLightsAffectingFrustum()) {
        if (next >= mLayout.textures) return;
        if (!light->getCastShadows()) continue;
        mFirstTextures[light] = next;
        mStarts.push_back(next);
        next += mManager.getShadowTextureCountPerLightType(light->getType());
    }
}

LightUnits& AllLightUnits::watch(Ogre::SceneManager& manager) {
    const auto [scene, isNew] = mScenes.of(manager, manager, *this);
    if (isNew) update();
    return scene;
}

void AllLightUnits::update() {
    MapLayout all;
    mScenes.forEach(
        [&](Ogre::SceneManager&, const LightUnits& scene) { all = joined(all, scene.layout()); });
    mLayoutChanged |= all != mLayout;
    mLayout = all;
}

void AllLightUnits::beginFrame() {
    if (std::exchange(mLayoutChanged, false)) mChanged();
}

void AllLightUnits::clear() {
    mScenes.clear();
    mLayout = {};
}

} // namespace Lixel
