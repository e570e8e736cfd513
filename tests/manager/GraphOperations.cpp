// Nodes that come, go, and change places.
#include "Operation.h"

#include <functional>

namespace Lixel::Tests {
namespace {

/// Deeper ones would grow out of all bounds by their scales.
constexpr int DeepestNode = 5;
constexpr std::size_t MostNodes = 40;

int depthOf(const Ogre::Node* node) {
    int depth = 0;
    for (; node != nullptr; node = node->getParent())
        ++depth;
    return depth;
}

int heightOf(const Ogre::Node& node) {
    int height = 0;
    for (const Ogre::Node* child : node.getChildren())
        height = std::max(height, heightOf(*child));
    return height + 1;
}

bool canHang(const Ogre::Node& node, const Ogre::Node& parent) {
    for (const Ogre::Node* above = &parent; above != nullptr; above = above->getParent())
        if (above == &node) return false;
    return depthOf(&parent) + heightOf(node) <= DeepestNode;
}

std::string createNode(World& world, Random& random) {
    if (world.nodes.size() >= MostNodes) return "";
    const NodeEntry parent = random.oneIn(3) ? world.nodes[0] : anyNode(world, random);
    if (depthOf(parent.node) >= DeepestNode) return "";
    const std::string name = world.newName("node");
    Ogre::SceneNode* node = nullptr;
    switch (random.below(4)) {
    case 0: // hangs nowhere yet
        node = world.manager().createSceneNode(name);
        break;
    case 1:
        node = world.manager().createSceneNode();
        parent.node->addChild(node);
        break;
    case 2:
        node = parent.node->createChildSceneNode(name);
        break;
    default:
        node = parent.node->createChildSceneNode(anyPlace(random, 6), anyTurn(random));
    }
    world.add(*node, name);
    if (random.oneIn(3)) node->setListener(&world.heard);
    return "create " + name + " under " + parent.name;
}

std::string destroyNode(World& world, Random& random) {
    NodeEntry* entry = anyInnerNode(world, random);
    if (entry == nullptr) return "";
    const NodeEntry node = *entry;
    Ogre::SceneNode* parent = node.node->getParentSceneNode();
    switch (parent == nullptr ? 0 : random.below(4)) {
    case 0:
        world.forget(*node.node);
        // Its children hang nowhere then.
        world.manager().destroySceneNode(node.node);
        return "destroy " + node.name;
    case 1:
        if (node.node->getName().empty()) return "";
        world.forget(*node.node);
        world.manager().destroySceneNode(node.node->getName());
        return "destroy by name " + node.name;
    case 2:
        world.forgetTree(*node.node);
        parent->removeAndDestroyChild(node.node);
        return "destroy the tree " + node.name;
    default:
        for (const Ogre::Node* child : node.node->getChildren())
            world.forgetTree(static_cast<const Ogre::SceneNode&>(*child));
        node.node->removeAndDestroyAllChildren();
        return "destroy all below " + node.name;
    }
}

std::string takeNodeOut(World& world, Random& random) {
    NodeEntry* node = anyInnerNode(world, random);
    if (node == nullptr || node->node->getParent() == nullptr) return "";
    Ogre::SceneNode* parent = node->node->getParentSceneNode();
    if (random.oneIn(6) && parent != &world.rootNode()) {
        parent->removeAllChildren();
        return "take all out beside " + node->name;
    }
    parent->removeChild(node->node);
    return "take out " + node->name;
}

std::string hangNode(World& world, Random& random) {
    std::vector<NodeEntry> orphans;
    for (const NodeEntry& entry : world.nodes)
        if (entry.node->getParent() == nullptr && entry.node != &world.rootNode())
            orphans.push_back(entry);
    const NodeEntry* node = anyOf(orphans, random);
    if (node == nullptr) return "";
    const NodeEntry& parent = random.oneIn(3) ? anyNode(world, random) : world.nodes[0];
    if (!canHang(*node->node, *parent.node)) return "";
    parent.node->addChild(node->node);
    return "hang " + node->name + " under " + parent.name;
}

std::string reparentNode(World& world, Random& random) {
    NodeEntry* node = anyInnerNode(world, random);
    NodeEntry& parent = anyNode(world, random);
    if (node == nullptr || !canHang(*node->node, *parent.node)) return "";
    if (Ogre::SceneNode* former = node->node->getParentSceneNode()) former->removeChild(node->node);
    parent.node->addChild(node->node);
    return "hang " + node->name + " under " + parent.name + " instead";
}

} // namespace

void addGraphOperations(Operations& all) {
    all.insert(all.end(), {{"create a node", 16, createNode},
                           {"destroy nodes", 6, destroyNode},
                           {"take a node out", 5, takeNodeOut},
                           {"hang a node", 10, hangNode},
                           {"reparent a node", 6, reparentNode}});
}

} // namespace Lixel::Tests
