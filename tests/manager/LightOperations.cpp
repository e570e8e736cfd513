// Lights, and who is lit by which.
#include "Operation.h"

#include <OgreLight.h>

namespace Lixel::Tests {
namespace {

std::string createLight(World& world, Random& random) {
    if (world.objects.size() > 60) return "";
    const std::string name = world.newName("light");
    Ogre::Light* light = world.manager().createLight(name);
    world.add(*light, name);
    light->setType(
        random.of({Ogre::Light::LT_POINT, Ogre::Light::LT_DIRECTIONAL, Ogre::Light::LT_SPOTLIGHT}));
    light->setAttenuation(random.between(2, 40), 1, 0, 0);
    light->setCastShadows(random.oneIn(2));
    NodeEntry& node = anyNode(world, random);
    node.node->attachObject(light);
    return "create " + name + " on " + node.name;
}

std::string changeLight(World& world, Random& random) {
    const Found<Ogre::Light> light = anyOfType<Ogre::Light>(world, random);
    if (!light) return "";
    switch (random.below(3)) {
    case 0:
        light->setAttenuation(random.between(2, 40), 1, 0, 0);
        return "range of " + light.name;
    case 1:
        light->setLightMask(static_cast<Ogre::uint32>(random.below(4)));
        return "mask of " + light.name;
    default:
        light->setCastShadows(random.oneIn(2));
        return "shadows of " + light.name;
    }
}

std::string maskObject(World& world, Random& random) {
    ObjectEntry* object = anyObject(world, random);
    if (object == nullptr || object->object->getMovableType() == LightTypeName) return "";
    object->object->setLightMask(static_cast<Ogre::uint32>(random.below(4)));
    return of("light mask", object->name);
}

} // namespace

void addLightOperations(Operations& all) {
    all.insert(all.end(), {{"create a light", 5, createLight},
                           {"change a light", 4, changeLight},
                           {"mask an object's lights", 3, maskObject}});
}

} // namespace Lixel::Tests
