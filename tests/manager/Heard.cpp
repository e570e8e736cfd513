#include "Heard.h"

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreLight.h>
#include <OgreMaterial.h>
#include <OgreSubEntity.h>
#include <OgreTechnique.h>
#include <OgreViewport.h>

#include <fmt/format.h>

#include <utility>

namespace Lixel::Tests {

std::string Names::of(const Ogre::Node& node) const {
    const auto found = mNodes.find(&node);
    return found != mNodes.end() ? found->second : "OGRE's node " + node.getName();
}

std::string Names::of(const Ogre::MovableObject& object) const {
    const auto found = mObjects.find(&object);
    return found != mObjects.end() ? found->second : "OGRE's object " + object.getName();
}

std::map<std::string, int> Heard::take() {
    return std::exchange(mHeard, {});
}

void Heard::nodeUpdated(const Ogre::Node* node) {
    hear("nodeUpdated " + mNames.of(*node));
}

void Heard::nodeDestroyed(const Ogre::Node* node) {
    hear("nodeDestroyed " + mNames.of(*node));
}

void Heard::nodeAttached(const Ogre::Node* node) {
    hear("nodeAttached " + mNames.of(*node));
}

void Heard::nodeDetached(const Ogre::Node* node) {
    hear("nodeDetached " + mNames.of(*node));
}

void Heard::objectDestroyed(Ogre::MovableObject* object) {
    hear("objectDestroyed " + mNames.of(*object));
}

void Heard::objectAttached(Ogre::MovableObject* object) {
    hear("objectAttached " + mNames.of(*object));
}

void Heard::objectDetached(Ogre::MovableObject* object) {
    hear("objectDetached " + mNames.of(*object));
}

void Heard::objectMoved(Ogre::MovableObject* object) {
    hear("objectMoved " + mNames.of(*object));
}

bool Heard::objectRendering(const Ogre::MovableObject* object, const Ogre::Camera* camera) {
    const std::string name = mNames.of(*object);
    const std::string viewer = mNames.of(*camera);
    hear("objectRendering " + name + " by " + viewer);
    return (name.back() + viewer.back()) % 5 != 0;
}

const Ogre::LightList* Heard::objectQueryLights(const Ogre::MovableObject* object) {
    const std::string name = mNames.of(*object);
    hear("objectQueryLights " + name);
    return name.back() % 3 == 0 ? &mNoLights : nullptr;
}

void Heard::preUpdateSceneGraph(Ogre::SceneManager*, Ogre::Camera* camera) {
    hear("preUpdateSceneGraph " + mNames.of(*camera));
}

void Heard::postUpdateSceneGraph(Ogre::SceneManager*, Ogre::Camera* camera) {
    hear("postUpdateSceneGraph " + mNames.of(*camera));
}

void Heard::preFindVisibleObjects(Ogre::SceneManager*,
                                  Ogre::SceneManager::IlluminationRenderStage stage,
                                  Ogre::Viewport* viewport) {
    hear(fmt::format("preFindVisibleObjects {} {}", static_cast<int>(stage),
                     mNames.of(*viewport->getCamera())));
}

void Heard::postFindVisibleObjects(Ogre::SceneManager*,
                                   Ogre::SceneManager::IlluminationRenderStage stage,
                                   Ogre::Viewport* viewport) {
    hear(fmt::format("postFindVisibleObjects {} {}", static_cast<int>(stage),
                     mNames.of(*viewport->getCamera())));
}

void Heard::shadowTexturesUpdated(std::size_t count) {
    hear(fmt::format("shadowTexturesUpdated {}", count));
}

void Heard::shadowTextureCasterPreViewProj(Ogre::Light* light, Ogre::Camera* camera,
                                           std::size_t iteration) {
    hear(fmt::format("shadowTextureCasterPreViewProj {} {} {}", mNames.of(*light),
                     mNames.of(*camera), iteration));
}

bool Heard::prequeueMovableObjectLodChanged(const Ogre::MovableObjectLodChangedEvent& event) {
    hear("prequeueMovableObjectLodChanged " + mNames.of(*event.movableObject) + " by " +
         mNames.of(*event.camera));
    return mNames.of(*event.movableObject).back() % 2 == 0;
}

bool Heard::prequeueEntityMeshLodChanged(Ogre::EntityMeshLodChangedEvent& event) {
    hear(fmt::format("prequeueEntityMeshLodChanged {} by {} at {:a}: {} {}",
                     mNames.of(*event.entity), mNames.of(*event.camera), event.lodValue,
                     event.previousLodIndex, event.newLodIndex));
    return false;
}

bool Heard::prequeueEntityMaterialLodChanged(Ogre::EntityMaterialLodChangedEvent& event) {
    hear(fmt::format("prequeueEntityMaterialLodChanged {} by {} at {:a}: {} {}",
                     mNames.of(*event.subEntity->getParent()), mNames.of(*event.camera),
                     event.lodValue, event.previousLodIndex, event.newLodIndex));
    return false;
}

void Heard::postqueueMovableObjectLodChanged(const Ogre::MovableObjectLodChangedEvent& event) {
    hear("postqueueMovableObjectLodChanged " + mNames.of(*event.movableObject) + " by " +
         mNames.of(*event.camera));
}

bool Heard::renderableQueued(Ogre::Renderable*, Ogre::uint8 group, Ogre::ushort priority,
                             Ogre::Technique** technique, Ogre::RenderQueue*) {
    hear(fmt::format("renderableQueued {} {} {}", group, priority,
                     (*technique)->getParent()->getName()));
    // Which one it is, is compared with the queue.
    return priority != 77;
}

void Heard::preRenderQueues() {
    hear("preRenderQueues");
}

void Heard::postRenderQueues() {
    hear("postRenderQueues");
}

void Heard::renderQueueStarted(Ogre::uint8 group, const Ogre::String& invocation, bool&) {
    hear(fmt::format("renderQueueStarted {} {}", group, invocation));
}

} // namespace Lixel::Tests
