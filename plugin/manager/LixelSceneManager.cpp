#include "manager/LixelSceneManager.h"

#include "manager/LixelSceneNode.h"

namespace Lixel {

LixelSceneManager::LixelSceneManager(const Ogre::String& name)
    : SceneManager(name), mStore(std::make_shared<NodeStore>()) {
    setStore(*this, mStore.get());
}

LixelSceneManager::~LixelSceneManager() {
    setStore(*this, nullptr);
}

const Ogre::String& LixelSceneManager::getTypeName() const {
    static const Ogre::String name = TypeName;
    return name;
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
    mVisible.queue(*this, *camera, visibleBounds, onlyShadowCasters);
}

Ogre::SceneManager* LixelSceneManagerFactory::createInstance(const Ogre::String& name) {
    return new LixelSceneManager(name);
}

void LixelSceneManagerFactory::destroyInstance(Ogre::SceneManager* instance) {
    delete instance;
}

} // namespace Lixel
