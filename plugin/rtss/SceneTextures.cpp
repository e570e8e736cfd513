#include "rtss/SceneTextures.h"

#include <OgreLight.h>

namespace Lixel {

SceneTextures::SceneTextures(Ogre::SceneManager& manager, AllSceneTextures& all)
    : mManager(manager), mAll(all), mLayout(layoutOf(manager)) {
    // This may be in the midst of its frame.
    dealOut();
}

int SceneTextures::firstUnit(const Ogre::Light& light, std::size_t startLight) const {
    constexpr int None = -1;
    const auto found = mFirstTextures.find(&light);
    if (found == mFirstTextures.end()) return None;
    if (startLight == 0) return static_cast<int>(found->second);
    if (startLight >= mStarts.size() || found->second < mStarts[startLight]) return None;
    return static_cast<int>(found->second - mStarts[startLight]);
}

void SceneTextures::preUpdateSceneGraph(Ogre::SceneManager* source, Ogre::Camera*) {
    if (source->_getCurrentRenderStage() == Ogre::SceneManager::IRS_RENDER_TO_TEXTURE) return;
    mLayout = layoutOf(mManager);
    mAll.update();
    mAll.beginFrame();
}

void SceneTextures::postFindVisibleObjects(Ogre::SceneManager* source,
                                           Ogre::SceneManager::IlluminationRenderStage,
                                           Ogre::Viewport*) {
    if (source->_getCurrentRenderStage() != Ogre::SceneManager::IRS_RENDER_TO_TEXTURE) dealOut();
}

void SceneTextures::dealOut() {
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

SceneTextures& AllSceneTextures::of(Ogre::SceneManager& manager) {
    const auto [scene, isNew] = mScenes.of(manager, manager, *this);
    if (isNew) update();
    return scene;
}

void AllSceneTextures::update() {
    MapLayout all;
    mScenes.forEach([&](Ogre::SceneManager&, const SceneTextures& scene) {
        all = joined(all, scene.layout());
    });
    mIsNew |= all != mLayout;
    mLayout = all;
}

void AllSceneTextures::beginFrame() {
    if (std::exchange(mIsNew, false)) mChanged();
}

void AllSceneTextures::clear() {
    mScenes.clear();
    mLayout = {};
}

} // namespace Lixel
