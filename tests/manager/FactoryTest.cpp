// What an application is told of the scene manager before it makes one.
#include "ManagerOgre.h"
#include "Managers.h"

#include <Lixel/manager/LixelSceneManager.h>

#include <OgreSceneManager.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <memory>

namespace Lixel::Tests {
namespace {

#if OGRE_VERSION_MAJOR < 14 // which has no metadata

TEST(SceneManagerFactory, SaysThatThereIsNoWorldGeometry) {
    ogreWithManagers();
    // In memory that is not zero by chance.
    alignas(LixelSceneManagerFactory) std::byte memory[sizeof(LixelSceneManagerFactory)];
    for (volatile std::byte& byte : memory)
        byte = std::byte{0xA5};
    auto* const factory = std::construct_at(reinterpret_cast<LixelSceneManagerFactory*>(memory));
    EXPECT_EQ(factory->getMetaData().typeName, LixelSceneManager::TypeName);
    // As memory: a bool that nobody has set may read as anything.
    std::byte supported{};
    std::memcpy(&supported, &factory->getMetaData().worldGeometrySupported, 1);
    EXPECT_EQ(supported, std::byte{0});
    std::destroy_at(factory);
}

#endif

TEST(SceneManagerFactory, MakesWhatRefusesWorldGeometry) {
    for (const std::string& type : {DefaultManager, candidate().manager}) {
        Ogre::Root& root = ogreWithManagers().root();
        Ogre::SceneManager* manager = root.createSceneManager(type);
        EXPECT_EQ(manager->getTypeName(), type);
        EXPECT_THROW(manager->setWorldGeometry("world.bsp"), Ogre::Exception) << type;
        root.destroySceneManager(manager);
    }
}

} // namespace
} // namespace Lixel::Tests
