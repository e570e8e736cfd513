// Static geometry and instances, which OGRE draws in batches of its own.
#include "Operation.h"

#include "Meshes.h"

#include <OgreEntity.h>
#include <OgreInstanceManager.h>
#include <OgreInstancedEntity.h>
#include <OgreStaticGeometry.h>

namespace Lixel::Tests {
namespace {

std::string createStatic(World& world, Random& random) {
    if (world.statics.size() >= 2) return "";
    const std::string name = world.newName("static");
    Ogre::StaticGeometry* geometry = world.manager().createStaticGeometry(name);
    geometry->setRegionDimensions(Ogre::Vector3(20));
    Ogre::Entity* cube = world.manager().createEntity(meshes(world.manager()).front());
    for (int i = 0; i < 6; ++i)
        geometry->addEntity(cube, anyPlace(random, 25), anyTurn(random));
    world.manager().destroyEntity(cube);
    geometry->setCastShadows(random.oneIn(2));
    geometry->build();
    world.statics.push_back(geometry);
    return "create " + name;
}

std::string changeStatic(World& world, Random& random) {
    Ogre::StaticGeometry** geometry = anyOf(world.statics, random);
    if (geometry == nullptr) return "";
    const std::string name = (*geometry)->getName();
    switch (random.below(6)) {
    case 0:
        (*geometry)->setVisible(random.oneIn(2));
        return "show or hide " + name;
    case 1:
        (*geometry)->setRenderingDistance(random.of({0.0f, 20.0f}));
        return "rendering distance of " + name;
    case 2:
        (*geometry)->setRenderQueueGroup(random.of<Ogre::uint8>({45, 50}));
        return "queue group of " + name;
    case 3:
        (*geometry)->setVisibilityFlags(static_cast<Ogre::uint32>(random.below(8)));
        return "visibility flags of " + name;
    case 4:
        (*geometry)->destroy();
        (*geometry)->build();
        return "build again " + name;
    default:
        world.manager().destroyStaticGeometry(*geometry);
        world.statics.erase(world.statics.begin() + (geometry - world.statics.data()));
        return "destroy " + name;
    }
}

std::string createInstances(World& world, Random&) {
    if (world.instances.size() >= 2) return "";
    const std::string name = world.newName("instances");
    world.instances.push_back(world.manager().createInstanceManager(
        name, meshes(world.manager()).front(), Ogre::RGN_DEFAULT,
        Ogre::InstanceManager::HWInstancingBasic, 4));
    return "create " + name;
}

std::string createInstance(World& world, Random& random) {
    Ogre::InstanceManager** instances = anyOf(world.instances, random);
    if (instances == nullptr || world.objects.size() > 60) return "";
    const std::string name = world.newName("instance");
    Ogre::InstancedEntity* instance =
        (*instances)->createInstancedEntity(random.oneIn(3) ? "unshadowed" : "lit");
    world.add(*instance, name);
    if (random.oneIn(5)) {
        instance->setPosition(anyPlace(random, 8)); // on no node
    } else {
        anyNode(world, random).node->attachObject(instance);
    }
    return "create " + name;
}

std::string changeInstances(World& world, Random& random) {
    Ogre::InstanceManager** instances = anyOf(world.instances, random);
    if (instances == nullptr) return "";
    const std::string name = (*instances)->getName();
    switch (random.below(4)) {
    case 0:
        (*instances)->cleanupEmptyBatches();
        return "clean up " + name;
    case 1:
        (*instances)->defragmentBatches(random.oneIn(2));
        return "defragment " + name;
    case 2:
        (*instances)->setSetting(Ogre::InstanceManager::CAST_SHADOWS, random.oneIn(2));
        return "shadows of " + name;
    default:
        if (world.isRelative) return "";
        world.hasStaticInstances = true;
        (*instances)->setBatchesAsStaticAndUpdate(random.oneIn(2));
        return "static or not " + name;
    }
}

} // namespace

void addBatchOperations(Operations& all) {
    all.insert(all.end(), {{"create static geometry", 2, createStatic},
                           {"change static geometry", 4, changeStatic},
                           {"create an instance manager", 2, createInstances},
                           {"create an instance", 8, createInstance},
                           {"change instances", 4, changeInstances}});
}

} // namespace Lixel::Tests
