#pragma once

#include "scene/OgreVersions.h"

#include <OgreLodListener.h>
#include <OgreMovableObject.h>
#include <OgreNode.h>
#include <OgreRenderQueue.h>
#include <OgreRenderQueueListener.h>

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace Lixel::Tests {

/// The names of a world's things: the same in both worlds, whatever their addresses.
class Names {
public:
    void give(const Ogre::Node& node, std::string name) { mNodes[&node] = std::move(name); }
    void give(const Ogre::MovableObject& object, std::string name) {
        mObjects[&object] = std::move(name);
    }
    void clear() {
        mNodes.clear();
        mObjects.clear();
    }
    /// OGRE's own name for what was given none.
    std::string of(const Ogre::Node& node) const;
    std::string of(const Ogre::MovableObject& object) const;

private:
    std::unordered_map<const Ogre::Node*, std::string> mNodes;
    std::unordered_map<const Ogre::MovableObject*, std::string> mObjects;
};

/** All of OGRE's listeners in one: what a scene manager tells is kept as text, as often as it was
    told. Not the order: OGRE updates children in that of their addresses.

    It hides some objects from some cameras (objectRendering) and has some lit by no light. */
class Heard : public Ogre::Node::Listener,
              public Ogre::MovableObject::Listener,
              public SceneManagerListener,
              public Ogre::LodListener,
              public Ogre::RenderQueue::RenderableListener,
              public Ogre::RenderQueueListener {
public:
    explicit Heard(const Names& names) : mNames(names) {}

    /// What was heard since the last call, and how often.
    std::map<std::string, int> take();

    void nodeUpdated(const Ogre::Node* node) override;
    void nodeDestroyed(const Ogre::Node* node) override;
    void nodeAttached(const Ogre::Node* node) override;
    void nodeDetached(const Ogre::Node* node) override;

    void objectDestroyed(Ogre::MovableObject* object) override;
    void objectAttached(Ogre::MovableObject* object) override;
    void objectDetached(Ogre::MovableObject* object) override;
    void objectMoved(Ogre::MovableObject* object) override;
    bool objectRendering(const Ogre::MovableObject* object, const Ogre::Camera* camera) override;
    const Ogre::LightList* objectQueryLights(const Ogre::MovableObject* object) override;

    void preUpdateSceneGraph(Ogre::SceneManager* manager, Ogre::Camera* camera) override;
    void postUpdateSceneGraph(Ogre::SceneManager* manager, Ogre::Camera* camera) override;
    void preFindVisibleObjects(Ogre::SceneManager* manager,
                               Ogre::SceneManager::IlluminationRenderStage stage,
                               Ogre::Viewport* viewport) override;
    void postFindVisibleObjects(Ogre::SceneManager* manager,
                                Ogre::SceneManager::IlluminationRenderStage stage,
                                Ogre::Viewport* viewport) override;
    void shadowTexturesUpdated(std::size_t count) override;
    void shadowTextureCasterPreViewProj(Ogre::Light* light, Ogre::Camera* camera,
                                        std::size_t iteration) override;

    bool prequeueMovableObjectLodChanged(const Ogre::MovableObjectLodChangedEvent& event) override;
    bool prequeueEntityMeshLodChanged(Ogre::EntityMeshLodChangedEvent& event) override;
    bool prequeueEntityMaterialLodChanged(Ogre::EntityMaterialLodChangedEvent& event) override;
    void postqueueMovableObjectLodChanged(const Ogre::MovableObjectLodChangedEvent& event) override;

    bool renderableQueued(Ogre::Renderable* renderable, Ogre::uint8 group, Ogre::ushort priority,
                          Ogre::Technique** technique, Ogre::RenderQueue* queue) override;

    void preRenderQueues() override;
    void postRenderQueues() override;
    void renderQueueStarted(Ogre::uint8 group, const Ogre::String& invocation, bool& skip) override;

private:
    void hear(const std::string& what) { ++mHeard[what]; }

    const Names& mNames;
    std::map<std::string, int> mHeard;
    Ogre::LightList mNoLights;
};

} // namespace Lixel::Tests
