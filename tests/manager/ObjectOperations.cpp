// What an application does to objects of any kind.
#include "Operation.h"

#include "Probe.h"

#include <OgreInstancedEntity.h>

namespace Lixel::Tests {
namespace {

/// A batch draws an instance by what the camera that was told to it last made of it: this one, or
/// the one before if OGRE comes to the batch first. So there is nothing to compare where that
/// matters, for distances and listeners.
bool isInstance(const ObjectEntry& entry) {
    return dynamic_cast<const Ogre::InstancedEntity*>(entry.object) != nullptr;
}

std::string attachObject(World& world, Random& random) {
    ObjectEntry* object = anyObject(world, random);
    if (object == nullptr) return "";
    NodeEntry& node = anyNode(world, random);
    object->object->detachFromParent();
    node.node->attachObject(object->object);
    return "attach " + object->name + " to " + node.name;
}

std::string detachObject(World& world, Random& random) {
    ObjectEntry* object = anyObject(world, random);
    if (object == nullptr || !object->object->isAttached()) return "";
    if (random.oneIn(5) && !object->object->isParentTagPoint()) {
        object->object->getParentSceneNode()->detachAllObjects();
        return "detach all beside " + object->name;
    }
    object->object->detachFromParent();
    return "detach " + object->name;
}

std::string destroyObject(World& world, Random& random) {
    ObjectEntry* entry = anyObject(world, random);
    if (entry == nullptr) return "";
    const ObjectEntry object = *entry;
    world.forget(*object.object);
    if (isInstance(object))
        world.manager().destroyInstancedEntity(static_cast<Ogre::InstancedEntity*>(object.object));
    else
        world.manager().destroyMovableObject(object.object);
    return "destroy " + object.name;
}

std::string showObject(World& world, Random& random) {
    ObjectEntry* object = anyObject(world, random);
    if (object == nullptr) return "";
    const bool shows = !random.oneIn(3);
    object->object->setVisible(shows);
    return (shows ? "show " : "hide ") + object->name;
}

std::string setFlags(World& world, Random& random) {
    ObjectEntry* object = anyObject(world, random);
    if (object == nullptr) return "";
    const auto flags = static_cast<Ogre::uint32>(random.below(8));
    if (random.oneIn(4)) {
        object->object->setQueryFlags(flags);
        return of("query flags", object->name) + " " + std::to_string(flags);
    }
    object->object->setVisibilityFlags(flags);
    return of("visibility flags", object->name) + " " + std::to_string(flags);
}

std::string setDistance(World& world, Random& random) {
    ObjectEntry* object = anyObject(world, random);
    if (object == nullptr || isInstance(*object)) return "";
    const float distance = random.of({0.0f, 5.0f, 12.0f, 25.0f});
    if (random.oneIn(3)) {
        object->object->setRenderingMinPixelSize(distance / 10);
        return "pixel size of " + object->name;
    }
    object->object->setRenderingDistance(distance);
    return of("rendering distance", object->name) + " " + say(distance);
}

std::string setQueueGroup(World& world, Random& random) {
    ObjectEntry* object = anyObject(world, random);
    if (object == nullptr) return "";
    const Ogre::uint8 group = random.of<Ogre::uint8>({5, 50, 50, 52, 90});
    if (random.oneIn(2)) {
        const Ogre::ushort priority = random.of<Ogre::ushort>({77, 99, 100, 200});
        object->object->setRenderQueueGroupAndPriority(group, priority);
        return "queue group and priority of " + object->name;
    }
    object->object->setRenderQueueGroup(group);
    return "queue group of " + object->name;
}

std::string castShadows(World& world, Random& random) {
    ObjectEntry* object = anyObject(world, random);
    if (object == nullptr) return "";
    const bool casts = random.oneIn(2);
    object->object->setCastShadows(casts);
    return object->name + (casts ? " casts" : " casts nothing");
}

std::string listenToObject(World& world, Random& random) {
    ObjectEntry* object = anyObject(world, random);
    if (object == nullptr || isInstance(*object)) return "";
    const bool listens = random.oneIn(2);
    object->object->setListener(listens ? &world.heard : nullptr);
    return (listens ? "listen to " : "do not listen to ") + object->name;
}

Ogre::AxisAlignedBox anyBox(World& world, Random& random) {
    switch (random.below(6)) {
    case 0:
        return {};
    case 1:
        if (world.drawsBoxes) return {};
        world.hasInfinite = true;
        return Ogre::AxisAlignedBox::BOX_INFINITE;
    default:
        const Ogre::Vector3 corner = anyPlace(random, 4);
        return {corner, corner + Ogre::Vector3(random.between(0, 3), 1, random.between(0, 2))};
    }
}

std::string createProbe(World& world, Random& random) {
    if (world.objects.size() > 60) return "";
    const std::string name = world.newName("probe");
    auto* probe = static_cast<Probe*>(world.manager().createMovableObject(name, ProbeType));
    probe->setBox(anyBox(world, random));
    world.add(*probe, name);
    anyNode(world, random).node->attachObject(probe);
    return "create " + name;
}

std::string changeProbe(World& world, Random& random) {
    const Found<Probe> probe = anyOfType<Probe>(world, random);
    if (!probe) return "";
    probe->setBox(anyBox(world, random));
    return "another box of " + probe.name;
}

} // namespace

void addObjectOperations(Operations& all) {
    all.insert(all.end(), {{"attach an object", 10, attachObject},
                           {"detach an object", 5, detachObject},
                           {"destroy an object", 4, destroyObject},
                           {"show an object", 4, showObject},
                           {"set an object's flags", 5, setFlags},
                           {"set an object's distance", 5, setDistance},
                           {"set an object's queue", 5, setQueueGroup},
                           {"cast shadows", 4, castShadows},
                           {"listen to an object", 5, listenToObject},
                           {"create a probe", 3, createProbe},
                           {"change a probe", 4, changeProbe}});
}

} // namespace Lixel::Tests
