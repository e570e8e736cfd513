// Objects' listeners that change other branches of the scene graph while OGRE finds what is visible.
#include "ManagerOgre.h"
#include "Managers.h"
#include "Meshes.h"
#include "World.h"

#include <OgreEntity.h>
#include <OgreFrameListener.h>
#include <OgreMovableObject.h>

#include <gtest/gtest.h>

#include <functional>
#include <utility>

namespace Lixel::Tests {
namespace {

constexpr int NodesInBranch = 6;

/// Three branches of nodes in view, each with an object. The first of the first branch does a deed
/// when it is seen for the first time.
class Branches : public Ogre::MovableObject::Listener {
public:
    using Deed = std::function<void(Branches&)>;

    Branches(const std::string& managerType, Deed deed)
        : world(ogreWithManagers().root(), managerType, managerType + " with branches"),
          mDeed(std::move(deed)) {
        for (int branch = 0; branch < 3; ++branch) {
            branches.push_back(world.rootNode().createChildSceneNode());
            for (int i = 0; i < NodesInBranch; ++i)
                add(*branches.back(), static_cast<float>(branch), static_cast<float>(i));
        }
        world.objects.front().object->setListener(this);
    }

    Ogre::SceneNode& add(Ogre::SceneNode& parent, float x, float y) {
        Ogre::SceneNode* node = parent.createChildSceneNode(Ogre::Vector3(x, y, 0));
        Ogre::Entity* entity = world.manager().createEntity(meshes(world.manager()).front());
        world.add(*entity, world.newName("entity"));
        node->attachObject(entity);
        return *node;
    }

    /// With what is attached to it.
    void destroyChild(Ogre::SceneNode& parent, unsigned short index) {
        auto& child = static_cast<Ogre::SceneNode&>(*parent.getChild(index));
        Ogre::MovableObject* object = child.getAttachedObjects().front();
        world.forget(*object);
        world.manager().destroyMovableObject(object);
        parent.removeAndDestroyChild(index);
    }

    bool objectRendering(const Ogre::MovableObject*, const Ogre::Camera*) override {
        if (mDeed) std::exchange(mDeed, nullptr)(*this);
        return true;
    }

    /// @return what the frame of the deed and the next one show
    std::vector<FrameRecord> draw() {
        std::vector<FrameRecord> records;
        for (int frame = 0; frame < 2; ++frame) {
            Ogre::FrameEvent event{0.1f, 0.1f};
            ogreWithManagers().root()._fireFrameStarted(event);
            world.draw();
            ogreWithManagers().root()._fireFrameEnded(event);
            records.push_back(world.takeRecord());
            world.nameAll();
        }
        return records;
    }

    World world;
    std::vector<Ogre::SceneNode*> branches;

private:
    Deed mDeed;
};

/// @return how many objects all frames show
std::size_t compare(const Branches::Deed& deed) {
    const std::vector<FrameRecord> expected = Branches(referenceOf(candidate().rule), deed).draw();
    const std::vector<FrameRecord> actual = Branches(candidate().manager, deed).draw();
    std::size_t shown = 0;
    for (std::size_t frame = 0; frame < expected.size(); ++frame) {
        const std::vector<Sight>& sights = expected[frame].sights;
        EXPECT_EQ(sights.size(), actual[frame].sights.size());
        for (std::size_t i = 0; i < sights.size(); ++i) {
            EXPECT_EQ(difference(sights[i], actual[frame].sights[i]), "") << "frame " << frame;
            shown += sights[i].queued.size();
        }
    }
    return shown;
}

TEST(ListenerDeeds, DestroyNodesThatWereFound) {
    const std::size_t all = compare([](Branches&) {});
    const std::size_t rest = compare([](Branches& scene) {
        for (int i = 0; i < NodesInBranch; ++i)
            scene.destroyChild(*scene.branches[2], 0);
    });
    EXPECT_LT(rest, all);
    EXPECT_GT(rest, all / 2);
}

TEST(ListenerDeeds, PutNewNodesInTheirPlaces) {
    const std::size_t shown = compare([](Branches& scene) {
        for (int i = 0; i < NodesInBranch; ++i)
            scene.destroyChild(*scene.branches[2], 0);
        for (int i = 0; i < 3 * NodesInBranch; ++i)
            scene.add(*scene.branches[1], 1, static_cast<float>(i));
    });
    EXPECT_GT(shown, 0U);
}

TEST(ListenerDeeds, DetachAndHideWhatWasFound) {
    compare([](Branches& scene) {
        const auto child = [&](unsigned short index) {
            return static_cast<Ogre::SceneNode*>(scene.branches[2]->getChild(index));
        };
        child(0)->detachAllObjects();
        child(1)->setVisible(false);
        child(2)->translate(0, 500, 0);
    });
}

} // namespace
} // namespace Lixel::Tests
