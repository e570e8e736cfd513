// Entities with bones, and what hangs on these.
#include "Operation.h"

#include "Meshes.h"

#include <OgreAnimationState.h>
#include <OgreBone.h>
#include <OgreEntity.h>
#include <OgreInstancedEntity.h>
#include <OgreSkeletonInstance.h>
#include <OgreTagPoint.h>

namespace Lixel::Tests {
namespace {

Found<Ogre::Entity> anyJointed(World& world, Random& random) {
    std::vector<Found<Ogre::Entity>> all;
    for (const ObjectEntry& entry : world.objects)
        if (auto* entity = dynamic_cast<Ogre::Entity*>(entry.object);
            entity != nullptr && entity->hasSkeleton())
            all.push_back({entity, entry.name});
    return all.empty() ? Found<Ogre::Entity>{} : all[random.below(all.size())];
}

std::string createJointed(World& world, Random& random) {
    if (world.objects.size() > 60) return "";
    meshes(world.manager());
    const std::string name = world.newName("jointed");
    Ogre::Entity* entity = world.manager().createEntity(name, JointedMesh);
    world.add(*entity, name);
    anyNode(world, random).node->attachObject(entity);
    return "create " + name;
}

std::string animate(World& world, Random& random) {
    const Found<Ogre::Entity> entity = anyJointed(world, random);
    if (!entity) return "";
    Ogre::AnimationState* state = entity->getAnimationState("bend");
    state->setEnabled(!random.oneIn(4));
    state->setTimePosition(random.between(0, 1));
    return "animate " + entity.name;
}

std::string poseByHand(World& world, Random& random) {
    const Found<Ogre::Entity> entity = anyJointed(world, random);
    if (!entity) return "";
    Ogre::Bone* head = entity->getSkeleton()->getBone(1);
    head->setManuallyControlled(true);
    head->setOrientation(anyTurn(random));
    head->setScale(Ogre::Vector3(random.of({0.5f, 1.0f, 2.0f})));
    return "pose " + entity.name;
}

std::string hangOnBone(World& world, Random& random) {
    const Found<Ogre::Entity> entity = anyJointed(world, random);
    ObjectEntry* object = anyObject(world, random);
    if (!entity || object->object == entity.object || object->object->isAttached()) return "";
    // OGRE aborts when it frees a tag point of bones that are shared no more, or an instance's.
    if (entity->sharesSkeletonInstance()) return "";
    if (dynamic_cast<Ogre::InstancedEntity*>(object->object) != nullptr) return "";
    // OGRE keeps no account of who hangs on whom; in a ring they would ask each other for ever.
    if (auto* other = dynamic_cast<Ogre::Entity*>(object->object);
        other != nullptr && other->hasSkeleton())
        return "";
    entity->attachObjectToBone("foot", object->object, anyTurn(random), anyPlace(random, 2));
    return "hang " + object->name + " on a bone of " + entity.name;
}

std::string takeOffBones(World& world, Random& random) {
    const Found<Ogre::Entity> entity = anyJointed(world, random);
    if (!entity) return "";
    entity->detachAllObjectsFromBone();
    return "take all off the bones of " + entity.name;
}

std::string boundByBones(World& world, Random& random) {
    const Found<Ogre::Entity> entity = anyJointed(world, random);
    if (!entity) return "";
    entity->setUpdateBoundingBoxFromSkeleton(random.oneIn(2));
    return "bounds by the bones of " + entity.name;
}

std::string shareBones(World& world, Random& random) {
    const Found<Ogre::Entity> entity = anyJointed(world, random);
    const Found<Ogre::Entity> other = anyJointed(world, random);
    if (!entity || entity.object == other.object) return "";
    if (!entity->getAttachedObjects().empty() || !other->getAttachedObjects().empty()) return "";
    if (entity->sharesSkeletonInstance()) {
        entity->stopSharingSkeletonInstance();
        return "stop sharing the bones of " + entity.name;
    }
    if (other->sharesSkeletonInstance()) return "";
    entity->shareSkeletonInstanceWith(other.object);
    return entity.name + " shares the bones of " + other.name;
}

std::string drawBones(World& world, Random& random) {
    const Found<Ogre::Entity> entity = anyJointed(world, random);
    if (!entity) return "";
    entity->setDisplaySkeleton(random.oneIn(2));
    return "draw the bones of " + entity.name;
}

} // namespace

void addBoneOperations(Operations& all) {
    all.insert(all.end(), {{"create a jointed entity", 5, createJointed},
                           {"animate an entity", 5, animate},
                           {"pose an entity", 3, poseByHand},
                           {"hang an object on a bone", 30, hangOnBone},
                           {"take all off the bones", 2, takeOffBones},
                           {"bound an entity by its bones", 2, boundByBones},
                           {"share bones", 8, shareBones},
                           {"draw bones", 2, drawBones}});
}

} // namespace Lixel::Tests
