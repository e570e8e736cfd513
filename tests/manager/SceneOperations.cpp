// What is said to the scene manager as a whole.
#include "Operation.h"

#include <OgreAnimation.h>
#include <OgreAnimationState.h>
#include <OgreAnimationTrack.h>
#include <OgreKeyFrame.h>
#include <OgreRenderQueue.h>
#include <OgreRenderQueueSortingGrouping.h>

namespace Lixel::Tests {
namespace {

std::string clearAll(World& world, Random&) {
    world.forgetAll();
    world.manager().clearScene();
    return "clear the scene";
}

std::string maskScene(World& world, Random& random) {
    const auto mask = random.of<Ogre::uint32>({0xFFFFFFFF, 0xFFFFFFFF, 3, 4});
    world.manager().setVisibilityMask(mask);
    return "mask of the scene " + std::to_string(mask);
}

std::string setSky(World& world, Random& random) {
    Ogre::SceneManager& manager = world.manager();
    const bool shows = random.oneIn(2);
    switch (random.below(3)) {
    case 0:
        manager.setSkyBox(shows, "lit", 20, random.oneIn(2), Ogre::Quaternion::IDENTITY,
                          Ogre::RGN_DEFAULT);
        return shows ? "sky box" : "no sky box";
    case 1:
        manager.setSkyDome(shows, "lit", 10, 8, 20, true, Ogre::Quaternion::IDENTITY, 2, 2, -1,
                           Ogre::RGN_DEFAULT);
        return shows ? "sky dome" : "no sky dome";
    default:
        manager.setSkyPlane(shows, Ogre::Plane(Ogre::Vector3::NEGATIVE_UNIT_Y, -30), "lit", 50, 5,
                            true, 0, 1, 1, Ogre::RGN_DEFAULT);
        return shows ? "sky plane" : "no sky plane";
    }
}

std::string drawBoxes(World& world, Random& random) {
    if (world.hasInfinite) return "";
    world.drawsBoxes = true;
    world.manager().showBoundingBoxes(random.oneIn(3));
    world.manager().setDisplaySceneNodes(random.oneIn(3));
    return "boxes and axes or not";
}

std::string setShadows(World& world, Random& random) {
    Ogre::SceneManager& manager = world.manager();
    const auto technique =
        random.of({Ogre::SHADOWTYPE_NONE, Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED,
                   Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, Ogre::SHADOWTYPE_TEXTURE_MODULATIVE});
    if (technique != Ogre::SHADOWTYPE_NONE) {
        manager.setShadowTextureSettings(8, 1, Ogre::PF_FLOAT32_R);
        manager.setShadowFarDistance(25);
        manager.setShadowTextureSelfShadow(random.oneIn(2));
    }
    manager.setShadowTechnique(technique);
    return "shadows " + std::to_string(static_cast<int>(technique));
}

std::string setGroup(World& world, Random& random) {
    const Ogre::uint8 group = random.of<Ogre::uint8>({50, 52});
    world.manager().getRenderQueue()->getQueueGroup(group)->setShadowsEnabled(random.oneIn(2));
    return "shadows of queue group " + std::to_string(group);
}

std::string setDefaultGroup(World& world, Random& random) {
    Ogre::RenderQueue* queue = world.manager().getRenderQueue();
    queue->setDefaultQueueGroup(random.of<Ogre::uint8>({50, 50, 40}));
    queue->setDefaultRenderablePriority(random.of<Ogre::ushort>({100, 100, 120}));
    return "default queue group and priority";
}

std::string skipGroups(World& world, Random& random) {
    Ogre::SceneManager& manager = world.manager();
    manager.clearSpecialCaseRenderQueues();
    manager.setSpecialCaseRenderQueueMode(Ogre::SceneManager::SCRQM_EXCLUDE);
    if (random.oneIn(2)) manager.addSpecialCaseRenderQueue(random.of<Ogre::uint8>({50, 52}));
    return "special queue groups";
}

std::string listenToQueue(World& world, Random& random) {
    const bool listens = random.oneIn(2);
    world.manager().getRenderQueue()->setRenderableListener(listens ? &world.heard : nullptr);
    return listens ? "listen to the queue" : "do not listen to the queue";
}

std::string listenToLevels(World& world, Random& random) {
    if (random.oneIn(2)) {
        world.manager().addLodListener(&world.heard);
        return "listen to levels";
    }
    world.manager().removeLodListener(&world.heard);
    return "do not listen to levels";
}

std::string findOrNot(World& world, Random& random) {
    const bool finds = !random.oneIn(3);
    world.manager().setFindVisibleObjects(finds);
    return finds ? "find visible objects" : "find nothing";
}

/// All of them end when a node is destroyed: OGRE's tracks do not know.
std::string animateNode(World& world, Random& random) {
    Ogre::SceneManager& manager = world.manager();
    if (world.nodes.size() < 2) return "";
    const NodeEntry& node = world.nodes[1 + random.below(world.nodes.size() - 1)];
    if (manager.hasAnimation(node.name)) {
        Ogre::AnimationState* state = manager.getAnimationState(node.name);
        state->setEnabled(!random.oneIn(3));
        state->setTimePosition(random.between(0, 1));
        return "time of " + node.name;
    }
    Ogre::NodeAnimationTrack* track =
        manager.createAnimation(node.name, 1)->createNodeTrack(0, node.node);
    for (const float time : {0.0f, 1.0f}) {
        Ogre::TransformKeyFrame* frame = track->createNodeKeyFrame(time);
        frame->setTranslate(anyPlace(random, 5));
        frame->setRotation(anyTurn(random));
    }
    node.node->setInitialState();
    manager.createAnimationState(node.name)->setEnabled(true);
    return "animate " + node.name;
}

} // namespace

void addSceneOperations(Operations& all) {
    all.insert(all.end(), {{"clear the scene", 1, clearAll},
                           {"mask the scene", 3, maskScene},
                           {"set the sky", 3, setSky},
                           {"draw boxes", 2, drawBoxes},
                           {"set shadows", 4, setShadows},
                           {"set a queue group", 2, setGroup},
                           {"set the default queue group", 2, setDefaultGroup},
                           {"skip queue groups", 2, skipGroups},
                           {"listen to the queue", 3, listenToQueue},
                           {"listen to levels", 2, listenToLevels},
                           {"find visible objects or not", 2, findOrNot},
                           {"animate a node", 4, animateNode}});
}

} // namespace Lixel::Tests
