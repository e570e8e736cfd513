// What happens to lights and to the setups of their shadow cameras.

#include "LightDeeds.h"

#include <Lixel/scene/OgreVersions.h>

#include <limits>

namespace Lixel::Tests {
namespace {

constexpr std::size_t MostSetups = 12;

/// A node of the light's own, at the root.
Ogre::SceneNode& nodeOf(World& world, Ogre::Light& light) {
    if (light.getParentNode() == nullptr)
        world.manager->getRootSceneNode()->createChildSceneNode()->attachObject(&light);
    return *light.getParentSceneNode();
}

std::string createLight(Application& application, World& world, Random& random) {
    // Sometimes under a name that was given before.
    const bool again = random.oneIn(3) && !world.manager->hasLight("Again");
    Lamp* const lamp = application.addLamp(world, again ? "Again" : application.newName("Light"));
    if (lamp == nullptr) return {};
    if (UsedSetup* const used = anyOf(application.setups, random); used != nullptr)
        application.setUp(*lamp, *used);
    return lamp->light->getName();
}

std::string destroyLight(Application&, World& world, Random& random) {
    Lamp* const lamp = anyOf(world.lamps, random);
    if (lamp == nullptr) return {};
    std::string name = lamp->light->getName();
    world.manager->destroyLight(lamp->light);
    world.lamps.erase(world.lamps.begin() + (lamp - world.lamps.data()));
    return name;
}

std::string moveLight(Application&, World& world, Random& random) {
    Lamp* const lamp = anyOf(world.lamps, random);
    if (lamp == nullptr) return {};
    Ogre::SceneNode& node = nodeOf(world, *lamp->light);
    const Ogre::Vector3 place = anyPlace(random, 8, 1.5F, 12);
    node.setPosition(place);
    const Ogre::Vector3 aim =
        random.oneIn(6) ? Ogre::Vector3(0, -1, 0) : anyPlace(random, 3, 0, 1) - place;
    node.setDirection(aim, Ogre::Node::TS_WORLD);
    return lamp->light->getName() + " to " + text(place) + " towards " + text(aim);
}

std::string changeType(Application&, World& world, Random& random) {
    Lamp* const lamp = anyOf(world.lamps, random);
    if (lamp == nullptr) return {};
    Ogre::Light& light = *lamp->light;
    light.setType(
        random.of({Ogre::Light::LT_DIRECTIONAL, Ogre::Light::LT_SPOTLIGHT, Ogre::Light::LT_POINT}));
    // OGRE lights nothing of a large ground by a spot of 5 degrees, as it judges reach by spheres.
    const float outer = random.of({20.0F, 60.0F, 90.0F, 150.0F, 178.0F});
    light.setSpotlightRange(Ogre::Degree(0.8F * outer), Ogre::Degree(outer), 0.01F);
    return light.getName() + " is of type " + std::to_string(light.getType()) + ", " +
           std::to_string(outer) + " degrees wide";
}

std::string setReach(Application&, World& world, Random& random) {
    Lamp* const lamp = anyOf(world.lamps, random);
    if (lamp == nullptr) return {};
    Ogre::Light& light = *lamp->light;
    switch (random.below(3)) {
    case 0:
        light.setAttenuation(random.of({0.01F, 10.0F, 30.0F, 1000.0F, 1000.0F}), 1, 0, 0);
        return light.getName() + " attenuation " + std::to_string(light.getAttenuationRange());
    case 1:
        if (random.oneIn(2))
            light.resetShadowFarDistance();
        else
            light.setShadowFarDistance(random.of({0.0F, 12.0F, 40.0F}));
        return light.getName() + " shadow far distance";
    default:
        light.setShadowNearClipDistance(random.of({0.01F, 0.05F, 0.1F}));
        return light.getName() + " shadow near distance";
    }
}

std::string spoil(Application& application, World& world, Random& random) {
    Lamp* const lamp = anyOf(world.lamps, random);
    if (lamp == nullptr) return {};
    constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
    // Without the plugin, OGRE ends on lights that are not finite; a node's direction aborts in OGRE
    // itself.
    const bool bad = random.oneIn(3) && application.pluginLoaded && LightsHaveDirections;
    nodeOf(world, *lamp->light);
    setOwnDirection(*lamp->light,
                    bad ? Ogre::Vector3(NaN, 0, NaN) : Ogre::Vector3::NEGATIVE_UNIT_Z);
    return lamp->light->getName() + (bad ? " has no direction" : " has its direction again");
}

std::string setLightFlags(Application&, World& world, Random& random) {
    Lamp* const lamp = anyOf(world.lamps, random);
    if (lamp == nullptr) return {};
    Ogre::Light& light = *lamp->light;
    if (random.oneIn(2)) {
        light.setCastShadows(!random.oneIn(4));
        return light.getName() + " casts shadows or not";
    }
    light.setVisible(!random.oneIn(4));
    return light.getName() + " shines or not";
}

std::string carry(Application&, World& world, Random& random) {
    Lamp* const lamp = anyOf(world.lamps, random);
    Ogre::Entity* const body = anyBody(world, random);
    if (lamp == nullptr || body == nullptr || body->getParentNode() == nullptr) return {};
    lamp->light->detachFromParent();
    body->getParentSceneNode()->attachObject(lamp->light);
    return lamp->light->getName() + " by " + body->getName();
}

std::string makeSetup(Application& application, World&, Random& random) {
    const auto recipe =
        std::make_shared<SetupRecipe>(SetupRecipe{random.next() >> 8U, random.next()});
    if (application.setups.size() == MostSetups)
        application.setups.erase(application.setups.begin());
    application.setups.push_back({recipe->make(), recipe});
    return recipe->name();
}

std::string useSetup(Application& application, World& world, Random& random) {
    Lamp* const lamp = anyOf(world.lamps, random);
    UsedSetup* const used = anyOf(application.setups, random);
    if (lamp == nullptr || used == nullptr) return {};
    if (random.oneIn(6)) {
        application.setUp(*lamp, {});
        return "none for " + lamp->light->getName();
    }
    application.setUp(*lamp, *used);
    return used->recipe->name() + " for " + lamp->light->getName();
}

std::string useSetupForAll(Application& application, World& world, Random& random) {
    UsedSetup* const used = anyOf(application.setups, random);
    if (used == nullptr || random.oneIn(5)) {
        application.setUp(world, UsedSetup{});
        return "OGRE's own for all of " + world.manager->getName();
    }
    application.setUp(world, *used);
    return used->recipe->name() + " for all of " + world.manager->getName();
}

std::string turnOptions(Application& application, World&, Random& random) {
    UsedSetup* const used = anyOf(application.setups, random);
    if (used == nullptr) return {};
    used->recipe->options = random.next();
    used->recipe->apply(*used->setup);
    return used->recipe->name();
}

std::string release(Application& application, World&, Random& random) {
    UsedSetup* const used = anyOf(application.setups, random);
    if (used == nullptr || application.setups.size() < 3) return {};
    std::string name = used->recipe->name();
    application.setups.erase(application.setups.begin() + (used - application.setups.data()));
    return name;
}

} // namespace

const std::vector<Deed>& lightDeeds() {
    static const std::vector<Deed> deeds{
        {"create light", 9, createLight},
        {"destroy light", 4, destroyLight},
        {"move light", 14, moveLight},
        {"type of light", 6, changeType},
        {"reach of light", 5, setReach},
        {"NaN light", 5, spoil},
        {"flags of light", 4, setLightFlags},
        {"carry light", 1, carry},
        {"make setup", 8, makeSetup},
        {"use setup", 9, useSetup},
        {"use setup for all", 3, useSetupForAll},
        {"options of setup", 5, turnOptions},
        {"release setup", 3, release},
    };
    return deeds;
}

} // namespace Lixel::Tests
