#pragma once

#include "Heard.h"
#include "Sight.h"

#include <OgreRenderTexture.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreStaticGeometry.h>
#include <OgreTexture.h>

#include <string>
#include <vector>

namespace Ogre {
class InstanceManager;
}

namespace Lixel::Tests {

struct NodeEntry {
    std::string name;
    Ogre::SceneNode* node;
};

struct ObjectEntry {
    std::string name;
    Ogre::MovableObject* object;
};

/// A view of a world: a camera, the node that carries it, and a viewport in the world's texture.
struct ViewEntry {
    Ogre::Camera* camera;
    Ogre::SceneNode* node;
    Ogre::Viewport* viewport;
};

/// What one frame has shown and told.
struct FrameRecord {
    std::vector<Sight> sights;
    std::map<std::string, int> heard;
};

/** A scene of one scene manager that operations change, beside another one that goes through the
    same. Its entries are the same in both, in the same order; what OGRE destroys on the way is
    taken off by those who have it destroyed.

    It is drawn into a texture of its own, by several cameras, without drawing anything: the render
    queue is found, sorted, looked at and skipped. */
class World : private Ogre::RenderQueueListener {
public:
    World(Ogre::Root& root, const std::string& managerType, const std::string& name);
    World(const World&) = delete;
    World& operator=(const World&) = delete;
    ~World() override;

    Ogre::SceneManager& manager() { return *mManager; }
    Ogre::SceneNode& rootNode() { return *mManager->getRootSceneNode(); }

    /// A name that nothing had before.
    std::string newName(const std::string& kind) { return kind + std::to_string(mNumber++); }

    void add(Ogre::SceneNode& node, const std::string& name);
    void add(Ogre::MovableObject& object, const std::string& name);
    /// For what is about to be destroyed.
    void forget(const Ogre::SceneNode& node);
    void forget(const Ogre::MovableObject& object);
    /// The node and all below.
    void forgetTree(const Ogre::SceneNode& node);
    /// All nodes, objects, static geometry and instances.
    void forgetAll();
    /// Gives cameras that lost their node another one.
    void mendViews();
    /// Forgets the names of what is no more: the next thing may have its address.
    void nameAll();

    /** While one lives, something happens in the world: to be made around all that OGRE is asked to
        do there. OGRE has one list of queued updates for all scene managers, which whichever is
        drawn first works off; here, each world has its own. */
    class Turn {
    public:
        explicit Turn(World& world);
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;
        ~Turn();

    private:
        World& mWorld;
    };

    /// Shows all views' cameras what they see.
    void draw();
    /// Ends what was seen and heard since the last call.
    FrameRecord takeRecord();

    std::vector<NodeEntry> nodes;
    std::vector<ObjectEntry> objects;
    std::vector<ViewEntry> views;
    std::vector<Ogre::StaticGeometry*> statics;
    std::vector<Ogre::InstanceManager*> instances;
    /// The node that tracks another.
    Ogre::SceneNode* tracker = nullptr;
    /// Camera-relative rendering and static instances throw together.
    bool isRelative = false;
    bool hasStaticInstances = false;
    /// Boxes drawn of what is infinite abort OGRE: one or the other.
    bool hasInfinite = false;
    bool drawsBoxes = false;
    Names names;
    Heard heard{names};

private:
    void preRenderQueues() override;
    void renderQueueStarted(Ogre::uint8, const Ogre::String&, bool& skip) override { skip = true; }
    void addView(float left, float top);

    Ogre::Root& mRoot;
    Ogre::SceneManager* mManager;
    Ogre::TexturePtr mTexture;
    int mNumber = 0;
    std::vector<Ogre::Node*> mQueuedUpdates;
    std::vector<Sight> mSights;
};

} // namespace Lixel::Tests
