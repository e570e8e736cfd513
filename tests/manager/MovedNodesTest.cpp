// Nodes that move, go and come back before the scene graph is updated, and while it is.
#include "ManagerOgre.h"
#include "Managers.h"
#include "Meshes.h"
#include "World.h"

#include <OgreEntity.h>

#include <gtest/gtest.h>

#include <functional>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;

/// Does what it is told when its node is updated.
class OnUpdate : public Ogre::Node::Listener {
public:
    explicit OnUpdate(std::function<void()> deed) : mDeed(std::move(deed)) {}
    void nodeUpdated(const Ogre::Node* /*node*/) override { mDeed(); }

private:
    std::function<void()> mDeed;
};

class MovedNodes : public testing::TestWithParam<std::string> {
protected:
    Ogre::SceneNode* nodeBelow(Ogre::SceneNode& parent, const Vector3& place = Vector3::ZERO) {
        Ogre::SceneNode* const node = parent.createChildSceneNode(place);
        node->attachObject(world.manager().createEntity(meshes(world.manager()).front()));
        return node;
    }
    static Vector3 boxOf(const Ogre::SceneNode& node) { return node._getWorldAABB().getCenter(); }

    World world{ogreWithManagers().root(), GetParam(), "moved nodes of " + GetParam()};
    Ogre::SceneNode& root = world.rootNode();
};

INSTANTIATE_TEST_SUITE_P(Manager, MovedNodes, testing::Values(DefaultManager, candidate().manager),
                         [](const auto& test) { return test.param; });

TEST_P(MovedNodes, AreUpdatedByWhoeverUpdatesTheRoot) {
    Ogre::SceneNode* const node = nodeBelow(root);
    world.draw();
    const Vector3 before = boxOf(*node);
    node->setPosition(7, 0, 0);
    root._update(true, false);
    EXPECT_EQ(boxOf(*node), before + Vector3(7, 0, 0));
}

TEST_P(MovedNodes, HaveTheirChildrenUpdatedThoughTheyWereByThemselvesBefore) {
    Ogre::SceneNode* const node = nodeBelow(root);
    Ogre::SceneNode* const child = nodeBelow(*node);
    world.draw();
    const Vector3 before = boxOf(*child);
    node->setPosition(7, 0, 0);
    node->_update(false, false);
    world.draw();
    EXPECT_EQ(boxOf(*child), before + Vector3(7, 0, 0));
}

TEST_P(MovedNodes, GoBelowAnotherNode) {
    Ogre::SceneNode* const other = nodeBelow(root, Vector3(0, 5, 0));
    Ogre::SceneNode* const node = nodeBelow(root);
    world.draw();
    const Vector3 before = boxOf(*node);
    node->setPosition(7, 0, 0);
    root.removeChild(node);
    other->addChild(node);
    world.draw();
    EXPECT_EQ(boxOf(*node), before + Vector3(7, 5, 0));
    node->setPosition(8, 0, 0);
    world.draw();
    EXPECT_EQ(boxOf(*node), before + Vector3(8, 5, 0));
}

TEST_P(MovedNodes, GoAndComeBack) {
    Ogre::SceneNode* const node = nodeBelow(root);
    world.draw();
    const Vector3 before = boxOf(*node);
    node->setPosition(7, 0, 0);
    root.removeChild(node);
    world.draw();
    node->setPosition(9, 0, 0);
    root.addChild(node);
    world.draw();
    EXPECT_EQ(boxOf(*node), before + Vector3(9, 0, 0));
}

TEST_P(MovedNodes, AreDestroyedBeforeTheUpdate) {
    Ogre::SceneNode* const first = nodeBelow(root);
    Ogre::SceneNode* const last = nodeBelow(root);
    world.draw();
    const Vector3 before = boxOf(*last);
    first->setPosition(7, 0, 0);
    last->setPosition(7, 0, 0);
    world.manager().destroySceneNode(first);
    world.draw();
    EXPECT_EQ(boxOf(*last), before + Vector3(7, 0, 0));
}

TEST_P(MovedNodes, AreDestroyedByAnotherNodesListener) {
    Ogre::SceneNode* const first = nodeBelow(root);
    Ogre::SceneNode* last = nodeBelow(root);
    world.draw();
    OnUpdate onUpdate([&] {
        if (last != nullptr) world.manager().destroySceneNode(std::exchange(last, nullptr));
    });
    first->setListener(&onUpdate);
    first->setPosition(1, 0, 0);
    last->setPosition(1, 0, 0);
    world.draw();
    EXPECT_EQ(last, nullptr);
    first->setListener(nullptr);
}

// OGRE's own lose nodes that are moved after their turn in an update: from then on they stay where
// they were.
class MovedNodesOfLixel : public MovedNodes {};

INSTANTIATE_TEST_SUITE_P(Manager, MovedNodesOfLixel, testing::Values(candidate().manager),
                         [](const auto& test) { return test.param; });

TEST_P(MovedNodesOfLixel, MayBeMovedOnByAnotherNodesListener) {
    Ogre::SceneNode* const first = nodeBelow(root);
    Ogre::SceneNode* const last = nodeBelow(root);
    world.draw();
    const Vector3 before = boxOf(*first);
    OnUpdate onUpdate([&] { first->setPosition(3, 0, 0); });
    last->setListener(&onUpdate);
    first->setPosition(7, 0, 0);
    last->setPosition(7, 0, 0);
    root._update(true, false);
    EXPECT_EQ(boxOf(*first), before + Vector3(7, 0, 0)) << "it has had its turn";
    last->setListener(nullptr);
    root._update(true, false);
    EXPECT_EQ(boxOf(*first), before + Vector3(3, 0, 0));
}

TEST_P(MovedNodesOfLixel, MayMoveThemselvesWhileTheyAreUpdated) {
    Ogre::SceneNode* const node = nodeBelow(root);
    world.draw();
    const Vector3 before = boxOf(*node);
    float place = 0;
    OnUpdate onUpdate([&] { node->setPosition(++place, 0, 0); });
    node->setListener(&onUpdate);
    node->needUpdate();
    world.draw();
    node->setListener(nullptr);
    world.draw();
    EXPECT_EQ(boxOf(*node), before + Vector3(place, 0, 0));
    node->setPosition(20, 0, 0);
    world.draw();
    EXPECT_EQ(boxOf(*node), before + Vector3(20, 0, 0));
}

} // namespace
} // namespace Lixel::Tests
