// Sphere queries, which ask spheres that OGRE's default scene manager brings up to date late.
#include "ManagerOgre.h"
#include "Managers.h"
#include "Meshes.h"
#include "World.h"

#include <OgreEntity.h>
#include <OgreSceneQuery.h>

#include <gtest/gtest.h>

namespace Lixel::Tests {
namespace {

constexpr float Afar = 500;

/// Draws a frame in which an object is out of sight.
/// @return how many objects a sphere around it finds then
std::size_t findUnseen(const std::string& managerType) {
    World world(ogreWithManagers().root(), managerType, managerType + " with a sphere");
    Ogre::SceneManager& manager = world.manager();
    Ogre::SceneNode* node = world.rootNode().createChildSceneNode(Ogre::Vector3(Afar, 0, 0));
    node->attachObject(manager.createEntity(meshes(manager).front()));
    world.draw();
    Ogre::SphereSceneQuery* query =
        manager.createSphereQuery(Ogre::Sphere(Ogre::Vector3(Afar, 0, 0), 1));
    const std::size_t found = query->execute().movables.size();
    manager.destroyQuery(query);
    return found;
}

TEST(SphereQuery, FindsWhatNoCameraHasSeen) {
    EXPECT_EQ(findUnseen(candidate().manager), 1U);
    EXPECT_EQ(findUnseen(DefaultManager), 0U) << "then it is no difference any more";
}

} // namespace
} // namespace Lixel::Tests
