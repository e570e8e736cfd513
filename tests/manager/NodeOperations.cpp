// Moving nodes, and what else they have of their own.
#include "Operation.h"

namespace Lixel::Tests {
namespace {

std::string moveNode(World& world, Random& random) {
    NodeEntry* node = anyInnerNode(world, random);
    if (node == nullptr) return "";
    const Ogre::Vector3 place = anyPlace(random, random.oneIn(4) ? 40.0f : 8.0f);
    node->node->setPosition(place);
    return of("position", node->name) + " " + say(place);
}

std::string translateNode(World& world, Random& random) {
    NodeEntry* node = anyInnerNode(world, random);
    if (node == nullptr) return "";
    const Ogre::Vector3 step = anyPlace(random, 3);
    node->node->translate(
        step, random.of({Ogre::Node::TS_LOCAL, Ogre::Node::TS_PARENT, Ogre::Node::TS_WORLD}));
    return "translate " + node->name;
}

std::string rotateNode(World& world, Random& random) {
    NodeEntry* node = anyInnerNode(world, random);
    if (node == nullptr) return "";
    node->node->setOrientation(anyTurn(random));
    return "turn " + node->name;
}

std::string scaleNode(World& world, Random& random) {
    NodeEntry* node = anyInnerNode(world, random);
    if (node == nullptr) return "";
    const auto side = [&] { return random.of({-2.0f, -1.0f, 0.3f, 0.5f, 1.0f, 1.0f, 1.5f}); };
    const Ogre::Vector3 scale(side(), side(), side());
    node->node->setScale(scale);
    return of("scale", node->name) + " " + say(scale);
}

std::string setInheritance(World& world, Random& random) {
    NodeEntry* node = anyInnerNode(world, random);
    if (node == nullptr) return "";
    node->node->setInheritScale(random.oneIn(2));
    node->node->setInheritOrientation(random.oneIn(2));
    return "inheritance of " + node->name;
}

std::string useInitialState(World& world, Random& random) {
    NodeEntry* node = anyInnerNode(world, random);
    if (node == nullptr) return "";
    if (random.oneIn(2)) {
        node->node->setInitialState();
        return "keep the state of " + node->name;
    }
    node->node->resetToInitialState();
    return "reset " + node->name;
}

std::string fixYaw(World& world, Random& random) {
    NodeEntry* node = anyInnerNode(world, random);
    if (node == nullptr) return "";
    node->node->setFixedYawAxis(random.oneIn(2), anyPlace(random, 1).normalisedCopy());
    node->node->yaw(Ogre::Degree(random.between(0, 90)));
    node->node->lookAt(anyPlace(random, 10), Ogre::Node::TS_WORLD);
    return "yaw of " + node->name;
}

/// One at a time: OGRE turns trackers in the order of their addresses, and each sees what those
/// before it have turned.
std::string trackNode(World& world, Random& random) {
    NodeEntry* node = anyInnerNode(world, random);
    if (node == nullptr) return "";
    NodeEntry& target = anyNode(world, random);
    if (world.tracker != nullptr) world.tracker->setAutoTracking(false);
    world.tracker = target.node == node->node ? nullptr : node->node;
    if (world.tracker == nullptr) return "track nothing";
    node->node->setAutoTracking(true, target.node, Ogre::Vector3::NEGATIVE_UNIT_Z,
                                Ogre::Vector3(0, 1, 0));
    return node->name + " tracks " + target.name;
}

std::string showNode(World& world, Random& random) {
    NodeEntry& node = anyNode(world, random);
    const bool cascades = random.oneIn(2);
    if (random.oneIn(4)) {
        node.node->flipVisibility(cascades);
        return "flip visibility of " + node.name;
    }
    const bool shows = !random.oneIn(3);
    node.node->setVisible(shows, cascades);
    return (shows ? "show " : "hide ") + node.name + (cascades ? " and all below" : "");
}

std::string listenToNode(World& world, Random& random) {
    NodeEntry* node = anyInnerNode(world, random);
    if (node == nullptr) return "";
    node->node->setListener(random.oneIn(3) ? nullptr : &world.heard);
    return "listen to " + node->name;
}

std::string updateNode(World& world, Random& random) {
    NodeEntry& node = anyNode(world, random);
    switch (random.below(3)) {
    case 0:
        node.node->needUpdate(random.oneIn(2));
        return node.name + " needs update";
    case 1:
        Ogre::Node::queueNeedUpdate(node.node);
        return "queue update of " + node.name;
    default:
        return node.name + " is at " + say(node.node->_getDerivedPosition()) + " scaled " +
               say(node.node->_getDerivedScale());
    }
}

std::string drawNodesBox(World& world, Random& random) {
    NodeEntry& node = anyNode(world, random);
    if (world.hasInfinite) return "";
    node.node->showBoundingBox(random.oneIn(2));
    world.drawsBoxes = true;
    return "box of " + node.name;
}

} // namespace

void addNodeOperations(Operations& all) {
    all.insert(all.end(), {{"move a node", 12, moveNode},
                           {"translate a node", 4, translateNode},
                           {"turn a node", 6, rotateNode},
                           {"scale a node", 6, scaleNode},
                           {"set what a node inherits", 3, setInheritance},
                           {"use a node's initial state", 2, useInitialState},
                           {"fix a node's yaw", 3, fixYaw},
                           {"track a node", 3, trackNode},
                           {"show a node", 6, showNode},
                           {"listen to a node", 4, listenToNode},
                           {"ask for an update", 3, updateNode},
                           {"draw a node's box", 2, drawNodesBox}});
}

} // namespace Lixel::Tests
