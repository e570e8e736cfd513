// Ribbon trails, whose bounds grow while OGRE updates the scene graph.
#include "ManagerOgre.h"
#include "Managers.h"
#include "Materials.h"
#include "World.h"

#include <OgreFrameListener.h>
#include <OgreRibbonTrail.h>
#include <OgreRoot.h>

#include <gtest/gtest.h>

namespace Lixel::Tests {
namespace {

/// A trail that follows a moving node, both under the root, which OGRE updates in that order, and
/// the whole graph each time: otherwise it goes by the addresses of nodes.
std::vector<FrameRecord> followNode(const std::string& managerType) {
    Ogre::Root& root = ogreWithManagers().root();
    materials();
    World world(root, managerType, managerType + " with a trail");
    Ogre::SceneNode* leader = world.rootNode().createChildSceneNode();
    world.add(*leader, "leader");
    Ogre::SceneNode* holder = world.rootNode().createChildSceneNode();
    world.add(*holder, "holder");
    Ogre::RibbonTrail* trail = world.manager().createRibbonTrail("trail");
    world.add(*trail, "trail");
    trail->setMaterialName("transparent", Ogre::RGN_DEFAULT);
    trail->setMaxChainElements(10);
    trail->setTrailLength(20);
    trail->setInitialWidth(0, 0.5f);
    holder->attachObject(trail);
    trail->addNode(leader);
    std::vector<FrameRecord> records;
    for (int frame = 0; frame < 40; ++frame) {
        // Out of sight, through it, and out on the other side.
        leader->setPosition(static_cast<float>(2 * frame - 40), 0, 0);
        world.rootNode().needUpdate();
        Ogre::FrameEvent event{0.1f, 0.1f};
        root._fireFrameStarted(event);
        world.draw();
        root._fireFrameRenderingQueued(event);
        root._fireFrameEnded(event);
        records.push_back(world.takeRecord());
    }
    return records;
}

TEST(RibbonTrail, IsShownWhereItIs) {
    const std::vector<FrameRecord> expected = followNode(referenceOf(candidate().rule));
    const std::vector<FrameRecord> actual = followNode(candidate().manager);
    std::size_t shown = 0;
    std::size_t all = 0;
    for (std::size_t frame = 0; frame < expected.size(); ++frame) {
        const std::vector<Sight>& sights = expected[frame].sights;
        ASSERT_EQ(sights.size(), actual[frame].sights.size());
        for (std::size_t i = 0; i < sights.size(); ++i) {
            EXPECT_EQ(difference(sights[i], actual[frame].sights[i]), "") << "frame " << frame;
            shown += sights[i].queued.size();
            ++all;
        }
        EXPECT_EQ(difference(expected[frame].heard, actual[frame].heard), "") << "frame " << frame;
    }
    EXPECT_GT(shown, all / 10);
    EXPECT_LT(shown, all * 9 / 10);
}

} // namespace
} // namespace Lixel::Tests
