// Billboards, chains and particles: their bounds follow what they hold. No ribbon trails: these ask
// for an update while OGRE updates the scene graph. On a node above the one that they follow, that
// spoils the list which OGRE is reading; elsewhere, their bounds are those of this frame or of the
// one before, by the addresses of nodes.
#include "Operation.h"

#include <OgreBillboard.h>
#include <OgreBillboardChain.h>
#include <OgreBillboardSet.h>
#include <OgreParticleEmitter.h>
#include <OgreParticleSystem.h>

namespace Lixel::Tests {
namespace {

bool hasRoom(const World& world) {
    return world.objects.size() <= 60;
}

std::string createBillboards(World& world, Random& random) {
    if (!hasRoom(world)) return "";
    const std::string name = world.newName("billboards");
    Ogre::BillboardSet* set = world.manager().createBillboardSet(name);
    world.add(*set, name);
    set->setMaterialName(random.oneIn(2) ? "transparent" : "lit", Ogre::RGN_DEFAULT);
    set->setDefaultDimensions(0.5f, 0.5f);
    set->setCullIndividually(random.oneIn(3));
    set->setSortingEnabled(random.oneIn(3));
    for (std::size_t i = 0; i < random.below(4); ++i)
        set->createBillboard(anyPlace(random, 3));
    anyNode(world, random).node->attachObject(set);
    return "create " + name;
}

std::string changeBillboards(World& world, Random& random) {
    const Found<Ogre::BillboardSet> set = anyOfType<Ogre::BillboardSet>(world, random);
    if (!set) return "";
    switch (set->getNumBillboards() == 0 ? 0 : random.below(4)) {
    case 0:
        set->createBillboard(anyPlace(random, 4));
        return "another of " + set.name;
    case 1:
        set->getBillboard(0)->setPosition(anyPlace(random, 6));
        set->_updateBounds();
        return "move one of " + set.name;
    case 2:
        set->removeBillboard(0u);
        set->_updateBounds();
        return "remove one of " + set.name;
    default:
        set->clear();
        return "clear " + set.name;
    }
}

void extend(Ogre::BillboardChain& chain, Random& random) {
    chain.addChainElement(0, Ogre::BillboardChain::Element(anyPlace(random, 4), 0.2f, 0,
                                                           Ogre::ColourValue::White,
                                                           Ogre::Quaternion::IDENTITY));
}

std::string createChain(World& world, Random& random) {
    if (!hasRoom(world)) return "";
    const std::string name = world.newName("chain");
    Ogre::BillboardChain* chain = world.manager().createBillboardChain(name);
    world.add(*chain, name);
    chain->setMaterialName("transparent", Ogre::RGN_DEFAULT);
    for (std::size_t i = 0; i < random.below(4); ++i)
        extend(*chain, random);
    anyNode(world, random).node->attachObject(chain);
    return "create " + name;
}

std::string changeChain(World& world, Random& random) {
    const Found<Ogre::BillboardChain> chain = anyOfType<Ogre::BillboardChain>(world, random);
    if (!chain) return "";
    if (random.oneIn(3) && chain->getNumChainElements(0) > 0) {
        chain->removeChainElement(0);
        return "shorten " + chain.name;
    }
    extend(*chain.object, random);
    return "extend " + chain.name;
}

/// One at a time: OGRE updates particle systems in the order of their addresses, and by that order
/// updates a node, and tells listeners, once or twice.
std::string createParticles(World& world, Random& random) {
    if (!hasRoom(world) || anyOfType<Ogre::ParticleSystem>(world, random)) return "";
    const std::string name = world.newName("particles");
    Ogre::ParticleSystem* system = world.manager().createParticleSystem(name, 12);
    world.add(*system, name);
    system->setMaterialName("transparent", Ogre::RGN_DEFAULT);
    system->setDefaultDimensions(0.3f, 0.3f);
    system->setKeepParticlesInLocalSpace(random.oneIn(2));
    system->setNonVisibleUpdateTimeout(random.oneIn(3) ? 0.3f : 0);
    system->setBoundsAutoUpdated(!random.oneIn(3), random.of({0.0f, 0.5f}));
    system->setIterationInterval(random.of({0.0f, 0.05f}));
    Ogre::ParticleEmitter* emitter = system->addEmitter("Point");
    emitter->setAngle(Ogre::Degree(0));
    emitter->setDirection(anyPlace(random, 1) + Ogre::Vector3(0, 1.5f, 0));
    emitter->setParticleVelocity(random.between(1, 4));
    emitter->setTimeToLive(0.8f);
    emitter->setEmissionRate(15);
    anyNode(world, random).node->attachObject(system);
    return "create " + name;
}

std::string changeParticles(World& world, Random& random) {
    const Found<Ogre::ParticleSystem> system = anyOfType<Ogre::ParticleSystem>(world, random);
    if (!system) return "";
    switch (random.below(4)) {
    case 0:
        system->setEmitting(random.oneIn(2));
        return "emission of " + system.name;
    case 1:
        system->clear();
        return "clear " + system.name;
    case 2:
        system->fastForward(0.2f);
        return "fast forward " + system.name;
    default:
        system->setSpeedFactor(random.of({0.0f, 1.0f, 2.0f}));
        return "speed of " + system.name;
    }
}

} // namespace

void addEffectOperations(Operations& all) {
    all.insert(all.end(), {{"create billboards", 4, createBillboards},
                           {"change billboards", 5, changeBillboards},
                           {"create a chain", 3, createChain},
                           {"change a chain", 3, changeChain},
                           {"create particles", 4, createParticles},
                           {"change particles", 3, changeParticles}});
}

} // namespace Lixel::Tests
