#include "World.h"

#include <OgreCamera.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreInstanceManager.h>
#include <OgreTextureManager.h>
#include <OgreViewport.h>

#include <algorithm>
#include <utility>

namespace Lixel::Tests {
namespace {

/// Of the texture that a world is drawn into, in pixels.
constexpr unsigned TextureSize = 16;

/// OGRE's list of queued updates: private since 13, but an explicit instantiation may name it.
template <auto* List>
struct QueuedUpdatesAccess {
    friend std::vector<Ogre::Node*>& queuedUpdates() { return *List; }
};
std::vector<Ogre::Node*>& queuedUpdates();
template struct QueuedUpdatesAccess<&Ogre::Node::msQueuedUpdates>;

} // namespace

World::Turn::Turn(World& world) : mWorld(world) {
    queuedUpdates().swap(world.mQueuedUpdates);
}

World::Turn::~Turn() {
    queuedUpdates().swap(mWorld.mQueuedUpdates);
}

World::World(Ogre::Root& root, const std::string& managerType, const std::string& name)
    : mRoot(root), mManager(root.createSceneManager(managerType, name)) {
    mTexture = Ogre::TextureManager::getSingleton().createManual(
        "world " + name, Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, TextureSize, TextureSize, 0,
        Ogre::PF_BYTE_RGBA, Ogre::TU_RENDERTARGET);
    mTexture->getBuffer()->getRenderTarget()->setAutoUpdated(false);
    names.give(rootNode(), "root");
    nodes.push_back({"root", &rootNode()});
    for (const auto& [left, top] :
         {std::pair{0.0f, 0.0f}, {0.5f, 0.0f}, {0.0f, 0.5f}, {0.5f, 0.5f}})
        addView(left, top);
    // Ortho, and all around: what is seen must not depend on a few viewpoints alone.
    views[1].camera->setProjectionType(Ogre::PT_ORTHOGRAPHIC);
    views[1].camera->setOrthoWindow(20, 15);
    views[2].node->setOrientation(Ogre::Quaternion(Ogre::Degree(140), Ogre::Vector3::UNIT_Y));
    views[3].node->setPosition(3, 30, 2);
    views[3].node->setOrientation(Ogre::Quaternion(Ogre::Degree(-80), Ogre::Vector3::UNIT_X));
    mManager->addRenderQueueListener(this);
    mManager->addRenderQueueListener(&heard);
    addSceneManagerListener(*mManager, heard);
}

World::~World() {
    const Turn turn(*this);
    mTexture->getBuffer()->getRenderTarget()->removeAllViewports();
    // While the listeners are there. Reference managers count on their nodes' own destruction.
    mRoot.destroySceneManager(mManager);
    Ogre::TextureManager::getSingleton().remove(mTexture);
}

void World::addView(float left, float top) {
    ViewEntry view{};
    const std::string name = "camera" + std::to_string(views.size());
    view.camera = mManager->createCamera(name);
    view.camera->setNearClipDistance(0.5f);
    view.camera->setFarClipDistance(60);
    view.camera->setAspectRatio(4.0f / 3.0f);
    names.give(*view.camera, name);
    view.viewport = mTexture->getBuffer()->getRenderTarget()->addViewport(
        view.camera, static_cast<int>(views.size()), left, top, 0.5f, 0.5f);
    view.viewport->setClearEveryFrame(false);
    view.viewport->setOverlaysEnabled(false);
    views.push_back(view);
    mendViews();
}

void World::mendViews() {
    for (ViewEntry& view : views) {
        if (!view.camera->isAttached()) {
            Ogre::SceneNode* node = rootNode().createChildSceneNode();
            node->setPosition(0, 2, 12);
            node->attachObject(view.camera);
            add(*node, newName("viewer"));
        }
        view.node = view.camera->getParentSceneNode();
        // Outside of the scene graph OGRE updates it when it is first asked, for levels of detail
        // maybe, which a scene manager may do without; and lights beside it move then.
        if (!view.node->isInSceneGraph()) view.camera->getDerivedPosition();
    }
}

void World::nameAll() {
    names.clear();
    for (const NodeEntry& entry : nodes)
        names.give(*entry.node, entry.name);
    for (const ObjectEntry& entry : objects)
        names.give(*entry.object, entry.name);
    for (const ViewEntry& view : views)
        names.give(*view.camera, view.camera->getName());
}

void World::add(Ogre::SceneNode& node, const std::string& name) {
    nodes.push_back({name, &node});
    names.give(node, name);
}

void World::add(Ogre::MovableObject& object, const std::string& name) {
    objects.push_back({name, &object});
    names.give(object, name);
}

void World::forget(const Ogre::SceneNode& node) {
    std::erase_if(nodes, [&](const NodeEntry& entry) { return entry.node == &node; });
    if (tracker == &node) tracker = nullptr;
    mManager->destroyAllAnimations();
}

void World::forget(const Ogre::MovableObject& object) {
    std::erase_if(objects, [&](const ObjectEntry& entry) { return entry.object == &object; });
}

void World::forgetTree(const Ogre::SceneNode& node) {
    for (const Ogre::Node* child : node.getChildren())
        forgetTree(static_cast<const Ogre::SceneNode&>(*child));
    forget(node);
}

void World::forgetAll() {
    nodes.erase(nodes.begin() + 1, nodes.end());
    objects.clear();
    statics.clear();
    instances.clear();
    tracker = nullptr;
    hasInfinite = false;
    hasStaticInstances = false;
}

void World::draw() {
    const Turn turn(*this);
    mTexture->getBuffer()->getRenderTarget()->update();
}

FrameRecord World::takeRecord() {
    return {std::exchange(mSights, {}), heard.take()};
}

void World::preRenderQueues() {
    RenderableNames renderables;
    for (const ObjectEntry& entry : objects)
        addRenderables(renderables, *entry.object, entry.name);
    mSights.push_back(look(*mManager, renderables, names));
}

} // namespace Lixel::Tests
