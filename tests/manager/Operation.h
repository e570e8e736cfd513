#pragma once

#include "World.h"

#include "../stress/Random.h"

#include <OgreStringConverter.h>

#include <string>
#include <vector>

namespace Lixel::Tests {

/// One thing that an application may do to a scene.
struct Operation {
    const char* name;
    /// How often, relative to the others.
    std::size_t weight;
    /// The same to both worlds: all choices follow from the world's entries and from `random`. Says
    /// what was done, empty where there was nothing to do it to.
    std::string (*perform)(World& world, Random& random);
};

using Operations = std::vector<Operation>;

void addNodeOperations(Operations& all);
void addGraphOperations(Operations& all);
void addEntityOperations(Operations& all);
void addObjectOperations(Operations& all);
void addDrawnByHandOperations(Operations& all);
void addEffectOperations(Operations& all);
void addBoneOperations(Operations& all);
void addBatchOperations(Operations& all);
void addLightOperations(Operations& all);
void addViewOperations(Operations& all);
void addSceneOperations(Operations& all);

/// Of all kinds.
const Operations& allOperations();

/// Null where there is none.
template <typename T>
T* anyOf(std::vector<T>& all, Random& random) {
    return all.empty() ? nullptr : &all[random.below(all.size())];
}

inline NodeEntry& anyNode(World& world, Random& random) {
    return world.nodes[random.below(world.nodes.size())];
}

/// Not the root; null where there is none.
inline NodeEntry* anyInnerNode(World& world, Random& random) {
    return world.nodes.size() < 2 ? nullptr
                                  : &world.nodes[1 + random.below(world.nodes.size() - 1)];
}

inline ObjectEntry* anyObject(World& world, Random& random) {
    return anyOf(world.objects, random);
}

/// An object of a class, with its name; null where there is none.
template <typename T>
struct Found {
    T* object = nullptr;
    std::string name{};
    explicit operator bool() const { return object != nullptr; }
    T* operator->() const { return object; }
};

template <typename T>
Found<T> anyOfType(World& world, Random& random) {
    std::vector<Found<T>> all;
    for (const ObjectEntry& entry : world.objects)
        if (auto* object = dynamic_cast<T*>(entry.object)) all.push_back({object, entry.name});
    return all.empty() ? Found<T>{} : all[random.below(all.size())];
}

inline Ogre::Vector3 anyPlace(Random& random, float reach) {
    const float x = random.between(-reach, reach);
    const float y = random.between(-reach, reach);
    return {x, y, random.between(-reach, reach)};
}

inline Ogre::Quaternion anyTurn(Random& random) {
    const Ogre::Degree angle(random.between(0, 360));
    return {angle, (anyPlace(random, 1) + Ogre::Vector3(0, 0, 2)).normalisedCopy()};
}

/// "what of name".
inline std::string of(const std::string& what, const std::string& name) {
    return what + " of " + name;
}

template <typename T>
std::string say(const T& value) {
    return Ogre::StringConverter::toString(value);
}

} // namespace Lixel::Tests
