// Entities, their parts, materials and meshes.
#include "Operation.h"

#include "Materials.h"
#include "Meshes.h"

#include <OgreEntity.h>
#include <OgreMaterialManager.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreSubEntity.h>

namespace Lixel::Tests {
namespace {

constexpr std::size_t MostObjects = 60;

std::string createEntity(World& world, Random& random) {
    if (world.objects.size() >= MostObjects) return "";
    const std::vector<std::string>& all = meshes(world.manager());
    const std::string mesh = all[random.below(all.size())];
    if (mesh == InfiniteMesh) {
        if (world.drawsBoxes || !random.oneIn(4)) return "";
        world.hasInfinite = true;
    }
    const std::string name = world.newName(mesh);
    Ogre::Entity* entity = world.manager().createEntity(name, mesh);
    world.add(*entity, name);
    if (random.oneIn(2)) entity->setMaterialName(materials()[random.below(materials().size())]);
    NodeEntry& node = anyNode(world, random);
    node.node->attachObject(entity);
    return "create " + name + " on " + node.name;
}

/// As applications mostly do it: one on a node of its own.
std::string createEntityOnNode(World& world, Random& random) {
    if (world.objects.size() >= MostObjects) return "";
    const std::string name = world.newName("cube");
    Ogre::SceneNode* node = world.rootNode().createChildSceneNode(anyPlace(random, 15));
    world.add(*node, "node of " + name);
    Ogre::Entity* entity = world.manager().createEntity(name, meshes(world.manager()).front());
    world.add(*entity, name);
    node->attachObject(entity);
    return "create " + name + " on a node of its own";
}

std::string cloneEntity(World& world, Random& random) {
    const Found<Ogre::Entity> entity = anyOfType<Ogre::Entity>(world, random);
    if (!entity || world.objects.size() >= MostObjects) return "";
    const std::string name = world.newName("clone");
    Ogre::Entity* clone = entity->clone(name);
    world.add(*clone, name);
    anyNode(world, random).node->attachObject(clone);
    return "clone " + entity.name;
}

std::string setMaterial(World& world, Random& random) {
    const Found<Ogre::Entity> entity = anyOfType<Ogre::Entity>(world, random);
    if (!entity) return "";
    const std::string& material = materials()[random.below(materials().size())];
    if (random.oneIn(2))
        entity->setMaterialName(material);
    else
        entity->getSubEntity(random.below(entity->getNumSubEntities()))->setMaterialName(material);
    return of("material", entity.name) + " " + material;
}

std::string showPart(World& world, Random& random) {
    const Found<Ogre::Entity> entity = anyOfType<Ogre::Entity>(world, random);
    if (!entity) return "";
    const std::size_t part = random.below(entity->getNumSubEntities());
    entity->getSubEntity(part)->setVisible(random.oneIn(2));
    return "show or hide a part of " + entity.name;
}

std::string queuePart(World& world, Random& random) {
    const Found<Ogre::Entity> entity = anyOfType<Ogre::Entity>(world, random);
    if (!entity) return "";
    Ogre::SubEntity* part = entity->getSubEntity(random.below(entity->getNumSubEntities()));
    const Ogre::uint8 group = random.of<Ogre::uint8>({10, 50, 60});
    if (random.oneIn(2))
        part->setRenderQueueGroup(group);
    else
        part->setRenderQueueGroupAndPriority(group, random.of<Ogre::ushort>({90, 110}));
    return "queue group of a part of " + entity.name;
}

/// A finest level is only asked for where there are several: OGRE takes it for the level of meshes
/// that have one.
std::string biasLevels(World& world, Random& random) {
    const Found<Ogre::Entity> entity = anyOfType<Ogre::Entity>(world, random);
    if (!entity) return "";
    const float factor = random.of({0.3f, 1.0f, 3.0f});
    const bool hasLevels = entity->getMesh()->getNumLodLevels() > 1;
    if (random.oneIn(2))
        entity->setMeshLodBias(factor, hasLevels ? random.of<Ogre::ushort>({0, 1}) : 0);
    else
        entity->setMaterialLodBias(factor);
    return "level of detail of " + entity.name;
}

std::string setMaterialsShadows(World&, Random& random) {
    const std::string& name = materials()[random.below(materials().size())];
    const bool receives = random.oneIn(2);
    Ogre::MaterialManager::getSingleton()
        .getByName(name, Ogre::RGN_DEFAULT)
        ->setReceiveShadows(receives);
    return name + (receives ? " receives" : " receives nothing");
}

std::string reloadMesh(World&, Random&) {
    Ogre::MeshManager::getSingleton().getByName(ReloadedMesh, Ogre::RGN_DEFAULT)->reload();
    return "reload";
}

/// Those who do it have the entities' nodes updated: OGRE does not.
std::string changeBounds(World& world, Random& random) {
    const float half = random.of({0.5f, 0.5f, 3.0f});
    const Ogre::MeshPtr mesh =
        Ogre::MeshManager::getSingleton().getByName(ChangingMesh, Ogre::RGN_DEFAULT);
    mesh->_setBounds({-half, -half, -half, half, half, half}, false);
    for (const ObjectEntry& entry : world.objects)
        if (auto* entity = dynamic_cast<Ogre::Entity*>(entry.object);
            entity != nullptr && entity->getMesh() == mesh && entity->isInScene())
            entity->getParentSceneNode()->needUpdate();
    return of("bounds", ChangingMesh) + " " + say(half);
}

} // namespace

void addEntityOperations(Operations& all) {
    all.insert(all.end(), {{"create an entity", 14, createEntity},
                           {"create an entity on a node", 10, createEntityOnNode},
                           {"clone an entity", 2, cloneEntity},
                           {"set an entity's material", 6, setMaterial},
                           {"show an entity's part", 4, showPart},
                           {"queue an entity's part", 3, queuePart},
                           {"bias an entity's levels", 3, biasLevels},
                           {"change a material", 2, setMaterialsShadows},
                           {"reload a mesh", 1, reloadMesh},
                           {"change a mesh's bounds", 3, changeBounds}});
}

} // namespace Lixel::Tests
